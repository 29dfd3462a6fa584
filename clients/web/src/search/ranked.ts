// The ranked plans of a search: their table and its order, two of them compared, which the reader prefers, what they trade,
// a card for each.
import type { RankedPlan, SearchResult } from '../api/types'
import { h } from '../dom'
import { HAS_SERVICE } from '../mode'
import { cardId, planCard, type CardContext } from './card'
import { comparison } from './compare'
import { learning } from './learning'
import { reordered, whyFirst } from './order'
import { planTable } from './plan_table'
import { canBeCompared } from './preference_case'
import { preferences } from './preferences'
import { isAsSearched, priceItems, wantedWeights, AS_SEARCHED, type Wanted, type Weights } from './price'
import { tradeOff } from './trade_off'
import parts from '../style/parts.module.css'

export function ranked(result: SearchResult, context: CardContext): HTMLElement[] {
  const { plans } = result
  if (plans.length === 0)
    return [
      h(
        'p',
        { class: parts.panel },
        'No plan was ranked because the search ended before it found one, or every plan violates a rule.',
      ),
      ...(result.pareto_front.length > 0 ? [tradeOff(result, context.signal)] : []),
    ]
  const own = result.weights as Weights
  const title = h('h2', {})
  const why = h('p', { 'data-part': 'why', role: 'status' })
  const order = h('p', { class: parts.hint, 'data-part': 'order' })
  const table = planTable(result, (plan) => cardId(context, plan))

  let factors = AS_SEARCHED // by the sliders
  let learned: Partial<Weights> | null = null // where the reader wants them
  function arrange(): void {
    const sources = [learned && 'the learned weights', !isAsSearched(factors) && 'your weights']
    const by = sources.filter((source) => typeof source === 'string').join(' and ')
    const wanted: Wanted = { weights: wantedWeights(own, factors, learned ?? {}), by }
    const arranged = reordered(plans, own, wanted.weights)
    title.textContent =
      plans.length === 1 ? 'One ranked plan' : `${plans.length} ranked plans, best first${by && ` by ${by}`}`
    why.textContent = (by === '' ? result.verdict : whyFirst(arranged, own, wanted)) ?? ''
    why.hidden = why.textContent === ''
    order.hidden = by === ''
    table.show(arranged, wanted)
  }

  order.textContent =
    'Plans are named by their rank in the search, also in the chart and below. Equivalence is known only for the order of the search.'
  arrange()
  const compared = h('div', { 'aria-live': 'polite' })
  compareTicked(plans, table.boxes, compared, context)
  const canWeigh = plans.length > 1 && plans.every((plan) => priceItems(plan, own).length > 0)
  return [
    h(
      'section',
      { class: parts.panel, 'data-part': 'ranked', 'aria-label': 'Ranked plans' },
      title,
      why,
      canWeigh &&
        preferences(plans, own, (moved) => {
          factors = moved
          arrange()
        }),
      table.element,
      order,
      plans.length > 1 && h('p', { class: parts.hint }, 'Tick two plans to compare them.'),
    ),
    compared,
    ...(HAS_SERVICE && canBeCompared(plans)
      ? [
          learning(plans, own, context, (taken) => {
            learned = taken
            arrange()
          }),
        ]
      : []),
    tradeOff(result, context.signal),
    ...plans.map((plan) => planCard(plan, context)),
  ]
}

/// `boxes` by the plans; of three that are ticked the first is given up.
function compareTicked(
  plans: RankedPlan[],
  boxes: HTMLInputElement[],
  compared: HTMLElement,
  context: CardContext,
): void {
  const chosen: number[] = [] // indices of plans, at most two
  boxes.forEach((box, i) => {
    box.addEventListener('change', () => {
      if (box.checked) chosen.push(i)
      else chosen.splice(chosen.indexOf(i), 1)
      const dropped = chosen.length > 2 ? chosen.shift() : undefined // the one chosen first
      const other = dropped === undefined ? undefined : boxes[dropped]
      if (other) other.checked = false
      compare()
    })
  })

  function compare(): void {
    const [a, b] = [...chosen].sort((one, other) => one - other).map((i) => plans[i])
    if (a && b) compared.replaceChildren(comparison(a, b, plans, context))
    else
      compared.replaceChildren(
        ...(a
          ? [h('p', { class: parts.panel }, `Rank ${a.rank} is selected; select another plan to compare it with.`)]
          : []),
      )
    if (a && b) compared.scrollIntoView({ block: 'start' })
  }
}
