// The best cost so far against what trying plans at random is expected to have reached.
import type { CostPoint, JobProgress } from '../api/types'
import { lineChart, type DrawnChart } from '../charts/line_chart'
import type { Series } from '../charts/series'
import { number } from '../format'

const SEARCH = { label: 'coapt', hue: 0 as const, look: 'steps' as const }
const RANDOM = { label: 'random search, expected', hue: 1 as const, look: 'dashed' as const }

export function costChart(series: Series[], signal: AbortSignal): DrawnChart {
  return lineChart(
    {
      title: 'Best cost so far',
      summary: costSummary(series),
      x: { label: 'closures', lowest: 0 },
      y: { label: 'cost, mm²', log: true },
      series,
    },
    signal,
  )
}

export function costSummary(series: Series[]): string {
  const [ours, random] = series.map((one) => one.y.at(-1))
  if (ours === undefined) return 'No plan yet.'
  return `At the end ${number(ours, 2)} mm²; a random search is expected to reach ${number(random, 2)} mm².`
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

/// One point per number of closures, the last one said. A logarithm knows no zero.
function pointsOf(points: CostPoint[]): Pick<Series, 'x' | 'y'> {
  const at = new Map(points.map(({ closures, cost }) => [closures, cost === null ? null : Math.max(cost, 0.01)]))
  const x = [...at.keys()].sort((a, b) => a - b)
  return { x, y: x.map((closures) => at.get(closures) ?? null) }
}
