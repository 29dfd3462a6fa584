// What is measured of a closure, beside what it was before if there is a repair.
import type { Closure, Scene } from '../api/types'
import { h } from '../dom'
import { percent, withError, withUnit } from '../format'
import type { Term } from '../help/glossary'
import { term } from '../help/term'
import parts from '../style/parts.module.css'
import valveStyle from './valve.module.css'

type Row = readonly [name: string, unit: string, digits: number, value: (c: Closure) => number | null, of?: Term]
type Area = readonly [name: string, value: (c: Closure) => [mm2: number | null, error_mm2: number | null], of: Term]

const AREAS: readonly Area[] = [
  ['Leak', (c) => [c.leak_mm2, c.leak_mm2_error], 'leak'],
  ['Orifice (atrial view)', (c) => [c.orifice_area_mm2, c.orifice_area_mm2_error], 'orifice'],
  ['Gap between the leaflets', ({ coaptation }) => [coaptation.gap_area_mm2, coaptation.gap_area_mm2_error], 'gap'],
]

const ROWS: readonly Row[] = [
  ['Coaptation height, mean', 'mm', 1, (c) => c.coaptation.height_mean_mm, 'coaptation'],
  ['Coaptation height, minimum', 'mm', 1, (c) => c.coaptation.height_min_mm, 'coaptation'],
  ['Tenting height', 'mm', 1, (c) => c.tenting_height_mm, 'tenting_height'],
  ['Tenting area', 'mm²', 0, (c) => c.tenting_area_mm2, 'tenting_area'],
  ['Annulus, anteroposterior', 'mm', 1, (c) => c.annulus.ap_mm],
  ['Annulus, transverse', 'mm', 1, (c) => c.annulus.al_pm_mm],
  ['Annulus, circumference', 'mm', 0, (c) => c.annulus.circumference_mm],
  ['Annulus, area', 'mm²', 0, (c) => c.annulus.area_mm2],
  ['Saddle height', 'mm', 1, (c) => c.annulus.saddle_height_mm, 'saddle'],
  ['Highest chordal tension', 'N', 2, (c) => c.tension_max_n, 'tension'],
  ['Total chordal tension', 'N', 1, (c) => c.tension_sum_n, 'tension'],
]

export function measures(before: Scene, after: Scene | null): HTMLElement {
  const head = h('tr', {}, h('td', {}), h('th', { scope: 'col', class: parts.number }, after ? 'Before' : 'Closed'))
  if (after) head.append(h('th', { scope: 'col', class: parts.number }, 'Repaired'))
  const table = h('table', { class: valveStyle.measures, 'data-part': 'measures' }, head)
  const scenes = after ? [before, after] : [before]
  for (const [name, value, of] of AREAS)
    table.append(
      row(
        name,
        scenes.map(({ closure }) => withError(...value(closure), 'mm²')),
        of,
      ),
    )
  for (const [name, unit, digits, value, of] of ROWS)
    table.append(
      row(
        name,
        scenes.map(({ closure }) => withUnit(value(closure), unit, digits)),
        of,
      ),
    )
  table.append(
    row(
      'Circumferential strain, 99th percentile',
      scenes.map(({ closure }) => percent(closure.strain_circumferential_max)),
      'strain',
    ),
  )
  table.append(
    row(
      'Radial strain, 99th percentile',
      scenes.map(({ closure }) => percent(closure.strain_radial_max)),
      'strain',
    ),
  )
  const names = after ? ['before the repair', 'after it'] : ['of this closure']
  return h('div', {}, ...scenes.map(({ closure }, i) => distrust(closure, names[i] ?? '')), table)
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
