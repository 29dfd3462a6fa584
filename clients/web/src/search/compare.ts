// Two plans side by side: pictures, both valves turning together, figures with the better one marked, maps.
import type { RankedPlan } from '../api/types'
import { dataTable } from '../charts/data_table'
import { heatScale } from '../charts/heat_map'
import { button, h, type Child } from '../dom'
import { valveOf } from '../jobs/valves'
import { problemList } from '../problems'
import type { SideBySide } from '../viewer/side_by_side'
import { problemsOf } from '../workspace'
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
    turned(a, b, context),
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

let pair: SideBySide | null = null // one of all comparisons: browsers draw a few stages only

/// Both in three dimensions, once asked for; they turn together.
function turned(a: RankedPlan, b: RankedPlan, { job }: CardContext): HTMLElement {
  const place = h('div', {})
  const show = async (): Promise<void> => {
    try {
      const { reference } = await valveOf(job)
      pair ??= (await import('../viewer/side_by_side')).sideBySide()
      place.replaceChildren(pair.element)
      await pair.show([a, b].map(({ rank, plan }) => ({ name: `Rank ${rank}`, reference, plan })))
    } catch (error) {
      place.replaceChildren(problemList(problemsOf(error)))
    }
  }
  place.append(button('Show both in 3D', () => void show()))
  return place
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
