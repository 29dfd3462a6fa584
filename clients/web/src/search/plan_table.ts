// All ranked plans side by side, the valve as it is above them; two of them can be chosen to be compared. At other prices
// the rows change places; a plan keeps its rank as its name.
import type { Plan, RankedPlan, SearchResult } from '../api/types'
import { dataTable } from '../charts/data_table'
import { h, type Child } from '../dom'
import { number } from '../format'
import { term } from '../help/term'
import { describe } from '../repair/steps'
import { FURTHEST_DISEASE_MM, isAcceptable, meanAndSdCell, openingMm2, type Opened } from './figures'
import { costOf, type Wanted, type Weights } from './price'
import parts from '../style/parts.module.css'
import searchStyle from './search.module.css'

export interface PlanTable {
  element: HTMLElement
  boxes: HTMLInputElement[] // by the plans, to compare them
  show(order: RankedPlan[], wanted: Wanted): void
}

const columns = (): [label: Child, unit: string][] => [
  [term('cost', 'Cost'), 'mm²'],
  [term('region', 'Leak'), 'mean ± sd, mm²'],
  ['Leak', '95th pct., mm²'],
  [term('opening', 'Opening'), 'cm²'],
  [term('durability', 'Reserve'), 'mm'],
  [term('coaptation', 'Coaptation'), 'mean (min), mm'],
  [term('tension', 'Tension'), 'N'],
  ['Steps', ''],
  ['Undersized', 'sizes'],
  ['Displacement', 'AL / PM, mm'],
]

export function planTable(result: SearchResult, cardId: (plan: RankedPlan) => string): PlanTable {
  const { before, plans } = result
  const own = result.weights as Weights
  const lines = plans.map((plan) => ({
    plan,
    box: h('input', { type: 'checkbox', 'aria-label': `Compare plan ${plan.rank}` }),
    note: h('span', { class: searchStyle.tie, 'data-part': 'place' }),
    cost: h('span', {}),
  }))
  const asItIs: Child[] = [
    'Before',
    '',
    '',
    number(before.leak_mm2),
    '',
    opening(before),
    '',
    coaptation(before.coaptation),
    number(before.tension_max_n, 2),
    '',
    '',
    '',
  ]
  const rows = lines.map(({ plan, box, note, cost }): Child[] => [
    rankCell(plan, cardId(plan), box, note),
    shortSteps(plan.plan),
    cost,
    meanAndSdCell(plan.leak_mm2),
    number(plan.leak_mm2.p95),
    opening(plan),
    outlasts(plan),
    coaptation(plan.measure.coaptation),
    number(plan.measure.tension_max_n, 2),
    plan.steps,
    number(plan.ring_sizes_below),
    `${number(plan.anterolateral_movement_mm)} / ${number(plan.posteromedial_movement_mm)}`,
  ])
  const table = dataTable(
    'All ranked plans',
    [
      { label: 'Rank' },
      { label: 'Plan' },
      ...columns().map(([label, unit]) => ({
        label: h('span', {}, label, h('small', { class: searchStyle.unit }, unit)),
        numeric: true,
      })),
    ],
    [asItIs, ...rows],
  )
  const [, ...places] = table.querySelectorAll('tbody tr') // by the plans, as they were made

  function show(order: RankedPlan[], { weights, by }: Wanted): void {
    const isOwn = by === ''
    lines.forEach(({ plan, note, cost }, i) => {
      const place = order.indexOf(plan)
      cost.textContent = number(costOf(plan, own, weights), 2)
      note.replaceChildren(...(isOwn ? tieNote(plan) : moved(i + 1, place + 1)))
      note.classList.toggle(searchStyle.moved as string, !isOwn)
    })
    const body = table.querySelector('tbody')
    for (const plan of order) body?.append(places[plans.indexOf(plan)] as Node)
  }

  show(plans, { weights: own, by: '' })
  return { element: h('div', { class: searchStyle.ranked }, table), boxes: lines.map(({ box }) => box), show }
}

export function shortSteps({ steps }: Plan): Child {
  if (steps.length === 0) return 'No repair'
  return h('ul', { class: searchStyle.short }, ...steps.map((step) => h('li', {}, describe(step))))
}

function rankCell(plan: RankedPlan, id: string, box: HTMLInputElement, note: HTMLElement): HTMLElement {
  const go = (event: Event) => {
    event.preventDefault() // the address holds the view
    document.getElementById(id)?.scrollIntoView()
  }
  return h(
    'span',
    { class: searchStyle.rank },
    box,
    h('a', { href: `#${id}`, onclick: go, 'aria-label': `Plan ${plan.rank}` }, `${plan.rank}.`),
    isAcceptable(plan) && h('span', { class: parts.good, title: 'acceptable' }, '✓'),
    note,
  )
}

/// Ties are of the search's own order.
function tieNote(plan: RankedPlan): string[] {
  return plan.tie_with_next ? [`equivalent to ${plan.rank + 1}`] : []
}

function moved(from: number, to: number): Node[] {
  if (from === to) return []
  return [
    h('span', { 'aria-hidden': 'true' }, `${to < from ? '▲' : '▼'} ${from} → ${to}`),
    h('span', { class: parts.unseen }, `moved from place ${from} to ${to}`),
  ]
}

function opening(of: Opened): string {
  const area_mm2 = openingMm2(of)
  return number(area_mm2 === null ? null : area_mm2 / 100)
}

/// "8.4", "≥ 12.0"
export function outlasts({ durability_mm }: Pick<RankedPlan, 'durability_mm'>): string {
  return `${(durability_mm ?? 0) >= FURTHEST_DISEASE_MM ? '≥ ' : ''}${number(durability_mm)}`
}

function coaptation({ height_mean_mm, height_min_mm }: RankedPlan['measure']['coaptation']): string {
  return `${number(height_mean_mm)} (${number(height_min_mm)})`
}
