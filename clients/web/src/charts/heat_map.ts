// A table whose cells are shaded by their values: to be seen as a map, and to be read cell by cell.
import { h } from '../dom'
import { number } from '../format'
import { SHADES, shadeOf } from './colours'
import chartsStyle from './charts.module.css'
import parts from '../style/parts.module.css'

export interface HeatMap {
  title: string
  unit: string
  rows: { label: string; ticks: string[] } // downwards
  columns: { label: string; ticks: string[] }
  values: (number | null)[][] // by row; null: not known
  most: number // end of the scale
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
        const shade = chartsStyle[value === null ? 'heatNone' : `heat${shadeOf(value, map.most)}`]
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

/// What the shades mean, from 0 to `most`, and `none` what a dash does.
export function heatScale(most: number, unit: string, none = 'not closed'): HTMLElement {
  const shades = Array.from({ length: SHADES }, (_, i) => h('span', { class: chartsStyle[`heat${i}`] }))
  return h(
    'div',
    { class: chartsStyle.heatScale, 'data-part': 'heat-scale' },
    h('span', {}, '0'),
    h('span', { class: chartsStyle.shades, 'aria-hidden': 'true' }, ...shades),
    h('span', {}, `${number(most, most < 10 ? 1 : 0)} ${unit}; – ${none}`),
  )
}

/// The largest of the known values.
export function mostOf(values: (number | null)[][]): number {
  return Math.max(0, ...values.flat().filter((value): value is number => value !== null))
}
