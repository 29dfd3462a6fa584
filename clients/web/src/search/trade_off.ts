// What plans trade: leak against opening in diastole, and the further disease that they outlast; the ranked plans and those
// of the Pareto front that are not ranked. A front in three quantities is no line in two: it is ringed, not joined.
import type { RankedPlan, SearchResult } from '../api/types'
import { dataTable } from '../charts/data_table'
import { LEVELS } from '../charts/scatter_marks'
import { scatterChart, type ScatterPoint } from '../charts/scatter_chart'
import { h } from '../dom'
import { cm2, joined, number, withUnit } from '../format'
import { doubts, FURTHEST_DISEASE_MM, openingMm2 } from './figures'
import { frontRows, frontTable, unrankedPoints } from './front'
import { LEVEL_MM, placeOf, tradeCells, tradeInWords, tradeOfFront, tradeOfRanked } from './trade'
import parts from '../style/parts.module.css'
import { TRACE_MM2 } from '../repair/tolerance'

const STENOSIS_MM2 = 150
const GOOD_REPAIR_MM2 = 5 // search/plans/objective.h
const TITLE = 'Leak versus diastolic opening'

export function tradeOff(result: SearchResult, signal: AbortSignal): HTMLElement {
  const ranked = rankedPoints(result.plans)
  const chart =
    ranked.length > 0 &&
    scatterChart(
      {
        title: TITLE,
        summary: tradeSummary(result),
        x: {
          label: 'leak, mean + sd, mm²',
          least: 1.2 * TRACE_MM2,
          most: Math.max(GOOD_REPAIR_MM2, ...ranked.map(({ x }) => x)),
          limit: { value: TRACE_MM2, label: 'from 1 mm²: mild' },
        },
        y: {
          label: 'opening, cm²',
          least: 1,
          limit: { value: STENOSIS_MM2 / 100, label: 'below 1.5 cm²: stenosis' },
        },
        points: tradePoints(result),
        legend: {
          title: 'Reserve against progression',
          levels: Array.from({ length: LEVELS }, (_, i) => `${i * LEVEL_MM} to ${(i + 1) * LEVEL_MM} mm`),
          unknown: 'unknown',
          ringed: 'Pareto-optimal among ranked plans',
          small: 'A, B, …: Pareto-optimal, not ranked',
          aside: 'before repair',
        },
        table: () => tradeTable(result),
      },
      signal,
    )
  return h(
    'section',
    { class: parts.panel, 'aria-label': 'Trade-offs', 'data-part': 'trade-off' },
    h('h2', {}, 'Trade-offs'),
    chart,
    chart && h('p', { class: parts.hint }, tradeSummary(result)),
    ...lacking(result.plans).map((words) => h('p', { class: parts.hint }, words)),
    result.pareto_front.length > 0 && frontTable(result),
  )
}

/// In the order of the ranks, then of the front; at the end the valve before repair, if it was opened.
export function tradePoints(result: SearchResult): ScatterPoint[] {
  const points = [...rankedPoints(result.plans), ...unrankedPoints(result)]
  const { before } = result
  const opening = openingMm2(before)
  if (opening === null || before.leak_mm2 === null) return points
  return [
    ...points,
    {
      x: before.leak_mm2,
      y: opening / 100,
      name: 'before',
      words: `Before repair: leak ${withUnit(before.leak_mm2, 'mm²')}, opening ${cm2(opening)}.`,
      level: 'aside',
      isRinged: false,
      isSmall: false,
    },
  ]
}

function rankedPoints(plans: RankedPlan[]): ScatterPoint[] {
  return plans.flatMap((plan): ScatterPoint[] => {
    const trade = tradeOfRanked(plan)
    const place = placeOf(trade)
    if (!place) return []
    const said = `Plan ${plan.rank}: ${tradeInWords(trade)}${plan.pareto ? ', Pareto-optimal' : ''}.`
    return [
      {
        ...place,
        name: String(plan.rank),
        words: [said, ...doubts(plan)].join(' '),
        isRinged: plan.pareto,
        isSmall: false,
      },
    ]
  })
}

