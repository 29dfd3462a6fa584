// Orifice against anteroposterior dilation, for each annular height (figure 4.5 of the thesis).
import { lineChart } from '../charts/line_chart'
import type { Hue } from '../charts/colours'
import type { Series } from '../charts/series'
import { h } from '../dom'
import { number } from '../format'
import { distinct, numberIn, type Row } from './csv'
import { DILATED } from './thesis'
import chartsStyle from '../charts/charts.module.css'

const LEAST_MM2 = 5 // smaller orifices give wild shares

export function annulusFigure(rows: Row[], signal: AbortSignal): HTMLElement {
  const heights = distinct(rows, 'annular_height_percent')
  const of = (height: string) => rows.filter((row) => row.annular_height_percent === height)
  const areas: Series[] = heights.map((height, i) => ({
    label: `height ${height} %`,
    hue: i as Hue,
    x: of(height).map((row) => numberIn(row, 'ap_dilation_percent') ?? 0),
    y: of(height).map((row) => numberIn(row, 'orifice_mm2')),
  }))
  const [full] = areas
  const shares = areas.slice(1).map((one) => ({ ...one, y: one.y.map((area, i) => share(area, full?.y[i] ?? null)) }))
  const dilation = { label: 'anteroposterior dilation, %' }
  const last = full?.y.at(-1)
  return h(
    'div',
    { class: chartsStyle.charts },
    lineChart(
      {
        title: 'Orifice of a dilated and flattened annulus',
        summary: `At ${full?.x.at(-1) ?? 0} % dilation the orifice is ${number(last)} mm² with the full height; the thesis reports ${number(DILATED.mm2.at(-1))} mm² at 30 %.`,
        x: dilation,
        y: { label: 'orifice, mm²' },
        series: [
          ...areas,
          { label: 'thesis, height 100 %', hue: 'ink', look: 'dots', x: DILATED.percent, y: DILATED.mm2 },
        ],
      },
      signal,
    ).element,
    lineChart(
      {
        title: 'Effect of flattening on the orifice',
        summary: 'Orifice with the flattened annulus in percent of that with the full height, at the same dilation.',
        x: dilation,
        y: { label: 'share of the orifice, %' },
        series: shares,
      },
      signal,
    ).element,
  )
}

/// In percent; null where there is too little to be a share of.
function share(area: number | null, of: number | null): number | null {
  return area === null || of === null || of < LEAST_MM2 ? null : (100 * area) / of
}
