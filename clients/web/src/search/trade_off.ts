// What plans trade: leak against opening in diastole, and the further disease that they outlast. A front in three
// quantities is no line in two: Pareto-optimal plans are ringed, not joined.
import type { RankedPlan, SearchResult } from '../api/types'
import { dataTable } from '../charts/data_table'
import { LEVELS, type Level } from '../charts/scatter_marks'
import { scatterChart, type ScatterPoint } from '../charts/scatter_chart'
import { h } from '../dom'
import { cm2, joined, number, withUnit } from '../format'
import { doubts, FURTHEST_DISEASE_MM, openingMm2, type Opened } from './figures'
import { STENOSIS_MM2 } from './order'
import parts from '../style/parts.module.css'

const LEVEL_MM = FURTHEST_DISEASE_MM / LEVELS
const COMPETENT_MM2 = 1
const TITLE = 'Leak against opening in diastole'

export function tradeOff(result: SearchResult, signal: AbortSignal): HTMLElement {
  const points = tradePoints(result)
  const chart =
    points.some(({ level }) => level !== 'aside') &&
    scatterChart(
      {
        title: TITLE,
        summary: tradeSummary(result),
        x: {
          label: 'leak over the region, mean + sd, mm²',
          least: 1.2 * COMPETENT_MM2,
          limit: { value: COMPETENT_MM2, label: 'above 1 mm²: not robust' },
        },
        y: {
          label: 'opening, cm²',
          least: 1,
          limit: { value: STENOSIS_MM2 / 100, label: 'below 1.5 cm²: stenosis' },
        },
        points,
        legend: {
          title: 'Outlasts further disease of',
          levels: Array.from({ length: LEVELS }, (_, i) => `${i * LEVEL_MM} to ${(i + 1) * LEVEL_MM} mm`),
          unknown: 'not known',
          ringed: 'Pareto-optimal',
          aside: 'before repair',
        },
        table: () => tradeTable(result),
      },
      signal,
    )
  return h(
    'section',
    { class: parts.panel, 'aria-label': 'What the plans trade', 'data-part': 'trade-off' },
    h('h2', {}, 'What the plans trade'),
    chart,
    chart && h('p', { class: parts.hint }, tradeSummary(result)),
    ...lacking(result.plans).map((words) => h('p', { class: parts.hint }, words)),
  )
}

/// In the order of the ranks; at the end the valve before repair, if it was opened.
export function tradePoints({ before, plans }: SearchResult): ScatterPoint[] {
  const points = plans.flatMap((plan): ScatterPoint[] => {
    const [leak, opening] = [upperLeak(plan), openingMm2(plan)]
    if (leak === null || opening === null) return []
    const said = [
      `leak ${withUnit(leak, 'mm²')} (mean + sd)`,
      `opening ${cm2(opening)}`,
      plan.durability_mm == null ? '' : `outlasts ${outlasted(plan.durability_mm)} of further disease`,
      plan.pareto ? 'Pareto-optimal' : '',
    ]
    return [
      {
        x: leak,
        y: opening / 100,
        name: String(plan.rank),
        words: [`Plan ${plan.rank}: ${said.filter(Boolean).join(', ')}.`, ...doubts(plan)].join(' '),
        level: levelOf(plan.durability_mm ?? null),
        isRinged: plan.pareto,
      },
    ]
  })
  const opening = openingMm2(before)
  if (opening === null || before.leak_mm2 === null) return points
  return [
    ...points,
    {
      x: before.leak_mm2,
      y: opening / 100,
      name: 'before',
      words: `Before repair: leak ${withUnit(before.leak_mm2, 'mm²')} as it is, opening ${cm2(opening)}.`,
      level: 'aside',
      isRinged: false,
    },
  ]
}

