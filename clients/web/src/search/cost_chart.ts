// The best score so far, by which a search climbs (in steps of an operation; in mm² where plans are ranked by price), against what trying plans at random is expected to have reached.
import type { CostPoint, JobProgress } from '../api/types'
import { lineChart } from '../charts/line_chart'
import type { Series } from '../charts/series'
import { h } from '../dom'
import { counted, grouped, number } from '../format'
import parts from '../style/parts.module.css'

const SEARCH = { label: 'coapt', hue: 0 as const, look: 'steps' as const }
const RANDOM = { label: 'random search, expected', hue: 1 as const, look: 'dashed' as const }

export interface CostChart {
  element: HTMLElement
  show(series: Series[]): void
}

export function costChart(series: Series[], signal: AbortSignal): CostChart {
  const said = h('p', { class: parts.hint }, costSummary(series))
  const chart = lineChart(
    {
      title: 'Lowest cost so far',
      summary: costSummary(series),
      x: { label: 'closures', log: true }, // the first of them find most
      y: { label: 'cost (lower is better)', clip: 3 },
      series,
    },
    signal,
  )
  chart.element.hidden = isFlat(series)
  return {
    element: h('div', {}, chart.element, said),
    show(others) {
      chart.element.hidden = isFlat(others)
      said.textContent = costSummary(others)
      chart.show(others, costSummary(others))
    },
  }
}

/// One line that never falls is said, not drawn.
export function isFlat(series: Series[]): boolean {
  return new Set(series.flatMap((one) => one.y)).size < 2
}

/// "Score 2.60 since 24 closures of 2,000. A random search is expected to have 5.28 after 77."
export function costSummary(series: Series[]): string {
  const [ours, random] = series
  const cost = ours?.y.at(-1)
  const closures = ours?.x.at(-1)
  if (cost === undefined || closures === undefined) return 'No plan yet.'
  const since = ours?.x.find((_, i) => ours.y[i] === cost) ?? closures
  const other = random?.y.at(-1)
  return (
    `Cost ${number(cost, 2)}, reached after ${grouped(since)} of ${counted(closures, 'closure')}.` +
    (other === undefined
      ? ''
      : ` A random search would be expected to reach ${number(other, 2)} after ${grouped(random?.x.at(-1) ?? 0)}.`)
  )
}

/// While it runs.
export function liveSeries(progress: JobProgress[]): Series[] {
  const line = (of: (now: JobProgress) => number | null | undefined): CostPoint[] =>
    progress.map((now) => ({ closures: now.closures, cost: of(now) ?? null })).filter((point) => point.cost !== null)
  return costSeries(
    line((now) => now.best_cost),
    line((now) => now.random_cost),
  )
}

/// Of one that has ended: a short one has tried too few plans to say what random search would have.
export function endedSeries(search: CostPoint[], random: CostPoint[]): Series[] {
  return costSeries(search, random).filter((one) => one.x.length > 0)
}

function costSeries(search: CostPoint[], random: CostPoint[]): Series[] {
  return [
    { ...SEARCH, ...pointsOf(search) },
    { ...RANDOM, ...pointsOf(random) },
  ]
}

/// One point per number of closures, the last one said.
function pointsOf(points: CostPoint[]): Pick<Series, 'x' | 'y'> {
  const at = new Map(points.map(({ closures, cost }) => [closures, cost]))
  const x = [...at.keys()].sort((a, b) => a - b)
  return { x, y: x.map((closures) => at.get(closures) ?? null) }
}
