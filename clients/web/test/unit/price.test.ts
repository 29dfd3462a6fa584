import { expect, test } from 'vitest'
import type { RankedPlan } from '../../src/api/types'
import { priceItems, whyFirst, type Weights } from '../../src/search/price'

// The price list's defaults (search/plans/objective.h).
const weights: Weights = {
  leak: 1,
  sd_share: 1,
  incompetence: 5,
  margin: 1,
  coaptation: 0.5,
  gap: 2,
  movement: 0.2,
  movement_above_10: 1,
  undersizing: 0.5,
  undersizing_above_4: 2,
  step: 1,
  tension: 1,
  gradient_above_3: 2,
  gradient_above_5: 10,
  durability: 0.25,
  untrusted: 10_000,
}

interface Given {
  rank?: number
  cost?: number | null
  mean?: number
  sizes?: number
  moved?: number
  tie?: boolean
  gradient?: number | null
}

function plan({
  rank = 1,
  cost = 3,
  mean = 0.5,
  sizes = 0,
  moved = 0,
  tie = false,
  gradient = null,
}: Given): RankedPlan {
  return {
    rank,
    cost,
    leak_mm2: { mean, sd: 0.5 },
    margin_to_leak: { share: 0.75 },
    steps: 1,
    ring_sizes_below: sizes,
    anterolateral_movement_mm: moved,
    posteromedial_movement_mm: 0,
    region_closures: 100,
    region_failures: 0,
    gradient_mmhg: gradient,
    tie_with_next: tie,
    probability_outranks_next: tie ? 0.6 : 1,
  } as unknown as RankedPlan
}

const prices = (of: RankedPlan) => Object.fromEntries(priceItems(of, weights).map(({ name, mm2 }) => [name, mm2]))

test('prices add up to the cost, what the region alone knows is the rest', () => {
  const items = prices(plan({ cost: 40, mean: 1.5, sizes: 5, moved: 12, gradient: 6 }))
  expect(items).toEqual({
    leak: 7, // 1.5 + 0.5, and five times the 1 above 1
    'margin to leak': 0.25,
    steps: 1,
    undersizing: 4.5, // half a mm2 for each of 5, two for the fifth
    'papillary movement': 4.4, // 12 fifths, two above 10
    'gradient in diastole': 16, // two for each of 3 mmHg above 3, ten for the one above 5
    'closures that failed': 0,
    'coaptation, gaps and tension': expect.closeTo(6.85),
  })
})

test('the first plan is first by the prices that differ, the largest first', () => {
  const [first, second] = [plan({ cost: 3, mean: 0.5 }), plan({ rank: 2, cost: 3.4, mean: 0.3, sizes: 1 })]
  expect(whyFirst([first, second], weights)).toBe(
    'Plan 1 stands first with a cost of 3.00 mm²; plan 2 has 3.40: 0.50 more for undersizing, 0.20 less for leak and 0.10 more for coaptation, gaps and tension.',
  )
})

test('a tie is said before its prices', () => {
  const words = whyFirst([plan({ tie: true }), plan({ rank: 2, cost: 3.01 })], weights)
  expect(words).toBe(
    'Plans 1 and 2 tie; plan 1 is ahead with a probability of 60 %. Plan 1 stands first with a cost of 3.00 mm²; plan 2 has 3.01, with nearly the same prices.',
  )
})

test('one plan alone, or one of unknown cost, needs no reason', () => {
  expect(whyFirst([plan({})], weights)).toBeNull()
  expect(whyFirst([plan({}), plan({ rank: 2, cost: null })], weights)).toBeNull()
})
