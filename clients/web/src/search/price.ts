// What a plan's cost is made of, by the price list of the search (search/plans/objective.h), and why one plan costs less
// than another.
import type { RankedPlan, SearchResult } from '../api/types'
import { number } from '../format'
import { tieWords } from './figures'

export type Weights = Required<NonNullable<SearchResult['weights']>>
export interface PriceItem {
  name: string
  mm2: number
}

const COMPETENT_MM2 = 1
const USUAL_MOVEMENT_MM = 10
const MOST_SIZES_BELOW = 4
const USUAL_GRADIENT_MMHG = 3
const STENOSIS_MMHG = 5
const TOLD_MM2 = 0.05 // differences below it are not told
const TOLD = 3 // differences, the largest first

const above = (value: number, limit: number) => Math.max(0, value - limit)

/// They add up to the cost. Contact and tension over the region are known only together: what is left. Empty where the
/// region was not closed.
export function priceItems(plan: RankedPlan, weights: Weights): PriceItem[] {
  const { mean, sd } = plan.leak_mm2
  if (plan.cost === null || mean === null || sd === null) return []
  const leak = mean + weights.sd_share * sd
  const moved = [plan.anterolateral_movement_mm, plan.posteromedial_movement_mm]
  const items: PriceItem[] = [
    { name: 'leak', mm2: weights.leak * leak + weights.incompetence * above(leak, COMPETENT_MM2) },
    { name: 'margin to leak', mm2: weights.margin * (1 - (plan.margin_to_leak.share ?? 1)) },
    { name: 'steps', mm2: weights.step * plan.steps },
    {
      name: 'undersizing',
      mm2:
        weights.undersizing * plan.ring_sizes_below +
        weights.undersizing_above_4 * above(plan.ring_sizes_below, MOST_SIZES_BELOW),
    },
    {
      name: 'papillary movement',
      mm2: moved
        .map((mm) => weights.movement * mm + weights.movement_above_10 * above(mm, USUAL_MOVEMENT_MM))
        .reduce((sum, price) => sum + price),
    },
    {
      name: 'gradient in diastole',
      mm2:
        weights.gradient_above_3 * above(plan.gradient_mmhg ?? 0, USUAL_GRADIENT_MMHG) +
        weights.gradient_above_5 * above(plan.gradient_mmhg ?? 0, STENOSIS_MMHG),
    },
    {
      name: 'closures that failed',
      mm2: (weights.untrusted * plan.region_failures) / Math.max(1, plan.region_closures),
    },
  ]
  const known = items.reduce((sum, { mm2 }) => sum + mm2, 0)
  return [...items, { name: 'coaptation, gaps and tension', mm2: plan.cost - known }]
}

/// Why the first of `plans` stands before the second: "Plan 1 stands first with a cost of 2.90 mm²; plan 2 has 3.37: 0.52
/// more for undersizing." Null where there is no second, or a cost is not known.
export function whyFirst(plans: RankedPlan[], weights: Weights): string | null {
  const [first, second] = plans
  if (!first || !second || first.cost === null || second.cost === null) return null
  const items = priceItems(first, weights)
  const differences = priceItems(second, weights)
    .map(({ name, mm2 }, i) => ({ name, more: mm2 - (items[i]?.mm2 ?? 0) }))
    .filter(({ more }) => Math.abs(more) >= TOLD_MM2)
    .sort((a, b) => Math.abs(b.more) - Math.abs(a.more))
    .slice(0, TOLD)
    .map(({ name, more }) => `${number(Math.abs(more), 2)} ${more > 0 ? 'more' : 'less'} for ${name}`)
  const tie = first.tie_with_next ? `${tieWords(first, second, plans) ?? ''} ` : ''
  const costs = `Plan ${first.rank} stands first with a cost of ${number(first.cost, 2)} mm²; plan ${second.rank} has ${number(second.cost, 2)}`
  return `${tie}${costs}${differences.length > 0 ? `: ${listed(differences)}` : ', with nearly the same prices'}.`
}

function listed(words: string[]): string {
  return words.length < 2 ? words.join() : `${words.slice(0, -1).join(', ')} and ${words.at(-1)}`
}
