import { expect, test } from 'vitest'
import kept from '../../../../tests/kept/0.1/plans.json'
import type { RankedPlan } from '../../src/api/types'
import { reordered, whyFirst } from '../../src/search/order'
import { wantedWeights, AS_SEARCHED, type Factors, type Weights } from '../../src/search/price'
import { planOf, WEIGHTS } from './plans'

const at = (factors: Partial<Factors>, learned = {}) => wantedWeights(WEIGHTS, { ...AS_SEARCHED, ...factors }, learned)
const ranks = (plans: RankedPlan[], factors: Partial<Factors> = {}, learned = {}) =>
  reordered(plans, WEIGHTS, at(factors, learned)).map(({ rank }) => rank)
const asSearched = { weights: WEIGHTS, by: '' }

// What each lacks decides before its cost, which falls from rank to rank.
const decided = [
  planOf({ rank: 1, cost: 90 }),
  planOf({ rank: 2, cost: 91 }),
  planOf({ rank: 3, cost: 50, tier: 'not_acceptable' }),
  planOf({ rank: 4, cost: 40, tier: 'stenotic' }),
  planOf({ rank: 5, cost: 30, tier: 'fails_often' }),
  planOf({ rank: 6, cost: 20, tier: 'untrusted' }),
  planOf({ rank: 7, cost: 21, tier: 'untrusted' }),
]

test('factors of 1 leave the order of the search, where costs decide and where they do not', () => {
  const by_cost = [1, 2, 3].map((rank) => planOf({ rank, terms: { leak: 0.1 * rank, step: 1 } }))
  expect(ranks(by_cost)).toEqual([1, 2, 3])
  expect(ranks(decided)).toEqual([1, 2, 3, 4, 5, 6, 7])
})

test('the order does not come from that in which plans are given', () => {
  expect(ranks([...decided].reverse())).toEqual([1, 2, 3, 4, 5, 6, 7])
})

test('plans that release 0.1 has kept stay as it ranked them', () => {
  const { plans, weights } = kept as unknown as { plans: RankedPlan[]; weights: Weights }
  expect(reordered([...plans].reverse(), weights, weights)).toEqual(plans)
})

test('plans of one cost stay in the order of the search', () => {
  expect(ranks([planOf({ rank: 1, cost: 3 }), planOf({ rank: 2, cost: 3 }), planOf({ rank: 3, cost: 3 })])).toEqual([
    1, 2, 3,
  ])
})

// One step less and 0.6 mm2 more leak: the first costs 1 + 0.8, the second 2 + 0.2.
const lesser = planOf({ rank: 1, terms: { step: 1, leak: 0.8 } })
const tighter = planOf({ rank: 2, terms: { step: 2, leak: 0.2 } })

test('the plan that is better in what matters more comes first', () => {
  expect(ranks([lesser, tighter])).toEqual([1, 2])
  expect(ranks([lesser, tighter], { leak: 1.5 })).toEqual([1, 2]) // 2.2 and 2.3
  expect(ranks([lesser, tighter], { leak: 2 })).toEqual([2, 1]) // 2.6 and 2.4
  expect(ranks([lesser, tighter], { operation: 0.5 })).toEqual([2, 1]) // 1.3 and 1.2
  expect(ranks([lesser, tighter], { opening: 4, durability: 0 })).toEqual([1, 2]) // neither has a price of them
})

test('learned weights order the plans, and factors multiply them', () => {
  expect(ranks([lesser, tighter], {}, { leak: 2 })).toEqual([2, 1]) // 2.6 and 2.4
  expect(ranks([lesser, tighter], { leak: 0.5 }, { leak: 2 })).toEqual([1, 2]) // 1.8 and 2.2
  expect(ranks([lesser, tighter], {}, { ...WEIGHTS })).toEqual([1, 2])
})

test('opening and durability matter by their own prices', () => {
  const wide = planOf({ rank: 2, terms: { step: 2, durability: 4 } }) // 2 + 1
  const lasting = planOf({ rank: 1, terms: { step: 1, gradient_above_3: 0.5 } }) // 1 + 1
  expect(ranks([lasting, wide], { opening: 3 })).toEqual([2, 1]) // 4 and 3
  expect(ranks([lasting, wide], { opening: 3, durability: 4 })).toEqual([1, 2]) // 4 and 6
})

