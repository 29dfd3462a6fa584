// What matters to the reader: a slider for each objective, which multiplies its prices.
import type { RankedPlan } from '../api/types'
import { button, h } from '../dom'
import { isAsSearched, priceItems, AS_SEARCHED, type Factors, type Objective, type Weights } from './price'
import parts from '../style/parts.module.css'
import searchStyle from './search.module.css'

const FACTORS = [0, 0.25, 0.5, 0.75, 1, 1.5, 2, 3, 4]
const OWN_STOP = FACTORS.indexOf(1)
const ALIKE_MM2 = 0.005 // as shown

const OBJECTIVES: { objective: Objective; label: string; prices: string }[] = [
  { objective: 'leak', label: 'Leak', prices: 'leak, margin, coaptation, distance, tension' },
  { objective: 'opening', label: 'Opening', prices: 'mean gradient above 3 mmHg' },
  { objective: 'durability', label: 'Reserve', prices: 'reserve against progression' },
  { objective: 'operation', label: 'Operation', prices: 'steps, undersizing, papillary relocation' },
]

/// `changed` hears of every move.
export function preferences(plans: RankedPlan[], weights: Weights, changed: (factors: Factors) => void): HTMLElement {
  const sliders = OBJECTIVES.map(({ objective, label, prices }) => {
    const shown = h('span', {})
    const input = h('input', {
      type: 'range',
      min: 0,
      max: FACTORS.length - 1,
      step: 1,
      value: OWN_STOP,
      'aria-label': `${label}: ${prices}`,
      oninput: () => take(),
    })
    const factor = () => FACTORS[input.valueAsNumber] ?? 1
    const tell = () => {
      shown.textContent = `× ${factor()}`
      input.setAttribute('aria-valuetext', `times ${factor()}`)
    }
    tell()
    const same = isAlike(plans, weights, objective) && h('small', {}, 'The same for all plans.')
    const element = h(
      'div',
      {},
      h('label', {}, h('span', { class: searchStyle.preference }, h('span', {}, label), shown), input),
      h('p', { class: parts.hint }, prices, same && h('br'), same),
    )
    return { objective, input, factor, tell, element }
  })
  const reset = button('Reset', () => {
    for (const { input } of sliders) input.value = String(OWN_STOP)
    take()
  })
  reset.disabled = true

  function take(): void {
    const factors = { ...AS_SEARCHED }
    for (const { objective, factor, tell } of sliders) {
      tell()
      factors[objective] = factor()
    }
    reset.disabled = isAsSearched(factors)
    changed(factors)
  }

  return h(
    'div',
    { class: searchStyle.preferences, role: 'group', 'aria-label': 'What matters to you', 'data-part': 'preferences' },
    h('div', { class: `${parts.row} ${searchStyle.preferencesHead}` }, h('h3', {}, 'What matters to you'), reset),
    h(
      'p',
      { class: parts.hint },
      'Each slider scales a group of cost weights without a new search; × 1 is the setting of the search. Acceptable plans that open far enough still come first.',
    ),
    h('div', { class: searchStyle.sliders }, ...sliders.map(({ element }) => element)),
  )
}

/// No slider of theirs changes the order.
function isAlike(plans: RankedPlan[], weights: Weights, objective: Objective): boolean {
  const prices = plans.map((plan) =>
    priceItems(plan, weights)
      .filter((item) => item.objective === objective)
      .reduce((sum, { mm2 }) => sum + mm2, 0),
  )
  return Math.max(...prices) - Math.min(...prices) < ALIKE_MM2
}
