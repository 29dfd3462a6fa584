// One ranked plan: what is done, what it leaves, how sure that is.
import type { Job, RankedPlan } from '../api/types'
import { button, h, type Child } from '../dom'
import { joined, typeset, withUnit } from '../format'
import { term } from '../help/term'
import { HAS_SERVICE } from '../mode'
import { openValveOf, valveOf } from '../jobs/valves'
import { problemList } from '../problems'
import { problemsOf, type Workspace } from '../workspace'
import { downloadButton, meshDownload, reportLink, saveJson } from '../jobs/downloads'
import { evidence } from './evidence'
import { doubts, inWords, isAcceptable, LEAK_BY_EXECUTION, leakFigures, marginWords } from './figures'
import type { Photos } from './photos'
import parts from '../style/parts.module.css'
import searchStyle from './search.module.css'

export interface CardContext {
  job: Job
  workspace: Workspace
  photos: Photos
  signal: AbortSignal
}

export function planPath(job: Job, plan: RankedPlan): string {
  return `/v1/jobs/${job.id}/plans/${plan.rank}`
}

export function cardId({ job }: CardContext, plan: RankedPlan): string {
  return `plan-${job.id}-${plan.rank}`
}

export function photo(plan: RankedPlan, { photos }: CardContext): HTMLElement {
  return photos.photo(plan.plan, `The closed valve seen from the atrium after plan ${plan.rank}: ${inWords(plan)}`)
}

export function planCard(plan: RankedPlan, context: CardContext): HTMLElement {
  const { job, workspace } = context
  const told = h('div', {})
  const said = h('span', { class: parts.hint, role: 'status' })
  const name = `coapt-plan-${plan.rank}`
  const path = planPath(job, plan)

  async function take(use: () => Promise<void> | void): Promise<void> {
    try {
      await openValveOf(job, workspace)
      await use()
    } catch (error) {
      told.replaceChildren(problemList(problemsOf(error)))
    }
  }
  const tryByHand = () =>
    take(async () => {
      const closing = workspace.setPlan(plan.plan.steps)
      location.hash = '#/repair'
      await closing
    })
  const keep = async (): Promise<void> => {
    const { kept, isNew } = await workspace.keep(`Rank ${plan.rank}: ${inWords(plan)}`, plan.plan, await valveOf(job))
    said.textContent = isNew ? 'Kept; see the list in the Repair view.' : `Already kept as “${kept.name}”.`
  }

  /// Its name tells the plan, for those who hear it alone.
  const of = <E extends HTMLElement>(element: E): E => {
    element.append(h('span', { class: parts.unseen }, ` plan ${plan.rank}`))
    return element
  }
  const more = h('details', { class: parts.more }, of(h('summary', {}, 'Evidence')))
  more.addEventListener('toggle', () => {
    if (more.open && more.children.length === 1) more.append(evidence(plan, context.signal))
  })

  return h(
    'article',
    {
      class: `${parts.panel} ${searchStyle.plan}`,
      id: cardId(context, plan),
      'data-part': 'plan',
      'aria-label': `Plan of rank ${plan.rank}`,
    },
    photo(plan, context),
    h(
      'div',
      { class: searchStyle.about },
      h('div', { class: `${parts.row} ${searchStyle.head}` }, h('h3', {}, `${plan.rank}.`), ...badges(plan)),
      h(
        'ul',
        { class: searchStyle.steps, 'data-part': 'steps' },
        ...(plan.description.length > 0 ? plan.description : ['no repair']).map((step) => h('li', {}, step)),
      ),
      figures(plan),
      warnings(plan),
      h(
        'div',
        { class: parts.row },
        of(button('Try by hand', () => void tryByHand(), { class: parts.primary })),
        of(button('Keep', () => void keep())),
        said,
      ),
      h(
        'div',
        { class: parts.row, role: 'group', 'aria-label': `Downloads of plan ${plan.rank}` },
        ...(HAS_SERVICE
          ? [
              reportLink('Report', `${path}/report`, `${name}.html`, told),
              downloadButton('Picture, before and after', `${path}/picture`, `${name}.png`, told),
              meshDownload(path, name, told),
            ]
          : []),
        button('Plan (JSON)', () => saveJson(`${name}.json`, plan.plan)),
        downloadButton('All results (JSON)', path, `${name}-figures.json`, told),
      ),
      told,
    ),
    more,
  )
}

function badges(plan: RankedPlan): HTMLElement[] {
  const badge = (tone: string, ...words: Child[]) => h('span', { class: `${parts.badge} ${parts[tone]}` }, ...words)
  return [
    isAcceptable(plan) ? badge('good', '✓ ', term('acceptable', 'acceptable')) : badge('warn', '! not acceptable'),
    ...(plan.tie_with_next ? [badge('soft', '= equivalent to the next')] : []),
    ...(plan.pareto ? [badge('soft', term('pareto', 'Pareto'))] : []),
    ...(plan.beaten_by ? [badge('soft', `plan ${plan.beaten_by.rank} is better in ${joined(plan.beaten_by.in)}`)] : []),
  ]
}

function figures(plan: RankedPlan): HTMLElement {
  const { measure } = plan
  const entries: [Child, string][] = [
    ...leakFigures(plan).map(([label, value]): [Child, string] => [
      label === LEAK_BY_EXECUTION ? term('region', label) : label,
      value,
    ]),
    [term('margin', 'Margin to leak'), marginWords(plan)],
    [
      term('coaptation', 'Coaptation, mean (minimum)'),
      `${withUnit(measure.coaptation.height_mean_mm, 'mm')} (${withUnit(measure.coaptation.height_min_mm, 'mm')})`,
    ],
    [term('tension', 'Highest chordal tension'), withUnit(measure.tension_max_n, 'N', 2)],
  ]
  return h(
    'dl',
    { class: searchStyle.planFigures },
    ...entries.map(([label, value]) => h('div', {}, h('dt', {}, label), h('dd', {}, value))),
  )
}

function warnings(plan: RankedPlan): HTMLElement | null {
  const said = [...doubts(plan), ...plan.warnings]
  if (said.length === 0) return null
  return h('ul', { class: searchStyle.warnings }, ...said.map((warning) => h('li', {}, typeset(warning))))
}
