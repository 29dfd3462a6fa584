// Two plans side by side: pictures, figures with the better one marked, maps in one scale.
import type { RankedPlan } from '../api/types'
import { dataTable } from '../charts/data_table'
import { heatScale } from '../charts/heat_map'
import { h, type Child } from '../dom'
import { inWords, picture, type CardContext } from './card'
import { leakMap, mapsMost } from './evidence'
import { FIGURES, judge, shownFigure, tieWords, type Figure } from './figures'
import parts from '../style/parts.module.css'
import searchStyle from './search.module.css'

/// `a` is ranked before `b`.
export function comparison(a: RankedPlan, b: RankedPlan, all: RankedPlan[], context: CardContext): HTMLElement {
  const most = mapsMost([a, b])
  const tie = tieWords(a, b, all)
  const side = (plan: RankedPlan) =>
    h('div', {}, h('h3', {}, `Rank ${plan.rank}: ${inWords(plan)}`), picture(context.job, plan, context.pictures))
  const maps = (plan: RankedPlan) =>
    h('div', {}, h('h3', {}, `Rank ${plan.rank}`), ...plan.leak_map.map((map) => leakMap(map, most)))
  return h(
    'section',
    { class: `${parts.panel} ${searchStyle.comparison}`, 'aria-label': `Ranks ${a.rank} and ${b.rank} compared` },
    h('h2', { tabindex: -1 }, `Ranks ${a.rank} and ${b.rank} compared`),
    tie && h('p', {}, h('strong', {}, tie)),
    h('div', { class: searchStyle.two }, side(a), side(b)),
    dataTable(
      'Figures of both plans',
      [
        { label: 'figure' },
        { label: `rank ${a.rank}`, numeric: true },
        { label: `rank ${b.rank}`, numeric: true },
        { label: 'better' },
      ],
      FIGURES.map((figure) => row(figure, a, b)),
    ),
    a.leak_map.length + b.leak_map.length > 0 && h('div', { class: searchStyle.two }, maps(a), maps(b)),
    a.leak_map.length + b.leak_map.length > 0 && heatScale(most, 'mm² in both'),
  )
}

function row(figure: Figure, a: RankedPlan, b: RankedPlan): Child[] {
  const verdict = judge(figure, a, b)
  const cell = (plan: RankedPlan, better: boolean) =>
    h('span', { class: better && `${parts.good} ${searchStyle.better}` }, better && '✓ ', shownFigure(figure, plan))
  const words = {
    first: `rank ${a.rank}`,
    second: `rank ${b.rank}`,
    same: 'the same',
    within: `not a reliable difference: ${figure.blur?.why ?? ''}`,
    unknown: 'not known',
  }[verdict]
  return [figure.label, cell(a, verdict === 'first'), cell(b, verdict === 'second'), words]
}
