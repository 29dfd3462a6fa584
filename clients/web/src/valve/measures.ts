// What is measured of a closure, beside what it was before if there is a repair.
import type { Closure, Estimate, Leak, Scene } from '../api/types'
import { dataTable } from '../charts/data_table'
import { h } from '../dom'
import { knownDigits, number, percent, withError } from '../format'
import type { Term } from '../help/glossary'
import { term } from '../help/term'
import { LEAST_NAMED_MM2 } from '../viewer/leak'
import parts from '../style/parts.module.css'
import valveStyle from './valve.module.css'

type Row = readonly [name: string, words: (c: Closure) => string, of?: Term]

export const MEASURES: readonly Row[] = [
  ['Leak ± numerical error, mm²', ({ leak }) => withError(leak.area_mm2, leak.error_mm2), 'leak'],
  ['Bounds of this area, mm²', ({ leak }) => bounds(leak), 'bounds'],
  ['Coaptation height, mean, mm', (c) => number(c.coaptation.height_mean_mm), 'coaptation'],
  ['Coaptation height, minimum, mm', (c) => number(c.coaptation.height_min_mm), 'coaptation'],
  ['Tenting height, mm', (c) => number(c.tenting_height_mm), 'tenting_height'],
  ['Tenting area, mm²', (c) => number(c.tenting_area_mm2, 0), 'tenting_area'],
  ['Annulus, anteroposterior, mm', (c) => number(c.annulus.ap_mm)],
  ['Annulus, transverse, mm', (c) => number(c.annulus.al_pm_mm)],
  ['Annulus, circumference, mm', (c) => number(c.annulus.circumference_mm, 0)],
  ['Annulus, area, mm²', (c) => number(c.annulus.area_mm2, 0)],
  ['Saddle height, mm', (c) => number(c.annulus.saddle_height_mm), 'saddle'],
  ['Highest chordal tension, N', (c) => withMesh(c.tension_max_n, c.estimates?.tension_max_n, 2), 'tension'],
  ['Total chordal tension, N', (c) => number(c.tension_sum_n), 'tension'],
  [
    'Circumferential strain, 99th percentile',
    (c) => strain(c.strain_circumferential_max, c.estimates?.strain_circumferential_max),
    'strain',
  ],
  ['Radial strain, 99th percentile', (c) => strain(c.strain_radial_max, c.estimates?.strain_radial_max), 'strain'],
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
      { 'data-part': 'measures' },
      h('tr', {}, h('td', {}), ...columns.map((name) => h('th', { scope: 'col', class: parts.number }, name))),
      ...MEASURES.map(([name, words, of]) =>
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

/// With the numerical error, where it is stated.
function withMesh(value: number | null, estimate: Estimate | undefined, digits: number): string {
  const high = estimate?.numerical?.[1]
  return value === null || high === undefined ? number(value, digits) : withError(value, high - value)
}

/// Of a share.
function strain(value: number | null, estimate: Estimate | undefined): string {
  const high = estimate?.numerical?.[1]
  if (value === null || high === undefined) return percent(value)
  return `${withError(100 * value, 100 * (high - value))}\u00a0%`
}

function bounds({ between_mm2 }: Leak): string {
  return between_mm2 ? `${number(between_mm2[0])} to ${number(between_mm2[1])}` : number(null)
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
    ? 'the leaflets cross'
    : `the closure did not converge (${closure.status.replace('_', ' ')})`
  return h('p', { class: parts.bad, role: 'alert' }, `The results ${which} are unreliable: ${why}.`)
}
