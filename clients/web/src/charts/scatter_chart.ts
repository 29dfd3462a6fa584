// Points over two axes, drawn as SVG so that colours follow the theme: their names beside them, what they are under the
// pointer or the arrow keys, a legend and a table of the same.
import { h, svg } from '../dom'
import { number } from '../format'
import type { Box } from '../viewer/label_layout'
import { asTable } from './data_table'
import { axisOf, placeOn, type Axis } from './scatter_axes'
import { largestFirst, legendOf, markOf, namesOf, type Legend, type Mark } from './scatter_marks'
import chartsStyle from './charts.module.css'

export interface ScatterPoint extends Omit<Mark, 'left' | 'top'> {
  x: number
  y: number
  words: string // all that is known of it
}

export interface ScatterChart {
  title: string
  summary: string // in words, for those who cannot see it
  x: ScatterAxis & { most: number } // from 0; a point aside, or above `most`, does not stretch it, but stands at its end
  y: ScatterAxis
  points: ScatterPoint[] // in the order of the arrow keys
  legend: Legend
  table: () => HTMLElement
}

interface ScatterAxis {
  label: string
  least: number // span
  /// A line, where it lies on the axis; the label stands to the right of one across x, or left without room, and below one
  /// across y.
  limit?: { value: number; label: string }
}

const HEIGHT_PX = 320
const MARGIN_PX = { left: 50, right: 16, top: 16, bottom: 42 }
const INSET_PX = 16 // a point at the start of x covers no tick
const LETTER_PX = 6.5 // of a limit's label
const POINTED_PX = 24 // the pointer may be off by this

/// Drawn until `signal` aborts.
export function scatterChart(chart: ScatterChart, signal: AbortSignal): HTMLElement {
  const here = h('span', { class: chartsStyle.here, role: 'status', 'data-part': 'here' })
  const plot = h('div', {
    class: `${chartsStyle.plot} ${chartsStyle.scatter}`,
    'data-part': 'plot',
    role: 'img',
    tabindex: 0,
    'aria-label': `${chart.title}. ${chart.summary}`,
  })
  const { points } = chart
  const longest = points.map(({ words }) => words).sort((a, b) => b.length - a.length)[0] ?? ''
  const room = h('span', { class: chartsStyle.here, 'aria-hidden': 'true' }, longest) // for any of the words
  let marks: Mark[] = [] // by the points
  let drawn: SVGElement[] = [] // by the points
  let told = -1

  function tell(next: number): void {
    drawn[told]?.classList.remove(chartsStyle.told as string)
    told = next
    drawn[told]?.classList.add(chartsStyle.told as string)
    const words = points[told]?.words ?? ''
    if (here.textContent !== words) here.textContent = words
  }

  function draw(): void {
    const width = plot.clientWidth
    if (width === 0) return
    const frame = frameOf(chart, width)
    marks = points.map(frame.mark)
    drawn = marks.map(markOf)
    const shown = largestFirst(marks).map((i) => drawn[i] as SVGElement)
    const names = namesOf(marks, frame.kept, { width, height: HEIGHT_PX - MARGIN_PX.bottom })
    plot.replaceChildren(
      svg('svg', { width, height: HEIGHT_PX, 'aria-hidden': 'true' }, ...frame.lines, ...names, ...shown),
    )
    tell(told)
  }

  plot.addEventListener('keydown', (event) => {
    const way = event.key === 'ArrowRight' ? 1 : event.key === 'ArrowLeft' ? -1 : 0
    if (way === 0) return
    event.preventDefault()
    const next = told < 0 && way < 0 ? points.length - 1 : told + way
    tell(Math.max(0, Math.min(points.length - 1, next)))
  })
  plot.addEventListener('pointermove', ({ clientX, clientY }) => {
    const { left, top } = plot.getBoundingClientRect()
    tell(nearest(marks, clientX - left, clientY - top))
  })
  plot.addEventListener('pointerleave', () => tell(-1))
  plot.addEventListener('blur', () => tell(-1))
  const watch = new ResizeObserver(draw)
  watch.observe(plot)
  signal.addEventListener('abort', () => watch.disconnect())
  return h(
    'figure',
    { class: chartsStyle.chart },
    h('figcaption', {}, h('strong', {}, chart.title), h('span', { class: chartsStyle.room }, here, room)),
    plot,
    legendOf(chart.legend, points),
    asTable(chart.table),
  )
}

