// Lines over one axis: values under the pointer or the arrow keys, a legend that shows and hides, a table of the same.
import uPlot from 'uplot'
import 'uplot/dist/uPlot.min.css'
import { h } from '../dom'
import { onTheme } from '../shell/theme'
import { colourOf, hueClass } from './colours'
import { asTable, dataTable, figure } from './data_table'
import { roundDown, roundsIn } from './rounds'
import { aligned, readAt, type Series } from './series'
import chartsStyle from './charts.module.css'

export interface LineChart {
  title: string
  summary: string // in words, for those who cannot see it
  x: { label: string; lowest?: number; highest?: number; log?: boolean }
  y: { label: string; highest?: number; clip?: number } // clip: at so many times the lowest value
  series: Series[]
}

export interface DrawnChart {
  element: HTMLElement
  show(series: Series[], summary: string): void // in place of those before: as many
}

const HEIGHT_PX = 260
const WHOLE = roundsIn(1, 1e6) // between the ticks of whole numbers
const LOG_DECADE = 10 // between the ends of a logarithmic axis, at least
const LOG_AXIS: uPlot.Axis = {
  splits: (_u, _axis, low, high) => roundsIn(low, high),
  values: (_u, at: (number | null)[]) => at.map((value) => value?.toLocaleString('en-GB') ?? ''),
}
const RANGE_SHIFT_PX = 4 // between the ranges of neighbouring series at one place

/// Drawn until `signal` aborts.
export function lineChart(chart: LineChart, signal: AbortSignal): DrawnChart {
  let series = chart.series
  let plot: uPlot | null = null
  const hidden = new Set<number>()
  const here = h('span', { class: chartsStyle.here })
  const values = series.map(() => h('span', { class: chartsStyle.value, 'data-part': 'value' }))
  const keys = series.map((one) =>
    h('span', { class: `${chartsStyle.key} ${hueClass(one.hue)} ${chartsStyle[one.look ?? 'line'] ?? ''}` }),
  )
  const legend = h('div', {
    class: chartsStyle.legend,
    'data-part': 'legend',
    role: 'group',
    'aria-label': `Lines of ${chart.title}`,
  })
  series.forEach((one, i) => {
    const toggle = h(
      'button',
      { type: 'button', 'aria-pressed': 'true', onclick: () => switchLine(i) },
      keys[i],
      one.label,
      values[i],
    )
    legend.append(toggle)
  })
  const canvas = h('div', { class: chartsStyle.plot, 'data-part': 'plot', role: 'img', tabindex: 0 })
  tell(chart.summary)
  canvas.addEventListener('keydown', (event) => step(event))
  const element = h(
    'figure',
    { class: chartsStyle.chart },
    h('figcaption', {}, h('strong', {}, chart.title), here),
    canvas,
    legend,
    asTable(() => table(chart, series), `Show as table (${chart.y.label})`),
  )

  function tell(summary: string): void {
    canvas.setAttribute('aria-label', `${chart.title}. ${summary}`)
  }

  function switchLine(i: number): void {
    if (!hidden.delete(i)) hidden.add(i)
    legend.children[i]?.setAttribute('aria-pressed', String(!hidden.has(i)))
    plot?.setSeries(i + 1, { show: !hidden.has(i) })
  }

  function step(event: KeyboardEvent): void {
    const way = event.key === 'ArrowRight' ? 1 : event.key === 'ArrowLeft' ? -1 : 0
    if (way === 0 || plot === null) return
    event.preventDefault()
    const xs = plot.data[0]
    const at = plot.cursor.idx ?? (way > 0 ? -1 : xs.length)
    const next = Math.max(0, Math.min(xs.length - 1, at + way))
    plot.setCursor({ left: plot.valToPos(xs[next] as number, 'x'), top: 10 })
  }

  /// What the lines are at the pointer.
  function read(u: uPlot): void {
    const idx = u.cursor.idx
    here.textContent = idx === null || idx === undefined ? '' : `${chart.x.label}: ${figure(u.data[0][idx])}`
    values.forEach((value, i) => {
      const place = u.cursor.idxs?.[i + 1]
      value.textContent = idx === null || place === null || place === undefined ? '' : figure(u.data[i + 1]?.[place])
    })
  }

  function draw(): void {
    if (signal.aborted || !element.isConnected || canvas.clientWidth === 0) return
    plot?.destroy()
    plot = new uPlot(options(), data(), canvas)
  }

  function data(): uPlot.AlignedData {
    const { x, y } = aligned(series)
    return [x, ...y]
  }

  function options(): uPlot.Options {
    const ink = colourOf(element)
    const soft = getComputedStyle(here).color
    const font = '12px system-ui, sans-serif'
    const axis = { stroke: soft, font, labelFont: font, labelSize: 20, ticks: { show: false } }
    const grid = { stroke: getComputedStyle(canvas).borderTopColor, width: 1 }
    return {
      width: canvas.clientWidth,
      height: HEIGHT_PX,
      legend: { show: false },
      cursor: {
        y: false,
        drag: { x: false, y: false },
        dataIdx: (u, line, at) => (line === 0 ? at : readAt(series[line - 1]?.look, u.data[line] ?? [], at)),
      },
      scales: {
        x: { time: false, distr: chart.x.log ? 3 : 1, range: (_u, low, high) => xRange(chart, low, high) },
        y: { range: (_u, low, high) => yRange(chart, low, high) },
      },
      axes: [
        {
          ...axis,
          label: chart.x.label,
          grid: { show: false },
          size: 30,
          ...(series.every((one) => one.x.every(Number.isInteger)) ? { incrs: WHOLE } : {}),
          ...(chart.x.log ? LOG_AXIS : {}),
        },
        {
          ...axis,
          label: chart.y.label,
          grid,
          size: 52,
        },
      ],
      series: [
        {},
        ...series.map((one, i) => {
          const stroke = one.hue === 'ink' ? ink : colourOf(keys[i] as Element)
          const dots = one.look === 'dots'
          return {
            label: one.label,
            stroke,
            show: !hidden.has(i),
            width: dots ? 0 : 2,
            spanGaps: true,
            points: {
              show: dots || (one.look === undefined && one.x.length <= 40),
              size: dots ? 9 : 5,
              stroke,
              fill: dots ? 'transparent' : stroke,
              width: dots ? 2 : 1,
            },
            ...(one.look === 'dashed' ? { dash: [6, 4] } : {}),
            ...(one.look === 'steps'
              ? { paths: (uPlot.paths.stepped as uPlot.Series.SteppedPathBuilderFactory)({ align: 1 }) }
              : {}),
          }
        }),
      ],
      hooks: { setCursor: [read], draw: [(u) => drawRanges(u, series, hidden)] },
    }
  }

  const watch = new ResizeObserver(() => {
    if (plot && canvas.clientWidth > 0) plot.setSize({ width: canvas.clientWidth, height: HEIGHT_PX })
    else draw()
  })
  watch.observe(canvas)
  onTheme(draw, signal)
  signal.addEventListener('abort', () => {
    watch.disconnect()
    plot?.destroy()
  })
  return {
    element,
    show(others, summary) {
      series = others
      tell(summary)
      plot?.setData(data())
    },
  }
}

