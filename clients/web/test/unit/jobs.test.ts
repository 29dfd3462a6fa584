import { expect, test } from 'vitest'
import type { JobProgress } from '../../src/api/types'
import { Pace } from '../../src/jobs/pace'
import { endedSeries, liveSeries } from '../../src/search/cost_chart'

function progress(stage: string, closures: number, seconds: number, more: Partial<JobProgress> = {}): JobProgress {
  return {
    stage,
    closures,
    closures_planned: 100,
    best_leak_mm2: null,
    best_cost: null,
    random_cost: null,
    seconds,
    ...more,
  }
}

test('what is left goes by the pace of the stage', () => {
  const pace = new Pace()
  expect(pace.left(progress('searching', 0, 1))).toBeNull()
  expect(pace.left(progress('searching', 20, 3))).toBe(8) // 10 a second, 80 left
  expect(pace.left(progress('ranking', 40, 5))).toBeNull() // a stage has a pace of its own
  expect(pace.left(progress('ranking', 50, 15))).toBe(50)
})

test('known closures at the start say nothing of the pace', () => {
  const pace = new Pace()
  expect(pace.left(progress('searching', 60, 0))).toBeNull()
  expect(pace.left(progress('searching', 70, 5))).toBe(15)
})

test('a stage that begins again has a new pace', () => {
  const pace = new Pace()
  pace.left(progress('ring', 90, 9))
  expect(pace.left(progress('ring', 0, 10))).toBeNull()
  expect(pace.left(progress('ring', 50, 20))).toBe(10)
})

test('the live curves hold what is known, once for each number of closures', () => {
  const [ours, random] = liveSeries([
    progress('searching', 1, 1),
    progress('searching', 9, 2, { best_cost: 5 }),
    progress('searching', 9, 3, { best_cost: 4, random_cost: 8 }),
  ])
  expect(ours).toMatchObject({ x: [9], y: [4] })
  expect(random).toMatchObject({ x: [9], y: [8] })
})

test('a service that does not tell costs gives no curve', () => {
  const { best_cost: _, random_cost: __, ...older } = progress('searching', 9, 2)
  expect(liveSeries([older as JobProgress]).every((one) => one.x.length === 0)).toBe(true)
})

test('a short search has no curve of random search', () => {
  expect(endedSeries([{ closures: 9, cost: 2 }], []).map(({ label }) => label)).toEqual(['coapt'])
})