export function tradeSummary({ before, plans }: SearchResult): string {
  const shown = plans.filter((plan) => upperLeak(plan) !== null && openingMm2(plan) !== null)
  const front = shown.filter(({ pareto }) => pareto).map(({ rank }) => String(rank))
  const lasting = shown.flatMap(({ durability_mm }) => (durability_mm == null ? [] : [durability_mm]))
  const opening = openingMm2(before)
  return [
    `Up and to the left is better: leak ${range(
      shown.map((plan) => upperLeak(plan) ?? 0),
      'mm²',
    )} (mean + sd), opening ${range(
      shown.map((plan) => (openingMm2(plan) ?? 0) / 100),
      'cm²',
    )}.`,
    ...(lasting.length > 0
      ? [`They outlast ${range(lasting, 'mm')} of further disease, of ${FURTHEST_DISEASE_MM} tried.`]
      : []),
    ...(front.length > 0 ? [`Pareto-optimal: ${front.length === 1 ? 'plan' : 'plans'} ${joined(front)}.`] : []),
    ...(opening === null ? [] : [`Before repair: ${withUnit(before.leak_mm2, 'mm²')} and ${cm2(opening)}.`]),
  ].join(' ')
}

/// What the chart lacks, and why.
export function lacking(plans: RankedPlan[]): string[] {
  const noChart = ', so there is no chart'
  return [
    {
      what: 'The leak over the region',
      why: 'it was not closed',
      isKnown: (plan: RankedPlan) => upperLeak(plan) !== null,
      ifOfAll: noChart,
    },
    {
      what: 'The opening',
      why: 'the valve was not opened, or did not come to rest',
      isKnown: (plan: RankedPlan) => openingMm2(plan) !== null,
      ifOfAll: noChart,
    },
    {
      what: 'How much further disease a repair outlasts',
      why: 'that takes the evidence of a search',
      isKnown: ({ durability_mm }: RankedPlan) => durability_mm != null,
      ifOfAll: '',
    },
  ].flatMap(({ what, why, isKnown, ifOfAll }) => {
    const ranks = plans.filter((plan) => !isKnown(plan)).map(({ rank }) => String(rank))
    if (ranks.length === 0) return []
    if (ranks.length === plans.length) return [`${what} is not known for any plan (${why})${ifOfAll}.`]
    return [`${what} is not known for ${ranks.length === 1 ? 'plan' : 'plans'} ${joined(ranks)} (${why}).`]
  })
}

function tradeTable({ before, plans }: SearchResult): HTMLElement {
  const opening = (of: Opened) => {
    const area_mm2 = openingMm2(of)
    return number(area_mm2 === null ? null : area_mm2 / 100)
  }
  return dataTable(
    TITLE,
    [
      { label: 'Plan' },
      { label: 'Leak, mean + sd, mm²', numeric: true },
      { label: 'Opening, cm²', numeric: true },
      { label: 'Outlasts disease, mm', numeric: true },
      { label: 'Pareto-optimal' },
    ],
    [
      ['Before', number(before.leak_mm2), opening(before), '', ''],
      ...plans.map((plan) => [
        plan.rank,
        number(upperLeak(plan)),
        opening(plan),
        plan.durability_mm == null ? number(null) : outlasted(plan.durability_mm).replace(' mm', ''),
        plan.pareto ? 'yes' : 'no',
      ]),
    ],
  )
}

function upperLeak({ leak_mm2: { mean, sd } }: RankedPlan): number | null {
  return mean === null || sd === null ? null : mean + sd
}

function levelOf(durability_mm: number | null): Level {
  return durability_mm === null ? null : Math.min(LEVELS - 1, Math.floor(durability_mm / LEVEL_MM))
}

/// "8.4 mm", "12.0 mm or more"
function outlasted(mm: number): string {
  return `${withUnit(mm, 'mm')}${mm >= FURTHEST_DISEASE_MM ? ' or more' : ''}`
}

/// "0.5 to 3.7 mm²"
function range(values: number[], unit: string): string {
  const [low, high] = [number(Math.min(...values)), number(Math.max(...values))]
  return low === high ? `${low} ${unit}` : `${low} to ${high} ${unit}`
}
