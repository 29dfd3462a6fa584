// All ranked plans side by side, the valve as it is above them; two of them can be chosen to be compared. At other prices
// the rows change places; a plan keeps its rank as its name.
import type { Plan, RankedPlan, SearchResult } from '../api/types'
import { dataTable } from '../charts/data_table'
import { h, type Child } from '../dom'
import { number, withUnit } from '../format'
import { term } from '../help/term'
import { describe } from '../repair/steps'
import { isAcceptable, openingMm2, type Opened } from './figures'
import { reweightedCost, type Wanted, type Weights } from './price'
import parts from '../style/parts.module.css'
import searchStyle from './search.module.css'

export interface PlanTable {
  element: HTMLElement
  boxes: HTMLInputElement[] // by the plans, to compare them
  show(order: RankedPlan[], wanted: Wanted): void
}

type Row = NonNullable<RankedPlan['row']>

interface Column {
  cell: keyof Row
  label: Child
  shared: string | undefined // by all plans
}

/// Results of earlier releases have no rows.
function columnsOf(plans: RankedPlan[]): Column[] {
  const column = (cell: keyof Row, label: Child): Column => {
    const cells = new Set(plans.map(({ row }) => row?.[cell]))
    return { cell, label, shared: plans.length > 1 && cells.size === 1 ? [...cells][0] : undefined }
  }
  return [
    column('leak', term('region', 'Residual leak (< 5 mm²)')),
    column('reserve', term('durability', 'Reserve')),
    column('opening', term('opening', 'Opening, gradient')),
    column('effort', 'Effort'),
  ]
}

/// Of all plans, if there is more than one.
function sharedWarnings(plans: RankedPlan[]): string[] {
  const [first, ...others] = plans
  if (!first || others.length === 0) return []
  return first.warnings.filter((warning) => others.every(({ warnings }) => warnings.includes(warning)))
}

export function planTable(result: SearchResult, cardId: (plan: RankedPlan) => string): PlanTable {
  const { before, plans } = result
  const own = result.weights as Weights
  const lines = plans.map((plan) => ({
    plan,
    box: h('input', { type: 'checkbox', 'aria-label': `Compare plan ${plan.rank}` }),
    note: h('span', { class: searchStyle.tie, 'data-part': 'place' }),
  }))
  const all = columnsOf(plans)
  const columns = all.filter(({ shared }) => shared === undefined)
  const everyones = sharedWarnings(plans)
  const beforeCells: Partial<Row> = { leak: `${number(before.leak_mm2)} mm²`, opening: opening(before) }
  const asItIs: Child[] = ['Before', '', ...columns.map(({ cell }) => beforeCells[cell] ?? ''), '']
  const rows = lines.map(({ plan, box, note }): Child[] => [
    rankCell(plan, cardId(plan), box, note),
    shortSteps(plan.plan),
    ...columns.map(({ cell }) => plan.row?.[cell] ?? ''),
    warningList(plan.warnings.filter((warning) => !everyones.includes(warning))),
  ])
  const table = dataTable(
    'All ranked plans',
    [{ label: 'Rank' }, { label: 'Plan' }, ...columns.map(({ label }) => ({ label })), { label: 'Warnings' }],
    [asItIs, ...rows],
  )
  const [, ...places] = table.querySelectorAll('tbody tr') // by the plans, as they were made

  function show(order: RankedPlan[], { weights, by }: Wanted): void {
    const isOwn = by === ''
    lines.forEach(({ plan, note }, i) => {
      const place = order.indexOf(plan)
      const cost = `reweighted cost ${withUnit(reweightedCost(plan, own, weights), 'mm²', 2)}`
      note.replaceChildren(...(isOwn ? tieNote(plan) : [...moved(i + 1, place + 1), ` ${cost}`]))
      note.classList.toggle(searchStyle.moved as string, !isOwn)
    })
    const body = table.querySelector('tbody')
    for (const plan of order) body?.append(places[plans.indexOf(plan)] as Node)
  }

  show(plans, { weights: own, by: '' })
  const element = h('div', { class: searchStyle.ranked }, ...sharedNote(all, everyones), table)
  return { element, boxes: lines.map(({ box }) => box), show }
}

/// What stands once for all plans.
function sharedNote(columns: Column[], warnings: string[]): HTMLElement[] {
  const cells = columns.filter(({ shared }) => shared !== undefined)
  if (cells.length === 0 && warnings.length === 0) return []
  const named = cells.map(({ label, shared }) =>
    h('span', { class: searchStyle.shared }, label, ': ', h('b', {}, shared)),
  )
  return [h('div', { 'data-part': 'all-plans' }, h('p', {}, 'All plans: ', ...named), warningList(warnings))]
}

function warningList(warnings: string[]): Child {
  if (warnings.length === 0) return ''
  return h(
    'ul',
    { class: `${searchStyle.short} ${searchStyle.warnings}` },
    ...warnings.map((text) => h('li', {}, text)),
  )
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
  return withUnit(area_mm2 === null ? null : area_mm2 / 100, 'cm²')
}