export function tradeSummary(result: SearchResult): string {
  const { before, plans } = result
  const shown = rankedPoints(plans)
  const front = shown.filter(({ isRinged }) => isRinged).map(({ name }) => name)
  const lasting = plans
    .map(tradeOfRanked)
    .flatMap((trade) => (trade.durability_mm === null || !placeOf(trade) ? [] : [trade.durability_mm]))
  const letters = unrankedPoints(result).length
  const opening = openingMm2(before)
  const [leaks, openings] = [shown.map(({ x }) => x), shown.map(({ y }) => y)]
  return [
    `Up and to the left is better: leak ${range(leaks, 'mm²')} (mean + sd), opening ${range(openings, 'cm²')}.`,
    ...(lasting.length > 0
      ? [`Their reserve against progression is ${range(lasting, 'mm')}, up to the simulated ${FURTHEST_DISEASE_MM} mm.`]
      : []),
    ...(front.length > 0 ? [`Pareto-optimal: ${front.length === 1 ? 'plan' : 'plans'} ${joined(front)}.`] : []),
    ...(letters === 1 ? ['A letter denotes an unranked plan of the Pareto front.'] : []),
    ...(letters > 1 ? [`Letters denote ${letters} unranked plans of the Pareto front.`] : []),
    ...(opening === null ? [] : [`Before repair: ${withUnit(before.leak_mm2, 'mm²')} and ${cm2(opening)}.`]),
  ].join(' ')
}

/// What the chart lacks, and why.
export function lacking(plans: RankedPlan[]): string[] {
  const noChart = ', so there is no chart'
  return [
    {
      what: 'The leak with errors of execution',
      why: 'it was not computed',
      isKnown: (plan: RankedPlan) => tradeOfRanked(plan).leak_mm2 !== null,
      ifOfAll: noChart,
    },
    {
      what: 'The opening',
      why: 'the valve was not opened, or did not reach equilibrium',
      isKnown: (plan: RankedPlan) => openingMm2(plan) !== null,
      ifOfAll: noChart,
    },
    {
      what: 'The reserve against progression',
      why: 'it requires the evidence of a search',
      isKnown: ({ durability_mm }: RankedPlan) => durability_mm != null,
      ifOfAll: '',
    },
  ].flatMap(({ what, why, isKnown, ifOfAll }) => {
    const ranks = plans.filter((plan) => !isKnown(plan)).map(({ rank }) => String(rank))
    if (ranks.length === 0) return []
    if (ranks.length === plans.length) return [`${what} is unknown for all plans (${why})${ifOfAll}.`]
    return [`${what} is unknown for ${ranks.length === 1 ? 'plan' : 'plans'} ${joined(ranks)} (${why}).`]
  })
}

function tradeTable(result: SearchResult): HTMLElement {
  const { before, plans } = result
  const asItIs = tradeCells({ leak_mm2: before.leak_mm2, opening_mm2: openingMm2(before), durability_mm: null })
  return dataTable(
    TITLE,
    [
      { label: 'Plan' },
      { label: 'Leak, mean + sd, mm²', numeric: true },
      { label: 'Opening, cm²', numeric: true },
      { label: 'Reserve, mm', numeric: true },
      { label: 'Pareto-optimal' },
    ],
    [
      ['Before', ...asItIs.slice(0, 2), '', ''],
      ...plans.map((plan) => [plan.rank, ...tradeCells(tradeOfRanked(plan)), plan.pareto ? 'yes' : 'no']),
      ...frontRows(result)
        .filter(({ isRanked }) => !isRanked)
        .map(({ name, plan }) => [name, ...tradeCells(tradeOfFront(plan)), 'yes, not ranked']),
    ],
  )
}

/// "0.5 to 3.7 mm²"
function range(values: number[], unit: string): string {
  const [low, high] = [number(Math.min(...values)), number(Math.max(...values))]
  return low === high ? `${low} ${unit}` : `${low} to ${high} ${unit}`
}
