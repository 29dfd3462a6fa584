// Orifice against displaced papillary muscles (figures 4.6 to 4.8, table 4.1 of the thesis).
import { dataTable } from '../charts/data_table'
import { lineChart } from '../charts/line_chart'
import type { Hue } from '../charts/colours'
import { h } from '../dom'
import { number } from '../format'
import { classesIn, classTitle } from './classes'
import { mean, numberIn, type Row } from './csv'
import { alone, DIRECTIONS, largestByAxes } from './displacements'
import { sliceMap } from './slice_map'
import { AXES, DISPLACED_MM2 } from './thesis'
import chartsStyle from '../charts/charts.module.css'
import parts from '../style/parts.module.css'

export function papillaryFigure(rows: Row[], signal: AbortSignal): HTMLElement {
  const classes = classesIn(rows)
  const of = (name: string) => rows.filter((row) => row.class === name)
  return h(
    'div',
    {},
    h('div', { class: chartsStyle.charts }, ...classes.map((name) => axesChart(name, of(name), most(rows), signal))),
    h('h3', {}, 'All displacements'),
    sliceMap({
      title: 'Orifice, mm²,',
      unit: 'mm²',
      column: 'orifice_mm2',
      digits: 1,
      choices: classes.map((name) => [name, classTitle(name)]),
      rowsOf: of,
    }),
    h('h3', {}, 'Mean slope of the orifice, mm² per mm'),
    dataTable(
      'Mean slope of the orifice over all displacements, mm² per mm',
      [{ label: 'displaced' }, ...DIRECTIONS.map(([, label]) => ({ label, numeric: true }))],
      classes.map((name) => [
        name,
        ...DIRECTIONS.map(([axis]) =>
          number(mean(of(name).map((row) => numberIn(row, `gradient_${axis.replace('_mm', '')}_mm2_per_mm`)))),
        ),
      ]),
    ),
    h('h3', {}, 'Largest orifice by displaced axes, mm² (table 4.1)'),
    h('p', { class: parts.hint }, 'T transverse, P posterior, A apical; the valve of the thesis is not published.'),
    dataTable(
      'Largest orifice by class and displaced axes, mm², compared with the thesis',
      [{ label: 'displaced' }, ...AXES.map((label) => ({ label, numeric: true }))],
      classes.flatMap((name) => [
        [name, ...largestByAxes(of(name)).map((area) => number(area))],
        [`${name}, thesis`, ...(DISPLACED_MM2[name] ?? []).map((area) => number(area))],
      ]),
    ),
  )
}

/// Of displacements along one axis alone: the charts share their scale.
function most(rows: Row[]): number {
  return (
    1.05 *
    Math.max(1, ...DIRECTIONS.flatMap(([axis]) => alone(rows, axis).map((row) => numberIn(row, 'orifice_mm2') ?? 0)))
  )
}

function axesChart(name: string, rows: Row[], highest: number, signal: AbortSignal): HTMLElement {
  const series = DIRECTIONS.map(([axis, label], i) => ({
    label,
    hue: i as Hue,
    x: alone(rows, axis).map((row) => numberIn(row, axis) ?? 0),
    y: alone(rows, axis).map((row) => numberIn(row, 'orifice_mm2')),
  }))
  const ends = series.map((one) => `${one.label} ${number(one.y.at(-1))} mm²`).join(', ')
  return lineChart(
    {
      title: classTitle(name),
      summary: `Orifice at the largest displacement along one axis: ${ends}.`,
      x: { label: 'displacement, mm' },
      y: { label: 'orifice, mm²', highest },
      series,
    },
    signal,
  ).element
}
