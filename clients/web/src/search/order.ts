// The order of plans at other prices, by the rules of the search (search/plans/ranking.cpp): what every plan should meet
// decides before the cost does.
import type { RankedPlan } from '../api/types'
import { joined, number } from '../format'
import { isRobust, openingMm2, tieWords } from './figures'
import { costOf, priceItems, type Wanted, type Weights } from './price'

const OFTEN_FAILING = 0.05 // of the closures over the region: then its figures mean little
export const STENOSIS_MM2 = 150

const TOLD_MM2 = 0.05 // differences below it are not told
const TOLD = 3 // differences, the largest first

interface Requirement {
  isMet(plan: RankedPlan): boolean
  unmet: string // of a plan, after its name
}

/// The first in which two plans differ decides.
const REQUIREMENTS: Requirement[] = [
  {
    isMet: ({ status, crossing, measure }) => status === 'converged' && !crossing && measure.leak_mm2 !== null,
    unmet: 'its closure as planned is not to be trusted',
  },
  {
    isMet: ({ region_failures, region_closures }) => region_failures <= OFTEN_FAILING * region_closures,
    unmet: 'more than a twentieth of its closures over the region failed',
  },
  {
    isMet: (plan) => (openingMm2(plan) ?? STENOSIS_MM2) >= STENOSIS_MM2,
    unmet: 'it opens to less than 1.5 cm²',
  },
  { isMet: isRobust, unmet: 'it is not shown to close robustly' },
]

/// `plans` as the search ranks them; its own weights leave them so.
export function reordered(plans: RankedPlan[], own: Weights, wanted: Weights): RankedPlan[] {
  const costs = new Map(plans.map((plan) => [plan.rank, costOf(plan, own, wanted) ?? Number.POSITIVE_INFINITY]))
  return [...plans].sort((a, b) => {
    const decisive = deciding(a, b)
    if (decisive) return decisive.isMet(a) ? -1 : 1
    const [cost, other] = [costs.get(a.rank) as number, costs.get(b.rank) as number]
    return cost === other ? 0 : cost - other // infinite ones have no difference
  })
}

function deciding(a: RankedPlan, b: RankedPlan): Requirement | undefined {
  return REQUIREMENTS.find(({ isMet }) => isMet(a) !== isMet(b))
}

/// Why the first of `order` stands before the second: "Plan 1 stands first with a cost of 2.90 mm²; plan 2 has 3.37: 0.52
/// more for undersizing." Null where there is no second, or a cost is not known.
export function whyFirst(order: RankedPlan[], own: Weights, { weights, by }: Wanted): string | null {
  const [first, second] = order
  if (!first || !second) return null
  const [cost, other] = [costOf(first, own, weights), costOf(second, own, weights)]
  if (cost === null || other === null) return null
  const tie = by === '' && first.tie_with_next ? `${tieWords(first, second, order) ?? ''} ` : ''
  const plan = by === '' ? 'Plan' : `By ${by} plan`
  const costs = `${plan} ${first.rank} stands first with a cost of ${number(cost, 2)} mm²; plan ${second.rank} has ${number(other, 2)}`
  const decisive = deciding(first, second)
  if (decisive) return `${tie}${costs}, ${other < cost ? 'but' : 'and'} ${decisive.unmet}.`
  return `${tie}${costs}${differences(first, second, weights)}.`
}

function differences(first: RankedPlan, second: RankedPlan, weights: Weights): string {
  const items = priceItems(first, weights)
  const found = priceItems(second, weights)
    .map(({ name, mm2 }, i) => ({ name, more: mm2 - (items[i]?.mm2 ?? 0) }))
    .filter(({ more }) => Math.abs(more) >= TOLD_MM2)
    .sort((a, b) => Math.abs(b.more) - Math.abs(a.more))
    .slice(0, TOLD)
    .map(({ name, more }) => `${number(Math.abs(more), 2)} ${more > 0 ? 'more' : 'less'} for ${name}`)
  if (found.length > 0) return `: ${joined(found)}`
  return items.length > 0 ? ', with nearly the same prices' : ''
}
