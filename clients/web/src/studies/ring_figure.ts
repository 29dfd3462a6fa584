// What an undersized ring leaves of the orifice (figure 4.9, table 4.2 of the thesis).
import { dataTable } from '../charts/data_table'
import { lineChart } from '../charts/line_chart'
import type { Hue } from '../charts/colours'
import { h } from '../dom'
import { number } from '../format'
import { classesIn, classTitle } from './classes'
import { numberIn, type Row } from './csv'
import { places, spread } from './displacements'
import { sliceMap } from './slice_map'
import { RING_PERCENT } from './thesis'
import chartsStyle from '../charts/charts.module.css'
import parts from '../style/parts.module.css'

const SIZES = [1, 2, 3]

export function ringFigure(rows: Row[], signal: AbortSignal): HTMLElement {
  const classes = classesIn(rows)
  const of = (name: string, size: number) =>
    rows.filter((row) => row.class === name && numberIn(row, 'sizes_below') === size)
  const choices = classes.flatMap((name) =>
    SIZES.map((size): [string, string] => [`${name}:${size}`, `${classTitle(name)}, U${size}`]),
  )
  return h(
    'div',
    {},
    h(
      'p',
      { class: parts.hint },
      'U1 to U3: a ring one to three sizes below the annulus. Orifice in percent of that with the properly sized one at the same displacement, where that is 1 mm² or more. Median and range over transverse and posterior displacements.',
    ),
    h(
      'div',
      { class: chartsStyle.charts },
      ...classes.map((name) =>
        ratioChart(
          name,
          SIZES.map((size) => of(name, size)),
          signal,
        ),
      ),
    ),
    h('h3', {}, 'All displacements'),
    sliceMap({
      title: 'Orifice in percent of that under the proper size,',
      unit: '%',
      none: 'less than 1 mm² to reduce, or not closed',
      column: 'ratio_to_proper_size',
      factor: 100,
      digits: 0,
      choices,
      rowsOf: (choice) => {
        const [name = '', size] = choice.split(':')
        return of(name, Number(size))
      },
    }),
    h('h3', {}, 'Largest share, % (table 4.2)'),
    dataTable(
      'Largest share of the orifice with the proper size, percent, compared with the thesis',
      [{ label: 'displaced' }, ...SIZES.map((size) => ({ label: `U${size}`, numeric: true }))],
      classes.flatMap((name) => [
        [name, ...SIZES.map((size) => number(spread(percentOf(of(name, size))).high))],
        [`${name}, thesis`, ...(RING_PERCENT[name] ?? []).map((share) => number(share))],
      ]),
    ),
  )
}

function percentOf(rows: Row[]): (number | null)[] {
  return rows.map((row) => {
    const ratio = numberIn(row, 'ratio_to_proper_size')
    return ratio === null ? null : 100 * ratio
  })
}

function ratioChart(name: string, bySize: Row[][], signal: AbortSignal): HTMLElement {
  const series = bySize.map((rows, i) => {
    const x = places(rows, 'apical_mm')
    const levels = x.map((apical) => spread(percentOf(rows.filter((row) => numberIn(row, 'apical_mm') === apical))))
    return {
      label: `U${SIZES[i] ?? ''}`,
      hue: i as Hue,
      x,
      y: levels.map((level) => level.median),
      low: levels.map((level) => level.low),
      high: levels.map((level) => level.high),
    }
  })
  const top = Math.max(100, ...series.flatMap((one) => one.high.map((value) => value ?? 0)))
  const ends = series.map((one) => `${one.label} ${number(one.y.at(-1), 0)} %`).join(', ')
  return lineChart(
    {
      title: classTitle(name),
      summary: `Median share at the largest apical displacement: ${ends}.`,
      x: { label: 'apical displacement, mm', lowest: -0.5, highest: (series[0]?.x.at(-1) ?? 6) + 0.5 },
      y: { label: 'share of the orifice, %', highest: 1.02 * top },
      series,
    },
    signal,
  ).element
}