test('no preference brings forward a plan that lacks what comes before the cost', () => {
  const leaking = planOf({ rank: 2, robust: false, terms: { step: 1, leak: 2, incompetence: 1 } })
  const sound = planOf({ rank: 1, terms: { step: 4, movement: 20 } })
  expect(ranks([sound, leaking], { leak: 0, operation: 4 })).toEqual([1, 2])
  expect(ranks(decided, { leak: 0, opening: 0, durability: 0, operation: 0 })[2]).toBe(3)
})

test('none brings forward a plan that practice rejects or that is warned of', () => {
  const first = planOf({ rank: 1, terms: { step: 2 } })
  const cheaper = (tier: RankedPlan['tier']) => planOf({ rank: 2, terms: { step: 1 }, tier })
  expect(ranks([first, cheaper('acceptable')], { operation: 2 })).toEqual([2, 1])
  expect(ranks([first, cheaper('warned')], { operation: 2 })).toEqual([1, 2])
  expect(ranks([first, cheaper('rejected')], { operation: 2 })).toEqual([1, 2])
})

test('results without tiers stay as ranked, a plan without a cost comes last', () => {
  const old = [planOf({ rank: 1, cost: 3 }), planOf({ rank: 2, cost: 2 })].map(({ tier: _, ...plan }) => plan)
  expect(ranks(old as RankedPlan[], { operation: 2 })).toEqual([1, 2])
  expect(ranks([planOf({ rank: 1, cost: 2 }), planOf({ rank: 2, cost: null })])).toEqual([1, 2])
})

test('the first plan is first by the prices that differ, the largest first', () => {
  const first = planOf({ rank: 1, terms: { step: 2, leak: 0.75, coaptation: 0.5 } }) // 2 + 0.75 + 0.25
  const second = planOf({ rank: 2, terms: { step: 2, leak: 0.55, undersizing: 1, coaptation: 0.7 } })
  expect(whyFirst([first, second], WEIGHTS, asSearched)).toBe(
    'Plan 1 ranks first with a cost of 3.00 mm²; plan 2 has 3.40: 0.50 more for undersizing, 0.20 less for leak and 0.10 more for low coaptation.',
  )
})

test('as searched plans stay as the rule ranked them', () => {
  const dearer = [planOf({ cost: 3 }), planOf({ rank: 2, cost: 2 })]
  expect(reordered(dearer, WEIGHTS, WEIGHTS).map(({ rank }) => rank)).toEqual([1, 2])
})

test('what decided before the cost is the reason', () => {
  expect(whyFirst([planOf({ cost: 5 }), planOf({ rank: 2, cost: 3, robust: false })], WEIGHTS, asSearched)).toBe(
    'Plan 1 ranks first with a cost of 5.00 mm²; plan 2 has 3.00, but it is not acceptable.',
  )
  expect(whyFirst([planOf({ cost: 2 }), planOf({ rank: 2, cost: 3, tier: 'stenotic' })], WEIGHTS, asSearched)).toBe(
    'Plan 1 ranks first with a cost of 2.00 mm²; plan 2 has 3.00, and it opens to less than 1.5 cm².',
  )
  const failing = planOf({ rank: 2, cost: 4, tier: 'fails_often' })
  expect(whyFirst([planOf({ cost: 5, robust: false }), failing], WEIGHTS, asSearched)).toBe(
    'Plan 1 ranks first with a cost of 5.00 mm²; plan 2 has 4.00, but more than 5 % of its closures with errors of execution failed.',
  )
})

test('at the reader’s own weights costs and prices are those, and nothing is said of ties', () => {
  const weights = at({ leak: 2 })
  const order = reordered([{ ...lesser, tie_with_next: true }, tighter], WEIGHTS, weights)
  expect(whyFirst(order, WEIGHTS, { weights, by: 'your weights' })).toBe(
    'By your weights, plan 2 ranks first with a cost of 2.40 mm²; plan 1 has 2.60: 1.20 more for leak and 1.00 less for steps.',
  )
})

test('one plan alone, or one of unknown cost, needs no reason', () => {
  expect(whyFirst([planOf({})], WEIGHTS, asSearched)).toBeNull()
  expect(whyFirst([planOf({}), planOf({ rank: 2, cost: null })], WEIGHTS, asSearched)).toBeNull()
})
