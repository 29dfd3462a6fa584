// The order of plans at other prices. What the program ranks by before the cost it states of each plan (`tier`). Plans of one
// tier that stand together change places, and no others.
import type { RankedPlan } from '../api/types'
import { joined, number } from '../format'
import { reweightedCost, priceItems, type Wanted, type Weights } from './price'

type Tier = NonNullable<RankedPlan['tier']>

const IN_WORDS: Readonly<Record<Tier, string>> = {
  acceptable: '',
  warned: 'it has a warning that other plans avoid',
  not_acceptable: 'it is not acceptable',
  stenotic: 'it opens to less than 1.5 cm²',
  fails_often: 'more than 5 % of its closures with errors of execution failed',
  untrusted: 'its planned closure is unreliable',
  rejected: 'a rule of practice rejects it',
}
const TOLD_MM2 = 0.05 // differences below it are not told
const TOLD = 3 // differences, the largest first

/// By rank, then each run of plans of one tier by cost; its own weights leave them as ranked, as do results without tiers.
export function reordered(plans: RankedPlan[], own: Weights, wanted: Weights): RankedPlan[] {
  const ranked = [...plans].sort((a, b) => a.rank - b.rank)
  if (isSame(own, wanted)) return ranked
  let run = 0
  return ranked
    .map((plan, i) => {
      const ahead = ranked[i - 1] ?? plan
      if (plan.tier === undefined || plan.tier !== ahead.tier) ++run
      return { plan, run, cost: reweightedCost(plan, own, wanted) ?? Number.POSITIVE_INFINITY }
    })
    .sort((a, b) => a.run - b.run || (a.cost === b.cost ? 0 : a.cost - b.cost)) // infinite ones have no difference
    .map(({ plan }) => plan)
}

const isSame = (a: Weights, b: Weights): boolean => JSON.stringify(a) === JSON.stringify(b)

/// Why the first of `order` stands before the second, by the prices wanted: "Plan 1 ranks first with a cost of 2.90 mm²; plan 2 has 3.37: 0.52
/// more for undersizing." Null where there is no second, or a cost is not known.
export function whyFirst(order: RankedPlan[], own: Weights, { weights, by }: Wanted): string | null {
  const [first, second] = order
  if (!first || !second) return null
  const [cost, other] = [reweightedCost(first, own, weights), reweightedCost(second, own, weights)]
  if (cost === null || other === null) return null
  const plan = by === '' ? 'Plan' : `By ${by}, plan`
  const costs = `${plan} ${first.rank} ranks first with a cost of ${number(cost, 2)} mm²; plan ${second.rank} has ${number(other, 2)}`
  const decisive = second.tier && second.tier !== first.tier ? IN_WORDS[second.tier] : ''
  if (decisive) return `${costs}, ${other < cost ? 'but' : 'and'} ${decisive}.`
  return `${costs}${differences(first, second, weights)}.`
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
  return items.length > 0 ? ', with nearly equal terms' : ''
}
