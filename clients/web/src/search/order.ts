// The order of plans at other prices. What the program ranks by before the cost it states of each plan; which of it comes
// first, its ranks say. Plans that it ranks by the cost alone change places, and no others.
import type { Gate, RankedPlan } from '../api/types'
import { joined, number } from '../format'
import { isAcceptable } from './figures'
import { costOf, priceItems, type Wanted, type Weights } from './price'

const OFTEN_FAILING = 0.05 // as search/plans/ranking.cpp has it
// As search/plans/gates.cpp has them.
const AVOIDABLE: readonly Gate['rule'][] = [
  'filling',
  'systolic_anterior_motion',
  'ring_stenosis',
  'opening_area',
  'mean_gradient',
  'papillary_movement',
  'undersizing',
  'ring_width',
]
const OF_CLOSURE: readonly Gate['rule'][] = ['convergence', 'crossing', 'opening_area']
const TOLD_MM2 = 0.05 // differences below it are not told
const TOLD = 3 // differences, the largest first

interface Statement {
  holds(plan: RankedPlan): boolean
  not: string // of a plan, after its name
}

const STATEMENTS: Statement[] = [
  {
    holds: ({ gates }) => !gates.some(({ rule, severity }) => severity === 'reject' && !OF_CLOSURE.includes(rule)),
    not: 'a rule of practice rejects it',
  },
  { holds: passes('convergence', 'crossing'), not: 'its planned closure is unreliable' },
  {
    holds: ({ region_failures, region_closures }) => region_failures <= OFTEN_FAILING * region_closures,
    not: 'more than 5 % of its closures with errors of execution failed',
  },
  { holds: passes('opening_area'), not: 'it opens to less than 1.5 cm²' },
  { holds: isAcceptable, not: 'it is not acceptable' },
  {
    holds: (plan) =>
      !isAcceptable(plan) || !plan.gates.some(({ rule, severity }) => severity === 'warn' && AVOIDABLE.includes(rule)),
    not: 'it has a warning that other plans avoid',
  },
]

function passes(...rules: Gate['rule'][]): Statement['holds'] {
  return ({ gates }) => !gates.some(({ rule, severity }) => severity === 'reject' && rules.includes(rule))
}

/// By rank, then each run of plans of which the program states the same by cost; its own weights leave them as ranked.
export function reordered(plans: RankedPlan[], own: Weights, wanted: Weights): RankedPlan[] {
  const ranked = [...plans].sort((a, b) => a.rank - b.rank)
  if (isSame(own, wanted)) return ranked
  let run = 0
  return ranked
    .map((plan, i) => {
      const ahead = ranked[i - 1] ?? plan
      if (STATEMENTS.some(({ holds }) => holds(ahead) !== holds(plan))) ++run
      return { plan, run, cost: costOf(plan, own, wanted) ?? Number.POSITIVE_INFINITY }
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
  const [cost, other] = [costOf(first, own, weights), costOf(second, own, weights)]
  if (cost === null || other === null) return null
  const plan = by === '' ? 'Plan' : `By ${by} plan`
  const costs = `${plan} ${first.rank} ranks first with a cost of ${number(cost, 2)} mm²; plan ${second.rank} has ${number(other, 2)}`
  const decisive = STATEMENTS.find(({ holds }) => holds(first) && !holds(second))
  if (decisive) return `${costs}, ${other < cost ? 'but' : 'and'} ${decisive.not}.`
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
