// What plans are ranked by: amounts that the service states of each plan (cost_terms) times the weights of the search, told
// in the groups of the sentences, and what each objective is worth to the reader.
import type { CostTerms, RankedPlan, SearchResult } from '../api/types'

export type Weights = Required<NonNullable<SearchResult['weights']>>
export type Objective = 'leak' | 'opening' | 'durability' | 'operation'

/// What the prices of each objective are multiplied by, 0 or more.
export type Factors = Record<Objective, number>
export const AS_SEARCHED: Factors = { leak: 1, opening: 1, durability: 1, operation: 1 }

export interface PriceItem {
  name: string
  objective: Objective | null // null: no matter of preference
  mm2: number
}

const ITEMS: { name: string; objective: Objective | null; terms: (keyof CostTerms)[] }[] = [
  { name: 'leak', objective: 'leak', terms: ['leak', 'incompetence'] },
  { name: 'margin to leak', objective: 'leak', terms: ['margin'] },
  { name: 'too little coaptation', objective: 'leak', terms: ['coaptation'] },
  { name: 'gaps between the leaflets', objective: 'leak', terms: ['gap'] },
  { name: 'chordal tension', objective: 'leak', terms: ['tension'] },
  { name: 'gradient in diastole', objective: 'opening', terms: ['gradient_above_3', 'gradient_above_5'] },
  { name: 'disease not outlasted', objective: 'durability', terms: ['durability'] },
  { name: 'steps', objective: 'operation', terms: ['step'] },
  { name: 'undersizing', objective: 'operation', terms: ['undersizing', 'undersizing_above_4'] },
  { name: 'papillary movement', objective: 'operation', terms: ['movement', 'movement_above_10'] },
  { name: 'closures that failed', objective: null, terms: ['untrusted'] },
]

/// They add up to costOf(). Empty for results of a service that did not state the amounts yet.
export function priceItems(plan: RankedPlan, weights: Weights, factors = AS_SEARCHED): PriceItem[] {
  const amounts = plan.cost_terms as CostTerms | undefined
  if (!amounts) return []
  return ITEMS.map(({ name, objective, terms }) => ({
    name,
    objective,
    mm2: (objective ? factors[objective] : 1) * terms.reduce((sum, term) => sum + weights[term] * amounts[term], 0),
  }))
}

/// What the search ranks a plan by: its cost over the region, with the closure on the finer mesh where all plans have one,
/// and the price of the disease that it does not outlast.
export function rankedCost({ cost, fine, durability_price }: RankedPlan): number | null {
  return cost === null ? null : (fine?.cost ?? cost) + (durability_price ?? 0) // coapt 0.1 knew neither
}

/// To the last bit what the search ranks by where all factors are 1: sums of rounded prices might swap equal plans.
export function costOf(plan: RankedPlan, weights: Weights, factors: Factors): number | null {
  const cost = rankedCost(plan)
  if (cost === null) return null
  return priceItems(plan, weights).reduce(
    (sum, { objective, mm2 }) => sum + (objective ? (factors[objective] - 1) * mm2 : 0),
    cost,
  )
}

export function isAsSearched(factors: Factors): boolean {
  return Object.values(factors).every((factor) => factor === 1)
}
