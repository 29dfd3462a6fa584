// The Pareto front of all plans tried: their names, the chart's points of those that are not ranked, their table.
import type { FrontPlan, SearchResult } from '../api/types'
import { dataTable, figure } from '../charts/data_table'
import type { ScatterPoint } from '../charts/scatter_chart'
import { h } from '../dom'
import { number } from '../format'
import { FURTHEST_DISEASE_MM } from './figures'
import { shortSteps } from './plan_table'
import { rankedCost } from './price'
import { placeOf, tradeInWords, tradeOfFront } from './trade'
import parts from '../style/parts.module.css'
import searchStyle from './search.module.css'

export interface FrontRow {
  name: string // the rank, or a letter: A, B, ..., Z, AA, ...
  isRanked: boolean
  plan: FrontPlan
}

type Plans = Pick<SearchResult, 'plans' | 'pareto_front'>

/// By the plans of the front. A plan is ranked if a ranked one has the same document.
export function frontRows({ plans, pareto_front }: Plans): FrontRow[] {
  const ranks = new Map(plans.map(({ plan, rank }) => [JSON.stringify(plan), rank]))
  let unranked = 0
  return pareto_front.map((plan) => {
    const rank = ranks.get(JSON.stringify(plan.plan))
    return { name: rank === undefined ? letters(unranked++) : String(rank), isRanked: rank !== undefined, plan }
  })
}

export function unrankedPoints(result: Plans): ScatterPoint[] {
  return frontRows(result).flatMap(({ name, isRanked, plan }): ScatterPoint[] => {
    const trade = tradeOfFront(plan)
    const place = placeOf(trade)
    if (isRanked || !place) return []
    const words = `Plan ${name}: ${tradeInWords(trade)}, Pareto-optimal. Not ranked, because it was closed at only ${plan.nodes} region points.`
    return [{ ...place, name, words, isRinged: true, isSmall: true }]
  })
}

const FIGURES: [label: string, unit: string][] = [
  ['Leak', 'mean, mm²'],
  ['sd', 'mm²'],
  ['Opening', 'cm²'],
  ['Reserve', 'mm'],
  ['Cost', 'mm²'],
  ['Steps', ''],
  ['Undersized', 'ring sizes'],
  ['Region', 'points'],
]

export function frontTable(result: Plans): HTMLElement {
  const table = dataTable(
    'Pareto front',
    [
      { label: 'Name' },
      { label: 'Plan' },
      ...FIGURES.map(([label, unit]) => ({
        label: h('span', {}, label, h('small', { class: searchStyle.unit }, unit)),
        numeric: true,
      })),
    ],
    frontRows(result)
      .map(known(result))
      .map(({ name, plan }) => [
        name,
        shortSteps(plan.plan),
        figure(plan.mean_mm2),
        figure(plan.sd_mm2),
        figure(plan.opening_mm2 == null ? null : plan.opening_mm2 / 100),
        outlasts(plan),
        figure(plan.cost),
        plan.plan.steps.length,
        number(plan.ring_sizes_below),
        plan.nodes,
      ]),
  )
  return h(
    'details',
    { class: parts.more, open: true, 'data-part': 'front' },
    h('summary', {}, 'Pareto front'),
    h(
      'p',
      { class: parts.hint },
      'Pareto-optimal plans (leak, diastolic opening, reserve against progression), sorted by weighted cost. A number is the rank of a plan; a letter denotes an unranked plan.',
    ),
    h('div', { class: searchStyle.ranked }, table),
  )
}

/// A ranked plan has the same figures wherever it is shown: those over the points that it is ranked by.
function known({ plans }: Plans): (row: FrontRow) => FrontRow {
  return (row) => {
    const ranked = row.isRanked && plans.find(({ rank }) => String(rank) === row.name)
    if (!ranked) return row
    const { leak_mm2, region_closures: nodes } = ranked
    const cost = rankedCost(ranked) ?? row.plan.cost
    const [mean_mm2, sd_mm2] = [leak_mm2.mean ?? row.plan.mean_mm2, leak_mm2.sd ?? row.plan.sd_mm2]
    return { ...row, plan: { ...row.plan, mean_mm2, sd_mm2, cost, nodes } }
  }
}

function letters(i: number): string {
  return (i < 26 ? '' : letters(Math.floor(i / 26) - 1)) + String.fromCharCode(65 + (i % 26))
}

/// "8.4", "≥ 12.0"
function outlasts({ durability_mm }: Pick<FrontPlan, 'durability_mm'>): string {
  return `${(durability_mm ?? 0) >= FURTHEST_DISEASE_MM ? '≥ ' : ''}${number(durability_mm)}`
}
