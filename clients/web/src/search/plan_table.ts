// All ranked plans side by side, the valve as it is above them; two of them can be chosen to be compared.
import type { RankedPlan, SearchResult } from '../api/types'
import { dataTable } from '../charts/data_table'
import { h, type Child } from '../dom'
import { number } from '../format'
import { term } from '../help/term'
import { describe } from '../repair/steps'
import { isRobust, meanAndSdCell } from './figures'
import parts from '../style/parts.module.css'
import searchStyle from './search.module.css'

export interface PlanTable {
  element: HTMLElement
  boxes: HTMLInputElement[] // by the plans, to compare them
}

const columns = (): [label: Child, unit: string][] => [
  [term('cost', 'Cost'), 'mm²'],
  [term('region', 'Leak'), 'mean ± sd, mm²'],
  ['95 % below', 'mm²'],
  [term('coaptation', 'Coaptation'), 'mean (min), mm'],
  [term('tension', 'Tension'), 'N'],
  ['Steps', ''],
  ['Undersized', 'sizes'],
  ['Muscles moved', 'AL / PM, mm'],
]

export function planTable(result: SearchResult, cardId: (plan: RankedPlan) => string): PlanTable {
  const { before, plans } = result
  const boxes = plans.map(() => h('input', { type: 'checkbox' }))
  const asItIs: Child[] = [
    'Before',
    '',
    '',
    number(before.leak_mm2),
    '',
    coaptation(before.coaptation),
    number(before.tension_max_n, 2),
    '',
    '',
    '',
  ]
  const rows = plans.map((plan, i): Child[] => [
    rankCell(plan, cardId(plan), boxes[i] as HTMLInputElement),
    plan.plan.steps.length > 0
      ? h('ul', { class: searchStyle.short }, ...plan.plan.steps.map((step) => h('li', {}, describe(step))))
      : 'No repair',
    number(plan.cost, 2),
    meanAndSdCell(plan.leak_mm2),
    number(plan.leak_mm2.p95),
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
  return { element: h('div', { class: searchStyle.ranked }, table), boxes }
}

function rankCell(plan: RankedPlan, id: string, box: HTMLInputElement): HTMLElement {
  const go = (event: Event) => {
    event.preventDefault() // the address holds the view
    document.getElementById(id)?.scrollIntoView()
  }
  box.setAttribute('aria-label', `Compare plan ${plan.rank}`)
  return h(
    'span',
    { class: searchStyle.rank },
    box,
    h('a', { href: `#${id}`, onclick: go, 'aria-label': `Plan ${plan.rank}` }, `${plan.rank}.`),
    isRobust(plan) && h('span', { class: parts.good, title: 'robust' }, '✓'),
    plan.tie_with_next && h('span', { class: searchStyle.tie }, `ties with ${plan.rank + 1}`),
  )
}

function coaptation({ height_mean_mm, height_min_mm }: RankedPlan['measure']['coaptation']): string {
  return `${number(height_mean_mm)} (${number(height_min_mm)})`
}
