// Tables of figures, and the one behind each chart.
import { h, type Child } from '../dom'
import { number } from '../format'
import chartsStyle from './charts.module.css'
import parts from '../style/parts.module.css'

export interface TableColumn {
  label: Child
  numeric?: boolean
  sentences?: boolean // wide enough for them on a phone, too
}

/// The first cell of a row is its heading.
export function dataTable(caption: string, columns: TableColumn[], rows: Child[][]): HTMLElement {
  const kind = (i: number) => (columns[i]?.numeric ? parts.number : columns[i]?.sentences && parts.sentences)
  return h(
    'div',
    { class: parts.scroll, role: 'group', 'aria-label': caption, tabindex: 0 },
    h(
      'table',
      {},
      h('caption', { class: parts.unseen }, caption),
      h(
        'thead',
        {},
        h('tr', {}, ...columns.map((column, i) => h('th', { scope: 'col', class: kind(i) }, column.label))),
      ),
      h(
        'tbody',
        {},
        ...rows.map((row) =>
          h(
            'tr',
            {},
            ...row.map((cell, i) =>
              i === 0 ? h('th', { scope: 'row', class: kind(i) }, cell) : h('td', { class: kind(i) }, cell),
            ),
          ),
        ),
      ),
    ),
  )
}

/// A table that is made when it is asked for.
export function asTable(make: () => HTMLElement, label = 'Show as table'): HTMLDetailsElement {
  const details = h('details', { class: chartsStyle.asTable, 'data-part': 'as-table' }, h('summary', {}, label))
  details.addEventListener('toggle', () => {
    while (details.children.length > 1) details.lastElementChild?.remove()
    if (details.open) details.append(make())
  })
  return details
}

/// Empty where there is nothing, with as many digits as say something.
export function figure(value: number | null | undefined): string {
  if (value === null || value === undefined || !Number.isFinite(value)) return ''
  const size = Math.abs(value)
  return number(value, Number.isInteger(value) || size >= 1000 ? 0 : size >= 10 ? 1 : 2)
}
