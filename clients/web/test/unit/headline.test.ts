import { expect, test } from 'vitest'
import { CERTAINTIES } from '../../src/api/calls'
import type { Information, Measure } from '../../src/api/types'
import { leakWords } from '../../src/valve/headline'
import { narrowingWords } from '../../src/valve/information'
import { certaintyWords, tradeWords } from '../../src/valve/certainty'

const leaking = (area_mm2: number, error_mm2: number) =>
  ({ leak_mm2: area_mm2, leak: { area_mm2, error_mm2, openings: [] } }) as unknown as Measure
const drawn = (tissue: number[] | null, share_removed = 0.78) =>
  ({
    leak: { tissue },
    rows: [{ measurement: 'widest gap to 0.5 mm', share_removed, remaining_mm2: 7 }],
  }) as unknown as Information

test('the leak carries the wider of its errors', () => {
  const valve = leaking(58, 6)
  const large = (information: Information | null) => leakWords(valve, undefined, information?.leak.tissue)
  expect(large(null)).toBe('58 ± 6 mm²')
  expect(large(drawn([33.4, 95.2]))).toBe('58 mm² (33 to 95)')
  expect(large(drawn([55, 60]))).toBe('58 ± 6 mm²')
  expect(large(drawn(null))).toBe('58 ± 6 mm²')
  expect(large(drawn([21.2, 37.4]))).toBe('21 to 37 mm²')
  expect(large(drawn([21.2, 27.4]))).toBe('21.2 to 27.4 mm²')
})

test('a repaired leak has the range of the repaired valve', () => {
  expect(leakWords(leaking(58, 6), leaking(2.13, 0.4), [0.2, 7.4])).toBe('58 → 2 mm² (0 to 7)')
})

test('what narrows the range is named where it tells much', () => {
  expect(narrowingWords(drawn([33, 95]))).toBe('To narrow it, measure first: widest gap to 0.5 mm')
  expect(narrowingWords(drawn([33, 95], 0.1))).toBe('What would narrow it')
  expect(narrowingWords({ rows: [] })).toBe('What would narrow it')
})

test('each choice says what it will take and leave, and then what it took and left', () => {
  const level = (triangles: number, leak_mm2: number, seconds: number) => ({ triangles, leak_mm2, seconds })
  const closure = { ...leaking(58, 5.7), seconds: 0.04, triangles: 648 } as Parameters<typeof certaintyWords>[0]
  expect(CERTAINTIES.map((choice) => tradeWords(choice, closure))).toEqual([
    'about 0.04 s, ± 6 mm²',
    'about 0.20 s, ± 2.5 mm²',
    'about 0.80 s, ± 1.1 mm²',
  ])
  expect(tradeWords('proof', { ...closure, leak: { ...closure.leak, error_mm2: null } })).toBe('about 0.80 s')
  expect(certaintyWords(closure)).toBe('The leak is 58 ± 6 mm² (on 648 triangles, in 0.04 s).')
  const levels = [level(648, 58.12, 0.1), level(2592, 57.64, 1.42)]
  const settled = { levels, stop: 'settled', leak_error_mm2: 0.48, other_end_mm2: 0.1 }
  const convergence = settled as NonNullable<typeof closure.convergence>
  expect(certaintyWords({ ...closure, convergence })).toBe(
    'The leak is 57.6 ± 0.5 mm² (58.1 and 57.6 on 648 and 2,592 triangles, in 0.10 and 1.4 s). It has converged.',
  )
  expect(certaintyWords({ ...closure, convergence: { ...convergence, other_end_mm2: 17.2 } })).toContain(
    'It has converged. Closed at half the speed, the first mesh leaks 17.2 mm² more.',
  )
})
