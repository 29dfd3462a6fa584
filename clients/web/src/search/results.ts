// What a search has found: the valve before, ranked plans, two of them compared, the rest of its evidence.
import type { RankedPlan, SearchResult } from '../api/types'
import { dataTable, figure } from '../charts/data_table'
import { h } from '../dom'
import { number, seconds, withUnit } from '../format'
import { grouped } from '../jobs/progress_panel'
import { inWords, planCard, type CardContext } from './card'
import { comparison } from './compare'
import { costChart, endedSeries } from './cost_chart'
import { downloadButton, reportLink } from '../jobs/downloads'

const STOPS: Record<string, string> = {
  evaluation_limit: 'It spent all closures it was given.',
  exhausted: 'Nothing was left to try.',
  no_improvement: 'No better plan came for as long as was asked.',
  target_reached: 'A plan was good enough.',
  time_limit: 'Its time was over.',
  cancelled: 'It was cancelled; this is the best so far.',
}

export function searchResults(result: SearchResult, context: CardContext): HTMLElement {
  return h(
    'div',
    { class: 'results' },
    overview(result, context),
    ...ranked(result.plans, context),
    ...rest(result, context),
  )
}

function overview(result: SearchResult, context: CardContext): HTMLElement {
  const { before } = result
  const told = h('div', {})
  const path = `/v1/jobs/${context.job.id}`
  const facts: [string, string][] = [
    ['Orifice before', withUnit(before.orifice_area_mm2, 'mm²')],
    ['gap before', withUnit(before.coaptation.gap_area_mm2, 'mm²')],
    ['coaptation before, mean', withUnit(before.coaptation.height_mean_mm, 'mm')],
    ['plans tried', `${grouped(result.plans_tried)} of ${grouped(result.plans_possible)}`],
    ['closures', grouped(result.closures)],
    ['time', seconds(result.seconds)],
  ]
  const verdict = result.any_competent
    ? h(
        'p',
        {},
        h('span', { class: 'badge good' }, '✓'),
        ' A plan closes the valve also when the surgeon’s hand varies.',
      )
    : h(
        'p',
        {},
        h('span', { class: 'badge warn' }, '!'),
        ' No plan is known to close the valve also when the surgeon’s hand varies.',
      )
  return h(
    'section',
    { class: 'panel', 'aria-label': 'The search' },
    verdict,
    before.status !== 'converged' &&
      h('p', { class: 'warn' }, 'The valve as it is did not settle: its figures are not to be relied on.'),
    before.crossing && h('p', { class: 'warn' }, 'Leaflets of the valve as it is pass through each other.'),
    h('dl', { class: 'figures' }, ...facts.map(([name, value]) => h('div', {}, h('dt', {}, name), h('dd', {}, value)))),
    h('p', { class: 'hint' }, STOPS[result.stop] ?? result.stop),
    h(
      'div',
      { class: 'row', role: 'group', 'aria-label': 'Downloads of the search' },
      reportLink('Report of the search', `${path}/report`, 'coapt-search.html', told),
      downloadButton('Result (JSON)', `${path}/result`, 'coapt-search.json', told),
    ),
    told,
  )
}

function ranked(plans: RankedPlan[], context: CardContext): HTMLElement[] {
  if (plans.length === 0)
    return [
      h(
        'p',
        { class: 'panel' },
        'No plan was ranked: the search ended before it had one, or every plan is against a rule.',
      ),
    ]
  const compared = h('div', { 'aria-live': 'polite' })
  const chosen: RankedPlan[] = []
  const cards = plans.map((plan) => planCard(plan, context))
  const hint = h(
    'p',
    { class: 'hint' },
    'Choose two plans to compare them. Leak: the larger of the orifice seen from the atrium and the gap between the leaflets. Region: small errors of execution around the plan.',
  )

  const boxOf = (plan: RankedPlan) => cards[plans.indexOf(plan)]?.choose
  cards.forEach((card, i) => {
    card.choose.addEventListener('change', () => {
      const plan = plans[i] as RankedPlan
      if (card.choose.checked) chosen.push(plan)
      else chosen.splice(chosen.indexOf(plan), 1)
      const dropped = chosen.length > 2 ? chosen.shift() : undefined // the one chosen first
      const box = dropped && boxOf(dropped)
      if (box) box.checked = false
      compare()
    })
  })

  function compare(): void {
    const [a, b] = [...chosen].sort((one, other) => one.rank - other.rank)
    if (a && b) compared.replaceChildren(comparison(a, b, plans, context))
    else
      compared.replaceChildren(
        ...(a ? [h('p', { class: 'panel' }, `Rank ${a.rank} is chosen: choose another one to compare it with.`)] : []),
      )
    if (a && b) compared.scrollIntoView({ block: 'start' })
  }

  return [
    h(
      'h2',
      { class: 'plans-title' },
      plans.length === 1 ? 'One ranked plan' : `${plans.length} ranked plans, best first`,
    ),
    hint,
    compared,
    ...cards.map((card) => card.element),
  ]
}

function rest(result: SearchResult, context: CardContext): HTMLElement[] {
  const parts: HTMLElement[] = []
  if (result.progress.length > 0) {
    const chart = costChart(endedSeries(result.progress, result.random_progress), context.signal)
    parts.push(h('section', { class: 'panel', 'aria-label': 'How the search went' }, chart.element))
  }
  if (result.pareto_front.length > 0)
    parts.push(
      listed(
        'Pareto front',
        'No other plan that was tried is as good in mean, sd, steps and undersizing, and better in one.',
        dataTable(
          'Pareto front',
          [
            { label: 'plan' },
            { label: 'leak, mean, mm²', numeric: true },
            { label: 'sd, mm²', numeric: true },
            { label: 'steps', numeric: true },
            { label: 'ring sizes below', numeric: true },
            { label: 'region points', numeric: true },
          ],
          result.pareto_front.map((plan) => [
            inWords(plan),
            figure(plan.mean_mm2),
            figure(plan.sd_mm2),
            plan.steps,
            number(plan.ring_sizes_below),
            plan.nodes,
          ]),
        ),
      ),
    )
  if (result.cut.length > 0)
    parts.push(
      listed(
        'What was left out',
        '',
        dataTable(
          'What was left out',
          [{ label: 'what' }, { label: 'why' }],
          result.cut.map(({ what, why }) => [what, why]),
        ),
      ),
    )
  return parts
}

function listed(title: string, hint: string, table: HTMLElement): HTMLElement {
  return h(
    'section',
    { class: 'panel' },
    h('details', { class: 'more' }, h('summary', {}, title), hint && h('p', { class: 'hint' }, hint), table),
  )
}
