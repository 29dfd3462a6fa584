// Ranked plans with what their order is made of, and the price list's defaults (search/plans/cost_terms.h).
import type { CostTerms, FrontPlan, Plan, RankedPlan } from '../../src/api/types'
import type { Weights } from '../../src/search/price'

export const WEIGHTS: Weights = {
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

export function termsOf(known: Partial<CostTerms>): CostTerms {
  const names = Object.keys(WEIGHTS).filter((name) => name !== 'sd_share') // that is within the leak
  const none = Object.fromEntries(names.map((name) => [name, 0]))
  return { ...(none as unknown as CostTerms), ...known }
}

interface Given {
  rank?: number
  plan?: Plan
  cost?: number | null // without it what `terms` make of it
  durability_price?: number
  terms?: Partial<CostTerms>
  robust?: boolean
  opening_mm2?: number | null
  tier?: RankedPlan['tier']
  durability_mm?: number | null
  pareto?: boolean
  mean?: number | null
  tie?: boolean
}

/// A ring alone.
export function ringOf(size_mm: number): Plan {
  return { schema: 'coapt.plan/1', steps: [{ step: 'annuloplasty', shape: 'generic-classic', size_mm }] }
}

/// Of the Pareto front; leaks 0.2 + 0.1 mm2 and opens to 3 cm2, unless something else is said.
export function frontPlanOf(plan: Plan, given: Partial<FrontPlan> = {}): FrontPlan {
  return {
    plan,
    description: ['a ring'],
    mean_mm2: 0.2,
    sd_mm2: 0.1,
    steps: plan.steps,
    ring_sizes_below: 1,
    opening_mm2: 300,
    durability_mm: 9,
    cost: 2,
    nodes: 17,
    ...given,
  }
}

/// Robust, open to 3 cm2, unless something else is said.
export function planOf(given: Given): RankedPlan {
  const { rank = 1, robust = true, tie = false, mean = 0.25, opening_mm2 = 300 } = given
  const amounts = termsOf(given.terms ?? {})
  const sum = Object.entries(amounts).reduce(
    (all, [name, amount]) => all + WEIGHTS[name as keyof CostTerms] * amount,
    0,
  )
  return {
    rank,
    plan: given.plan ?? ringOf(30),
    cost: given.cost === undefined ? sum : given.cost,
    cost_terms: amounts,
    durability_price: given.durability_price ?? 0,
    fine: null,
    leak_mm2: { mean, sd: mean === null ? null : 0.25 },
    measure: { leak_mm2: 0.1 },
    status: 'converged',
    crossing: false,
    tier: given.tier ?? (robust ? 'acceptable' : 'not_acceptable'),
    gates: [],
    closes_robustly: robust,
    region_closures: 100,
    region_failures: 0,
    opening_area_mm2: opening_mm2,
    projected_area_mm2: opening_mm2,
    durability_mm: given.durability_mm === undefined ? 9 : given.durability_mm,
    pareto: given.pareto ?? false,
    beaten_by: null,
    times_first: 0,
    tie_with_next: tie,
    probability_outranks_next: tie ? 0.6 : 1,
  } as unknown as RankedPlan
}
