// What a search has found: the valve before, its ranked plans, the rest of its evidence.
import type { SearchResult } from '../api/types'
import { dataTable } from '../charts/data_table'
import { h } from '../dom'
import { leakEstimate, leakInFull } from '../estimate'
import { grouped, seconds, withUnit } from '../format'
import { HAS_SERVICE } from '../mode'
import type { CardContext } from './card'
import { costChart, endedSeries } from './cost_chart'
import { downloadButton, reportLink } from '../jobs/downloads'
import { leakOf } from './figures'
import { differing, inShort } from './in_short'
import { ranked } from './ranked'
import jobsStyle from '../jobs/jobs.module.css'
import parts from '../style/parts.module.css'
import searchStyle from './search.module.css'

const STOPS: Record<string, string> = {
  evaluation_limit: 'The search used all its closures.',
  exhausted: 'No plan was left to try.',
  no_improvement: 'The search found no better plan within the given number of closures.',
  target_reached: 'A plan reached the target.',
  time_limit: 'The search reached its time limit.',
  cancelled: 'The search was cancelled; these are the best plans so far.',
}

export function searchResults(result: SearchResult, context: CardContext): HTMLElement {
  return h(
    'div',
    { class: jobsStyle.results },
    overview(result, context),
    ...ranked(result, context),
    ...rest(result, context),
  )
}

function overview(result: SearchResult, context: CardContext): HTMLElement {
  const { before } = result
  const told = h('div', {})
  const path = `/v1/jobs/${context.job.id}`
  const asked = inShort(differing(result.reproduce.search))
  const [first] = result.plans
  const facts: [string, string][] = [
    ['leak before', leakInFull(leakEstimate(before))],
    ...(first ? [['leak with plan 1', leakInFull(leakOf(first))] satisfies [string, string]] : []),
    ['coaptation before, mean', withUnit(before.coaptation.height_mean_mm, 'mm')],
    ['plans tried', `${grouped(result.plans_tried)} of ${grouped(result.plans_possible)}`],
    ['closures', grouped(result.closures)],
    ['time', seconds(result.seconds)],
  ]
  const verdict = result.any_competent
    ? h(
        'p',
        {},
        h('span', { class: `${parts.badge} ${parts.good}` }, '✓'),
        ' At least one plan is acceptable: it leaks less than 5 mm², including the errors of execution, tissue and mesh.',
      )
    : h(
        'p',
        {},
        h('span', { class: `${parts.badge} ${parts.warn}` }, '!'),
        ' No plan is acceptable: none is known to leak less than 5 mm², including the errors of execution, tissue and mesh.',
      )
  return h(
    'section',
    { class: parts.panel, 'aria-label': 'The search' },
    result.diagnosis && h('p', { 'data-part': 'diagnosis' }, result.diagnosis.sentence),
    verdict,
    before.status !== 'converged' &&
      h('p', { class: parts.warn }, 'The closure before repair did not converge; its results are unreliable.'),
    before.crossing && h('p', { class: parts.warn }, 'Before repair the leaflets cross; the results are unreliable.'),
    h(
      'div',
      { class: searchStyle.overview },
      context.photos.photo(null, 'The closed valve seen from the atrium, before repair'),
      h(
        'div',
        {},
        h(
          'dl',
          { class: parts.figures },
          ...facts.map(([name, value]) => h('div', {}, h('dt', {}, name), h('dd', {}, value))),
        ),
        h('p', { class: parts.hint }, `Request: ${asked}. ${STOPS[result.stop] ?? result.stop}`),
      ),
    ),
    h(
      'div',
      { class: parts.row, role: 'group', 'aria-label': 'Downloads of the search' },
      HAS_SERVICE && reportLink('Report of the search', `${path}/report`, 'coapt-search.html', told),
      context.job.links.evaluations &&
        downloadButton('Every plan tried (CSV)', context.job.links.evaluations, 'coapt-plans-tried.csv', told),
      downloadButton('Result (JSON)', `${path}/result`, 'coapt-search.json', told),
    ),
    told,
  )
}

function rest(result: SearchResult, context: CardContext): HTMLElement[] {
  const sections: HTMLElement[] = []
  if (result.progress.length > 0) {
    const chart = costChart(endedSeries(result.progress, result.random_progress), context.signal)
    sections.push(h('section', { class: parts.panel, 'aria-label': 'How the search went' }, chart.element))
  }
  if (result.cut.length > 0)
    sections.push(
      listed(
        'Techniques not considered',
        dataTable(
          'Techniques not considered',
          [{ label: 'what' }, { label: 'why', sentences: true }],
          result.cut.map(({ what, why }) => [what, why]),
        ),
      ),
    )
  return sections
}

function listed(title: string, table: HTMLElement): HTMLElement {
  return h('section', { class: parts.panel }, h('details', { class: parts.more }, h('summary', {}, title), table))
}