function yRange({ y }: LineChart, low: number, high: number): [number, number] {
  if (y.clip !== undefined && low > 0) return [0.9 * low, Math.max(1.2 * low, Math.min(1.05 * high, y.clip * low))]
  return [0, y.highest ?? (high > 0 ? 1.05 * high : 1)]
}

function xRange(chart: LineChart, low: number, high: number): [number, number] {
  if (chart.x.log) return [roundDown(low), Math.max(high, LOG_DECADE * roundDown(low))]
  const from = chart.x.lowest ?? low
  const to = chart.x.highest ?? high
  return to > from ? [from, to] : [from - 1, from + 1]
}

function drawRanges(u: uPlot, series: Series[], hidden: Set<number>): void {
  const { ctx } = u
  series.forEach((one, i) => {
    const line = u.series[i + 1]
    if (!one.low || !one.high || hidden.has(i) || !line) return
    ctx.save()
    ctx.strokeStyle = (line.stroke as (u: uPlot, i: number) => string)(u, i + 1)
    ctx.lineWidth = devicePixelRatio
    const shift = RANGE_SHIFT_PX * devicePixelRatio * (i - (series.length - 1) / 2)
    one.x.forEach((place, k) => {
      const low = one.low?.[k]
      const high = one.high?.[k]
      if (low === null || low === undefined || high === null || high === undefined) return
      const left = u.valToPos(place, 'x', true) + shift
      ctx.beginPath()
      ctx.moveTo(left, u.valToPos(low, 'y', true))
      ctx.lineTo(left, u.valToPos(high, 'y', true))
      ctx.stroke()
    })
    ctx.restore()
  })
}

function table(chart: LineChart, series: Series[]): HTMLElement {
  const { x, y } = aligned(series)
  const columns = [chart.x.label, ...series.map((one) => one.label)]
  return dataTable(
    `${chart.title}: ${chart.y.label}`,
    columns.map((label) => ({ label, numeric: true })),
    x.map((place, row) => [figure(place), ...y.map((line) => figure(line[row]))]),
  )
}