/// The axes with their lines, where no name may stand, and the mark of a point between them.
function frameOf({ x, y, points }: ScatterChart, width: number) {
  const stretching = points.filter((point) => point.level !== 'aside' && point.x <= x.most)
  const across = axisOf([0, ...stretching.map((point) => point.x)], x.least)
  const along = axisOf(
    points.map((point) => point.y),
    y.least,
  )
  const [left, right] = [MARGIN_PX.left, width - MARGIN_PX.right]
  const [top, bottom] = [MARGIN_PX.top, HEIGHT_PX - MARGIN_PX.bottom]
  const toLeft = placeOn(across, left + INSET_PX, right)
  const toTop = placeOn(along, bottom, top)
  const line = (name: string | undefined, x1: number, y1: number, x2: number, y2: number) =>
    svg('line', { class: name, x1, y1, x2, y2 })
  const text = (words: string, x: number, y: number, anchor: string) =>
    svg('text', { x, y, 'text-anchor': anchor }, words)
  const kept: Box[] = [{ left: 0, right: left, top: 0, bottom: HEIGHT_PX }] // ticks; labels of limits
  const lines: SVGElement[] = along.ticks.flatMap((tick) => [
    line(chartsStyle.grid, left, toTop(tick), right, toTop(tick)),
    text(number(tick, along.digits), left - 8, toTop(tick) + 4, 'end'),
  ])
  lines.push(...across.ticks.map((tick) => text(number(tick, across.digits), toLeft(tick), bottom + 18, 'middle')))
  lines.push(text(x.label, (left + right) / 2, HEIGHT_PX - 6, 'middle'))
  const upwards = text(y.label, 0, 0, 'middle')
  upwards.setAttribute('transform', `translate(13 ${(top + bottom) / 2}) rotate(-90)`)
  lines.push(upwards)
  if (x.limit && isInside(across, x.limit.value)) {
    const at = toLeft(x.limit.value)
    const long = LETTER_PX * x.limit.label.length
    const start = at + 5 + long < width ? at + 5 : at - 5 - long
    const label =
      start > at ? text(x.limit.label, at + 5, bottom - 6, 'start') : text(x.limit.label, at - 5, bottom - 6, 'end')
    lines.push(line(chartsStyle.limit, at, top, at, bottom), label)
    kept.push({ left: start, right: start + long, top: bottom - 18, bottom })
  }
  if (y.limit && isInside(along, y.limit.value)) {
    const at = toTop(y.limit.value)
    lines.push(line(chartsStyle.limit, left, at, right, at), text(y.limit.label, left + 5, at + 14, 'start'))
    kept.push({ left, right: left + 5 + LETTER_PX * y.limit.label.length, top: at, bottom: at + 18 })
  }
  const mark = (point: ScatterPoint): Mark => ({
    ...point,
    left: Math.min(toLeft(point.x), right),
    top: toTop(point.y),
    name: point.x > across.to ? `${point.name} →` : point.name,
  })
  return { lines, kept, mark }
}

function isInside({ from, to }: Axis, value: number): boolean {
  return value > from && value < to
}

/// The index of the mark at the pointer; -1: none.
function nearest(marks: Mark[], left: number, top: number): number {
  const distances = marks.map((mark) => Math.hypot(mark.left - left, mark.top - top))
  const least = Math.min(...distances)
  return least <= POINTED_PX ? distances.indexOf(least) : -1
}
