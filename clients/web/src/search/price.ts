// What plans are ranked by: amounts that the service states of each plan (cost_terms) times the weights of the search, told
// in the groups of the sentences, and the weights that the reader wants instead.
import type { CostTerms, RankedPlan, SearchResult } from '../api/types'

export type Weights = Required<NonNullable<SearchResult['weights']>>
export type Objective = 'leak' | 'opening' | 'durability' | 'operation'

/// What the prices of each objective are multiplied by, 0 or more.
export type Factors = Record<Objective, number>
export const AS_SEARCHED: Factors = { leak: 1, opening: 1, durability: 1, operation: 1 }

/// What plans are ordered by.
export interface Wanted {
  weights: Weights
  by: string // "your weights"; empty: as searched
}

export interface PriceItem {
  name: string
  objective: Objective | null // null: no matter of preference
  mm2: number
}

const ITEMS: { name: string; objective: Objective | null; terms: (keyof CostTerms)[] }[] = [
  { name: 'leak', objective: 'leak', terms: ['leak', 'incompetence'] },
  { name: 'margin to leak', objective: 'leak', terms: ['margin'] },
  { name: 'low coaptation', objective: 'leak', terms: ['coaptation'] },
  { name: 'distance between the leaflets', objective: 'leak', terms: ['gap'] },
  { name: 'chordal tension', objective: 'leak', terms: ['tension'] },
  { name: 'diastolic gradient', objective: 'opening', terms: ['gradient_above_3', 'gradient_above_5'] },
  { name: 'reserve against progression', objective: 'durability', terms: ['durability'] },
  { name: 'steps', objective: 'operation', terms: ['step'] },
  { name: 'undersizing', objective: 'operation', terms: ['undersizing', 'undersizing_above_4'] },
  { name: 'papillary relocation', objective: 'operation', terms: ['movement', 'movement_above_10'] },
  { name: 'failed closures', objective: null, terms: ['untrusted'] },
]

/// Those of the search, or the learned ones, times the factors; `untrusted` and `sd_share` remain the search's.
export function wantedWeights(own: Weights, factors: Factors, learned: Partial<Weights> = {}): Weights {
  const wanted = { ...own }
  for (const { objective, terms } of ITEMS)
    if (objective) for (const term of terms) wanted[term] = (learned[term] ?? own[term]) * factors[objective]
  return wanted
}

/// At the weights of the search they add up to what it ranks by. Empty for results of a service that did not state the
/// amounts yet.
export function priceItems(plan: RankedPlan, weights: Weights): PriceItem[] {
  const amounts = plan.cost_terms as CostTerms | undefined
  if (!amounts) return []
  return ITEMS.map(({ name, objective, terms }) => ({
    name,
    objective,
    mm2: terms.reduce((sum, term) => sum + weights[term] * amounts[term], 0),
  }))
}

/// What the search ranks a plan by. Results of earlier releases state its parts: the cost over the region, with the closure on the finer
/// mesh, and the price of the disease that it does not outlast.
export function rankedCost({ ranked_cost, cost, fine, durability_price }: RankedPlan): number | null {
  if (ranked_cost !== undefined) return ranked_cost
  return cost === null ? null : (fine?.cost ?? cost) + (durability_price ?? 0) // coapt 0.1 knew neither
}

/// By the weights wanted; to the last bit what the search ranks by where they are its own: sums of rounded prices might swap equal plans.
export function reweightedCost(plan: RankedPlan, own: Weights, wanted: Weights): number | null {
  const cost = rankedCost(plan)
  const amounts = plan.cost_terms as CostTerms | undefined
  if (cost === null || !amounts) return cost
  return ITEMS.flatMap(({ terms }) => terms).reduce(
    (sum, term) => sum + (wanted[term] - own[term]) * amounts[term],
    cost,
  )
}

export function isAsSearched(factors: Factors): boolean {
  return Object.values(factors).every((factor) => factor === 1)
}
