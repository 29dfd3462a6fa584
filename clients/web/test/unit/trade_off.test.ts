import { expect, test } from 'vitest'
import { axisOf, placeOn } from '../../src/charts/scatter_axes'
import { lacking, tradePoints, tradeSummary } from '../../src/search/trade_off'
import type { FrontPlan, RankedPlan, SearchResult } from '../../src/api/types'
import { frontRows } from '../../src/search/front'
import { frontPlanOf, planOf, ringOf } from './plans'

const resultOf = (plans: RankedPlan[], before: object = {}, pareto_front: FrontPlan[] = []) =>
  ({
    plans,
    pareto_front,
    before: { leak_mm2: 33.6, opening_area_mm2: 374, ...before },
  }) as unknown as SearchResult

const PLANS = [
  planOf({ rank: 1, mean: 0.25, opening_mm2: 290, durability_mm: 12, pareto: true }),
  planOf({ rank: 2, mean: 1.05, opening_mm2: 400, durability_mm: 5.9, pareto: true }),
  planOf({ rank: 3, mean: 0.75, opening_mm2: 300, durability_mm: null }),
]

test('a point has mean + sd of the leak, the smaller opening in cm2, and a level of two millimetres each', () => {
  const [first, second, third, before] = tradePoints(resultOf(PLANS))
  expect(first).toEqual({
    x: 0.5,
    y: 2.9,
    name: '1',
    words: 'Plan 1: leak 0.5 mm² (mean + sd), opening 2.9 cm², reserve 12.0 mm or more, Pareto-optimal.',
    level: 5,
    isRinged: true,
    isSmall: false,
  })
  expect(second?.level).toBe(2)
  expect(third).toMatchObject({
    level: null,
    isRinged: false,
    words: 'Plan 3: leak 1.0 mm² (mean + sd), opening 3.0 cm².',
  })
  expect(before).toMatchObject({ x: 33.6, y: 3.74, name: 'before', level: 'aside' })
})

test('of the Pareto front the plans that are not ranked have letters, in the order of their rows', () => {
  const plans = [planOf({ rank: 1, plan: ringOf(30) }), planOf({ rank: 2, plan: ringOf(32) })]
  const namesOf = (sizes: number[]) => {
    const pareto_front = sizes.map((size) => frontPlanOf(ringOf(size)))
    return frontRows({ plans, pareto_front }).map(({ name }) => name)
  }
  expect(namesOf([34, 32, 36])).toEqual(['A', '2', 'B'])
  expect(namesOf(Array.from({ length: 28 }, (_, i) => 40 + i)).slice(24)).toEqual(['Y', 'Z', 'AA', 'AB'])
})

test('of the Pareto front only plans that are not ranked, and were opened, get a point of their own, after the ranked', () => {
  const front = [
    frontPlanOf(ringOf(30)), // plan 1
    frontPlanOf(ringOf(34), { opening_mm2: 420, durability_mm: 3.5 }),
    frontPlanOf(ringOf(36), { opening_mm2: null }),
    frontPlanOf(ringOf(38), { durability_mm: null }),
  ]
  const result = resultOf([planOf({ rank: 1, plan: ringOf(30) })], {}, front)
  const points = tradePoints(result)
  expect(points.map(({ name }) => name)).toEqual(['1', 'A', 'C', 'before'])
  expect(points[1]).toEqual({
    x: 0.2 + 0.1,
    y: 4.2,
    name: 'A',
    words:
      'Plan A: leak 0.3 mm² (mean + sd), opening 4.2 cm², reserve 3.5 mm, Pareto-optimal. Not ranked, because it was closed at only 17 region points.',
    level: 1,
    isRinged: true,
    isSmall: true,
  })
  expect(points[2]).toMatchObject({
    level: null,
    words:
      'Plan C: leak 0.3 mm² (mean + sd), opening 3.0 cm², Pareto-optimal. Not ranked, because it was closed at only 17 region points.',
  })
  expect(tradeSummary(result)).toContain('Letters denote 2 unranked plans of the Pareto front.')
})

test('the summary says what can be seen', () => {
  expect(tradeSummary(resultOf(PLANS))).toBe(
    'Up and to the left is better: leak 0.5 to 1.3 mm² (mean + sd), opening 2.9 to 4.0 cm². Their reserve against progression is 5.9 to 12.0 mm, up to the simulated 12 mm. Pareto-optimal: plans 1 and 2. Before repair: 33.6 mm² and 3.7 cm².',
  )
})

test('what is not known is said, not drawn', () => {
  const unopened = planOf({ rank: 4, opening_mm2: null, durability_mm: null })
  expect(tradePoints(resultOf([unopened], { opening_area_mm2: null }))).toEqual([])
  expect(lacking([unopened])).toEqual([
    'The opening is unknown for all plans (the valve was not opened, or did not reach equilibrium), so there is no chart.',
    'The reserve against progression is unknown for all plans (it requires the evidence of a search).',
  ])
  expect(lacking([...PLANS, unopened])).toEqual([
    'The opening is unknown for plan 4 (the valve was not opened, or did not reach equilibrium).',
    'The reserve against progression is unknown for plans 3 and 4 (it requires the evidence of a search).',
  ])
  expect(lacking([planOf({ mean: null })])).toEqual([
    'The leak with errors of execution is unknown for all plans (it was not computed), so there is no chart.',
  ])
  expect(lacking(PLANS.slice(0, 2))).toEqual([])
})

test('axes end at round numbers, hold their values and their least span', () => {
  expect(axisOf([0, 1.03], 1.2)).toEqual({ from: 0, to: 1.5, ticks: [0, 0.5, 1, 1.5], digits: 1 })
  expect(axisOf([0, 0], 1.2)).toEqual({ from: 0, to: 1.5, ticks: [0, 0.5, 1, 1.5], digits: 1 })
  expect(axisOf([2.9, 3.1], 1)).toEqual({ from: 2.4, to: 3.6, ticks: [2.4, 2.6, 2.8, 3, 3.2, 3.4, 3.6], digits: 1 })
  expect(axisOf([0, 40], 1)).toEqual({ from: 0, to: 40, ticks: [0, 10, 20, 30, 40], digits: 0 })
})

test('a place on an axis is proportional to its value, upwards too', () => {
  const axis = { from: 2, to: 4 }
  expect([2, 3, 4].map(placeOn(axis, 300, 100))).toEqual([300, 200, 100])
})
