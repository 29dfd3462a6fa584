import { expect, test } from 'vitest'
import type { Closure, Step } from '../../src/api/types'
import { missesOf } from '../../src/repair/errors'
import { errorsToTry, leakAt, marginOf, type Sample, varied, wordsOf } from '../../src/repair/tolerance'
import { distance } from '../../src/viewer/geometry'
import { pyramid } from './scenes'

const rings = { rings: [], sizes_mm: { min: 24, max: 40, step: 2 } }
const sample = (errors: number[], leak_mm2: number | null): Sample => ({ errors, leak_mm2, error_mm2: 0.5 })
/// Leaks as many square millimetres as it is millimetres off.
const cone = (errors: number[]): Sample => sample(errors, Math.hypot(...errors))
const closed = (leak_mm2: number) =>
  ({ leak_mm2, status: 'converged', crossing: false, leak: { error_mm2: 0.5 } }) as unknown as Closure
const measured = { annulus: { al_pm_mm: 20, circumference_mm: 56.6 } } as Closure
const valve = { ...pyramid(), closure: measured }
const anatomy = { before: valve, ringed: valve }
const ring: Step = { step: 'annuloplasty', shape: 'own', sizes_below: 1 }

test('the margin of a leak that grows with the error is where it reaches the limit', () => {
  const errors = [
    [1, 0],
    [-1, 0],
    [3, 0],
    [-3, 0],
  ]
  expect(marginOf([cone([0, 0]), ...errors.map(cone)], 2)?.mm).toBeCloseTo(2)
  expect(marginOf([cone([0, 0]), ...errors.map(cone)], 2)?.isMore).toBe(false)
})

test('as far as was tried is a least margin; of what leaks as planned there is none', () => {
  const all = [[0], [1], [-1], [2]].map(cone)
  expect(marginOf(all, 5)).toEqual({ mm: 1, isMore: true }) // to one side it was tried no farther
  expect(marginOf(all, -1)).toBeNull()
})

test('a closure that is unreliable counts as not tried', () => {
  expect(marginOf([cone([0]), cone([1]), sample([2], null), sample([3], 9)], 5)).toEqual({ mm: 1, isMore: true })
})

test('near errors on the axes are tried first, those between the ways last', () => {
  const misses = missesOf(
    { step: 'neochorda', head: 'AL1', insertion: { leaflet: 'anterior', along: 0.6, height: 0.4 }, length_mm: 20 },
    0,
    anatomy,
    rings,
  )
  const errors = misses ? errorsToTry(misses) : []
  expect(errors.slice(0, 6).map((parts) => Math.hypot(...parts))).toEqual([1, 1, 1, 1, 1, 1])
  expect(errors).toHaveLength(3 * 2 * 3 + 3 * 4)
})

test('a ring misses by sizes, as far as there are rings', () => {
  const misses = missesOf(ring, 0, anatomy, rings)
  expect(misses?.stepAt([2])).toEqual({ ...ring, sizes_below: 0 })
  expect(misses?.stepAt([4])).toBeNull()
  expect(misses?.stepAt([-4])).toEqual({ ...ring, sizes_below: 3 })
})

test('a suture that would push is no suture', () => {
  const step: Step = {
    step: 'papillary_approximation',
    side: 'anterolateral',
    anchor: 'saddle_peak',
    suture_length_mm: 12,
  }
  const misses = missesOf(step, 0, anatomy, rings)
  expect(misses?.stepAt([-1, 0])).toMatchObject({ suture_length_mm: 11, anchor: 'saddle_peak' })
  expect(misses?.stepAt([-1, 2])).toMatchObject({ suture_length_mm: 11, anchor: 'annulus_point' })
  expect(misses?.stepAt([200, 0])).toBeNull()
})

test('a stitch a millimetre off is a millimetre off', () => {
  const step: Step = {
    step: 'neochorda',
    head: 'AL1',
    insertion: { leaflet: 'anterior', along: 0.6, height: 0.4 },
    length_mm: 20,
  }
  const misses = missesOf(step, 0, anatomy, rings)
  const [planned, beside] = [misses?.placeAt([0, 0, 0]), misses?.placeAt([0.5, 0, 0])]
  expect(planned && beside && distance(planned, beside)).toBeCloseTo(0.5, 1)
})

test('the valve is closed with each error, and told as it goes; who stops it hears no more', async () => {
  const misses = missesOf(ring, 0, anatomy, rings)
  if (!misses) throw new Error('a ring can miss')
  const told: number[] = []
  const abort = new AbortController()
  const how = { atOnce: 2, signal: abort.signal }
  const close = (step: Step) =>
    Promise.resolve(closed('sizes_below' in step && step.step === 'annuloplasty' ? 3 * step.sizes_below : 0))
  let words: ReturnType<typeof wordsOf> = null
  await varied(
    misses,
    sample([0], 3),
    close,
    (known) => {
      told.push(known.samples.length)
      words = wordsOf(known, misses, 5)
    },
    how,
  )
  expect(told[0]).toBe(1)
  expect(told.at(-1)).toBe(1 + 4) // 0, 2, 3 and 4 sizes below
  expect(words).toMatchObject({ margin: '1.3 mm', leak_off: '6.0 ± 0.5 mm²' })
  abort.abort()
  await varied(misses, sample([0], 3), close, () => told.push(-1), how)
  expect(told.filter((count) => count < 0)).toHaveLength(1)
})

test('between what was tried the nearer counts more, and a length says nothing of a place', () => {
  const samples = [sample([0, 0, 0], 0), sample([1, 0, 0], 4), sample([0, 0, 1], 100)]
  expect(leakAt(samples, [1, 0])).toBe(4)
  expect(leakAt(samples, [0.5, 0])).toBeCloseTo(2)
  expect(leakAt([sample([0, 0], null)], [0, 0])).toBeNull()
})
