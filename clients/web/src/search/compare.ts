// Two plans side by side: pictures, figures with the better one marked, maps.
import type { RankedPlan } from '../api/types'
import { dataTable } from '../charts/data_table'
import { heatScale } from '../charts/heat_map'
import { h, type Child } from '../dom'
import { photo, type CardContext } from './card'
import { LEAK_LIMITS_MM2, leakMap } from './evidence'
import { FIGURES, inWords, judge, shownFigure, tieWords, type Figure } from './figures'
import parts from '../style/parts.module.css'
import searchStyle from './search.module.css'

/// `a` is ranked before `b`.
export function comparison(a: RankedPlan, b: RankedPlan, all: RankedPlan[], context: CardContext): HTMLElement {
  const tie = tieWords(a, b, all)
  const side = (plan: RankedPlan) =>
    h('div', {}, h('h3', {}, `Rank ${plan.rank}: ${inWords(plan)}`), photo(plan, context))
  const maps = (plan: RankedPlan) =>
    h('div', {}, h('h3', {}, `Rank ${plan.rank}`), ...plan.leak_map.map((map) => leakMap(map, plan)))
  return h(
    'section',
    { class: `${parts.panel} ${searchStyle.comparison}`, 'aria-label': `Ranks ${a.rank} and ${b.rank} compared` },
    h('h2', { tabindex: -1 }, `Ranks ${a.rank} and ${b.rank} compared`),
    tie && h('p', {}, h('strong', {}, tie), ' This applies to the order of the search.'),
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
    a.leak_map.length + b.leak_map.length > 0 && heatScale(LEAK_LIMITS_MM2, 'mm²'),
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
    unknown: 'unknown',
  }[verdict]
  return [figure.label, cell(a, verdict === 'first'), cell(b, verdict === 'second'), words]
}
