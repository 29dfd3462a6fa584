import { expect, test } from 'vitest'
import type { CostTerms } from '../../src/api/types'
import {
  reweightedCost,
  isAsSearched,
  priceItems,
  rankedCost,
  wantedWeights,
  AS_SEARCHED,
} from '../../src/search/price'
import { planOf, termsOf, WEIGHTS } from './plans'

const pricesOf = (terms: Partial<CostTerms>, factors = AS_SEARCHED) =>
  Object.fromEntries(
    priceItems(planOf({ terms }), wantedWeights(WEIGHTS, factors))
      .filter(({ mm2 }) => mm2 !== 0)
      .map(({ name, mm2 }) => [name, mm2]),
  )

test('prices are weights times the amounts that the service states, in the groups that are told', () => {
  const terms = {
    ...{ leak: 2, incompetence: 1, margin: 0.25, coaptation: 3, gap: 0.5, tension: 1.5 },
    ...{ gradient_above_3: 3, gradient_above_5: 1, durability: 4, step: 2, undersizing: 5, undersizing_above_4: 1 },
    ...{ movement: 12, movement_above_10: 2, untrusted: 0.01 },
  }
  expect(pricesOf(terms)).toEqual({
    leak: 7, // 2, and five times the 1 above 1
    'margin to leak': 0.25,
    'low coaptation': 1.5, // half a mm2 for each mm
    'distance between the leaflets': 1, // two for each mm
    'chordal tension': 1.5,
    'diastolic gradient': 16, // two for each of 3 mmHg above 3, ten for the one above 5
    'reserve against progression': 1, // a quarter for each mm
    steps: 2,
    undersizing: 4.5, // half a mm2 for each of 5 sizes, two for the fifth
    'papillary relocation': expect.closeTo(4.4), // 12 fifths, two above 10
    'failed closures': 100,
  })
})

test('no amount is left out: each counts in exactly one price', () => {
  const names = Object.keys(termsOf({})) as (keyof CostTerms)[]
  for (const name of names) expect(Object.values(pricesOf({ [name]: 1 }))).toEqual([WEIGHTS[name]])
})

test('an amount that the finer mesh makes negative lowers the price', () => {
  expect(pricesOf({ gap: -0.25 })).toEqual({ 'distance between the leaflets': -0.5 })
})

test('a factor multiplies the prices of its objective alone, and none those of failed closures', () => {
  const terms = { leak: 1, gradient_above_3: 1, durability: 4, step: 1, untrusted: 0.0001 }
  const doubled = (objective: string) => pricesOf(terms, { ...AS_SEARCHED, [objective]: 2 })
  const own = { leak: 1, 'diastolic gradient': 2, 'reserve against progression': 1, steps: 1, 'failed closures': 1 }
  expect(doubled('leak')).toEqual({ ...own, leak: 2 })
  expect(doubled('opening')).toEqual({ ...own, 'diastolic gradient': 4 })
  expect(doubled('durability')).toEqual({ ...own, 'reserve against progression': 2 })
  expect(doubled('operation')).toEqual({ ...own, steps: 2 })
})

test('a plan has the one cost that the search ranks it by; results of earlier releases state its parts', () => {
  const plan = planOf({ cost: 3, durability_price: 0.5 })
  expect(rankedCost({ ...plan, ranked_cost: 4.125 })).toBe(4.125)
  expect(rankedCost({ ...plan, ranked_cost: null })).toBeNull()
  expect(rankedCost(plan)).toBe(3.5)
  expect(rankedCost({ ...plan, fine: { cost: 3.25 } as typeof plan.fine })).toBe(3.75)
  expect(rankedCost({ ...plan, cost: null })).toBeNull()
})

test('learned weights stand for the search’s own and are multiplied; failures and the share of the sd remain its', () => {
  const learned = { leak: 3, step: 0.5, untrusted: 1, sd_share: 7 }
  expect(wantedWeights(WEIGHTS, AS_SEARCHED)).toEqual(WEIGHTS)
  expect(wantedWeights(WEIGHTS, { ...AS_SEARCHED, leak: 2 }, learned)).toEqual({
    ...{ ...WEIGHTS, leak: 6, step: 0.5 },
    ...{ incompetence: 10, margin: 2, coaptation: 1, gap: 4, tension: 2 }, // not learned, of the same objective
  })
})

test('at the search’s own weights the cost is to the last bit what it ranks by, also if it is not the sum of prices', () => {
  const plan = planOf({ cost: 0.1 + 0.2, terms: { leak: 0.3, step: 1e9, untrusted: 1 / 3 } })
  expect(reweightedCost(plan, WEIGHTS, wantedWeights(WEIGHTS, AS_SEARCHED, { ...WEIGHTS }))).toBe(0.1 + 0.2)
})

test('at other weights the cost moves by what they change of the prices', () => {
  const plan = planOf({ terms: { leak: 0.5, step: 2, durability: 4 } }) // 0.5 + 2 + 1
  expect(reweightedCost(plan, WEIGHTS, WEIGHTS)).toBe(3.5)
  const factors = { leak: 0, opening: 4, durability: 4, operation: 0.5 }
  expect(reweightedCost(plan, WEIGHTS, wantedWeights(WEIGHTS, factors))).toBe(5) // 0 + 1 + 4
  expect(reweightedCost(plan, WEIGHTS, wantedWeights(WEIGHTS, factors, { step: 3 }))).toBe(7) // 0 + 3 + 4
})

test('a result of a service that states no amounts has its cost and no prices', () => {
  const { cost_terms, ...old } = planOf({ cost: 3 })
  expect(cost_terms).toBeDefined()
  expect(priceItems(old as typeof old & { cost_terms: CostTerms }, WEIGHTS)).toEqual([])
  expect(reweightedCost(old as typeof old & { cost_terms: CostTerms }, WEIGHTS, { ...WEIGHTS, step: 2 })).toBe(3)
})

test('factors are the search’s own only if all are 1', () => {
  expect(isAsSearched(AS_SEARCHED)).toBe(true)
  expect(isAsSearched({ ...AS_SEARCHED, opening: 0 })).toBe(false)
})
