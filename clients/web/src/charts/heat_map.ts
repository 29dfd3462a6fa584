// A table whose cells are shaded by their values: to be seen as a map, and to be read cell by cell.
import { h } from '../dom'
import { number } from '../format'
import { figure } from './data_table'
import { SHADES, shadeOf } from './colours'
import chartsStyle from './charts.module.css'
import parts from '../style/parts.module.css'

export interface HeatMap {
  title: string
  unit: string
  rows: { label: string; ticks: string[] } // downwards
  columns: { label: string; ticks: string[] }
  values: (number | null)[][] // by row; null: not known
  limits: number[] // where the shades change
  digits?: number
  marked?: { row: number; column: number } // what was planned
}

export function heatMap(map: HeatMap): HTMLElement {
  const digits = map.digits ?? 1
  const body = map.values.map((row, r) =>
    h(
      'tr',
      {},
      h('th', { scope: 'row', class: parts.number }, map.rows.ticks[r]),
      ...row.map((value, c) => {
        const marked = map.marked?.row === r && map.marked.column === c
        const shade = chartsStyle[value === null ? 'heatNone' : `heat${shadeOf(value, map.limits)}`]
        return h(
          'td',
          { class: marked ? `${shade} ${chartsStyle.marked}` : shade },
          value === null ? '–' : number(value, digits),
        )
      }),
    ),
  )
  return h(
    'div',
    { class: parts.scroll, role: 'group', 'aria-label': map.title, tabindex: 0 },
    h(
      'table',
      { class: chartsStyle.heat, 'data-part': 'heat' },
      h('caption', {}, h('strong', {}, map.title), ` Down: ${map.rows.label}. Across: ${map.columns.label}.`),
      h(
        'thead',
        {},
        h(
          'tr',
          {},
          h('td', {}),
          ...map.columns.ticks.map((tick) => h('th', { scope: 'col', class: parts.number }, tick)),
        ),
      ),
      h('tbody', {}, ...body),
    ),
  )
}

/// What the shades mean, with the values where they change, and `none` what a dash does.
export function heatScale(limits: number[], unit: string, none = 'not closed'): HTMLElement {
  const shade = (i: number) => chartsStyle[`heat${i}`]
  return h(
    'div',
    { class: chartsStyle.heatScale, 'data-part': 'heat-scale' },
    h(
      'span',
      {
        class: chartsStyle.shades,
        role: 'img',
        'aria-label': `Shades change at ${limits.map(figure).join(', ')} ${unit}`,
      },
      ...Array.from({ length: SHADES }, (_, i) =>
        h('span', { class: shade(i) }, i > 0 && h('small', {}, Number(figure(limits[i - 1])))),
      ),
    ),
    h('span', {}, `${unit}; – ${none}`),
  )
}
