// A grid of displacements, one apical level at a time.
import { evenLimits } from '../charts/colours'
import { heatMap, heatScale } from '../charts/heat_map'
import { field, h, select } from '../dom'
import type { Row } from './csv'
import { places, slice } from './displacements'
import parts from '../style/parts.module.css'
import studiesStyle from './studies.module.css'

export interface SliceMap {
  title: string
  unit: string
  column: string
  factor?: number // from the column to the unit
  digits: number
  none?: string // why there is no value
  choices: [name: string, label: string][] // what may be looked at
  rowsOf(choice: string): Row[]
}

export function sliceMap(map: SliceMap): HTMLElement {
  let [choice = ''] = map.choices[0] ?? []
  const holder = h('div', {})
  const level = h('input', { type: 'range', min: 0, step: 1 })
  const shown = h('output', {})
  const scale = h('div', {})
  level.addEventListener('input', draw)

  function draw(): void {
    const rows = map.rowsOf(choice)
    const levels = places(rows, 'apical_mm')
    level.max = String(levels.length - 1)
    const apical = levels[Number(level.value)] ?? 0
    const factor = map.factor ?? 1
    const scaled = (at: number) =>
      slice(rows, at, map.column).map((row) => row.map((value) => (value === null ? null : factor * value)))
    const all = levels.flatMap((at) => scaled(at).flat()).filter((value) => value !== null)
    const limits = evenLimits(Math.max(1, ...all))
    shown.textContent = `${apical} mm`
    level.setAttribute('aria-valuetext', `${apical} mm`)
    holder.replaceChildren(
      heatMap({
        title: `${map.title} at ${apical} mm apical.`,
        unit: map.unit,
        rows: { label: 'posterior displacement, mm', ticks: places(rows, 'posterior_mm').reverse().map(String) },
        columns: { label: 'transverse displacement, mm', ticks: places(rows, 'transverse_mm').map(String) },
        values: scaled(apical),
        limits,
        digits: map.digits,
      }),
    )
    scale.replaceChildren(heatScale(limits, map.unit, map.none))
  }

  const chosen = select(map.choices, choice, (name) => {
    choice = name
    draw()
  })
  level.value = '0'
  draw()
  return h(
    'div',
    { class: studiesStyle.slice },
    h(
      'div',
      { class: studiesStyle.sliceChoice },
      field('Shown', chosen),
      h('label', { class: parts.field }, h('span', {}, 'Apical'), level, shown),
    ),
    holder,
    scale,
  )
}
