// What is measured of a closure, beside what it was before if there is a repair.
import type { Closure, Leak, Scene } from '../api/types'
import { dataTable } from '../charts/data_table'
import { h } from '../dom'
import { knownDigits, number, percent, withError, withUnit } from '../format'
import type { Term } from '../help/glossary'
import { term } from '../help/term'
import { LEAST_NAMED_MM2 } from '../viewer/leak'
import parts from '../style/parts.module.css'
import valveStyle from './valve.module.css'

type Row = readonly [name: string, words: (c: Closure) => string, of?: Term]

const ROWS: readonly Row[] = [
  ['Leak', ({ leak }) => withError(leak.area_mm2, leak.error_mm2, 'mm²'), 'leak'],
  ['Bounds of this area', ({ leak }) => bounds(leak), 'bounds'],
  ['Coaptation height, mean', (c) => withUnit(c.coaptation.height_mean_mm, 'mm'), 'coaptation'],
  ['Coaptation height, minimum', (c) => withUnit(c.coaptation.height_min_mm, 'mm'), 'coaptation'],
  ['Tenting height', (c) => withUnit(c.tenting_height_mm, 'mm'), 'tenting_height'],
  ['Tenting area', (c) => withUnit(c.tenting_area_mm2, 'mm²', 0), 'tenting_area'],
  ['Annulus, anteroposterior', (c) => withUnit(c.annulus.ap_mm, 'mm')],
  ['Annulus, transverse', (c) => withUnit(c.annulus.al_pm_mm, 'mm')],
  ['Annulus, circumference', (c) => withUnit(c.annulus.circumference_mm, 'mm', 0)],
  ['Annulus, area', (c) => withUnit(c.annulus.area_mm2, 'mm²', 0)],
  ['Saddle height', (c) => withUnit(c.annulus.saddle_height_mm, 'mm'), 'saddle'],
  ['Highest chordal tension', (c) => withUnit(c.tension_max_n, 'N', 2), 'tension'],
  ['Total chordal tension', (c) => withUnit(c.tension_sum_n, 'N'), 'tension'],
  ['Circumferential strain, 99th percentile', (c) => percent(c.strain_circumferential_max), 'strain'],
  ['Radial strain, 99th percentile', (c) => percent(c.strain_radial_max), 'strain'],
]

export function measures(before: Scene, after: Scene | null): HTMLElement {
  const scenes = after ? [before, after] : [before]
  const columns = after ? ['Before', 'Repaired'] : ['Closed']
  const names = after ? ['before the repair', 'after it'] : ['of this closure']
  return h(
    'div',
    { class: valveStyle.measures },
    ...scenes.map(({ closure }, i) => distrust(closure, names[i] ?? '')),
    h(
      'table',
      { class: after && valveStyle.twoColumns, 'data-part': 'measures' },
      h('tr', {}, h('td', {}), ...columns.map((name) => h('th', { scope: 'col', class: parts.number }, name))),
      ...ROWS.map(([name, words, of]) =>
        row(
          name,
          scenes.map(({ closure }) => words(closure)),
          of,
        ),
      ),
    ),
    openings((after ?? before).closure.leak, after ? 'Opening after the repair' : 'Opening'),
  )
}

function bounds({ between_mm2 }: Leak): string {
  return between_mm2 ? `${number(between_mm2[0])} to ${withUnit(between_mm2[1], 'mm²')}` : number(null)
}

/// Those that have a label in the picture.
function openings(leak: Leak, heading: string): HTMLElement | null {
  const named = leak.openings.filter(({ area_mm2 }) => area_mm2 >= LEAST_NAMED_MM2)
  if (named.length === 0) return null
  return dataTable(
    'Openings',
    [{ label: heading }, { label: 'mm²', numeric: true }, { label: 'mm wide', numeric: true }],
    named.map(({ area_mm2, segments, width_mm }, i) => [
      `${i + 1}. ${segments.join(', ')}`,
      knownDigits(area_mm2, leak.error_mm2),
      number(width_mm),
    ]),
  )
}

function row(name: string, values: string[], of?: Term): HTMLElement {
  return h(
    'tr',
    {},
    h('th', { scope: 'row' }, of ? term(of, name) : name),
    ...values.map((value) => h('td', { class: parts.number }, value)),
  )
}

/// Said where the figures do not count; else nothing.
function distrust(closure: Closure, which: string): HTMLElement | null {
  if (closure.status === 'converged' && !closure.crossing) return null
  const why = closure.crossing
    ? 'leaflets pass through each other'
    : `the closure did not converge (${closure.status.replace('_', ' ')})`
  return h('p', { class: parts.bad, role: 'alert' }, `Do not trust the figures ${which}: ${why}.`)
}
