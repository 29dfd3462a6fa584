// One ranked plan: what is done, what it leaves, how sure that is.
import type { Job, RankedPlan } from '../api/types'
import { button, h } from '../dom'
import { withUnit } from '../format'
import { openValveOf, valveOf } from '../jobs/valves'
import { problemList } from '../problems'
import { problemsOf, type Workspace } from '../workspace'
import { downloadButton, meshDownload, reportLink, saveJson } from '../jobs/downloads'
import { evidence } from './evidence'
import { doubts, marginWords, meanAndSd } from './figures'
import type { Pictures } from './pictures'
import parts from '../style/parts.module.css'
import searchStyle from './search.module.css'

export interface Card {
  element: HTMLElement
  choose: HTMLInputElement // to compare it
}

export interface CardContext {
  job: Job
  workspace: Workspace
  pictures: Pictures
  signal: AbortSignal
}

export function planPath(job: Job, plan: RankedPlan): string {
  return `/v1/jobs/${job.id}/plans/${plan.rank}`
}

/// "annuloplasty: generic-classic ring, size 30 mm; ..."
export function inWords(plan: { description: string[] }): string {
  return plan.description.length > 0 ? plan.description.join('; ') : 'no repair'
}

export function picture(job: Job, plan: RankedPlan, pictures: Pictures): HTMLElement {
  return pictures.image(
    `${planPath(job, plan)}/picture`,
    `The valve seen from the atrium before and after plan ${plan.rank}: ${inWords(plan)}`,
  )
}

export function planCard(plan: RankedPlan, context: CardContext): Card {
  const { job, workspace } = context
  const told = h('div', {})
  const said = h('span', { class: parts.hint, role: 'status' })
  const choose = h('input', { type: 'checkbox' })
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
    said.textContent = isNew ? 'Kept: see the list in the Repair view.' : `Kept before as “${kept.name}”.`
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

  const element = h(
    'article',
    { class: `${parts.panel} ${searchStyle.plan}`, 'data-part': 'plan', 'aria-label': `Plan of rank ${plan.rank}` },
    picture(job, plan, context.pictures),
    h(
      'div',
      { class: searchStyle.about },
      h(
        'div',
        { class: `${parts.row} ${searchStyle.head}` },
        h('h3', {}, `${plan.rank}.`),
        ...badges(plan),
        h('label', { class: `${parts.check} ${searchStyle.compare}` }, choose, of(h('span', {}, 'Compare'))),
      ),
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
        reportLink('Report', `${path}/report`, `${name}.html`, told),
        meshDownload(path, name, told),
        button('Plan (JSON)', () => saveJson(`${name}.json`, plan.plan)),
        downloadButton('All figures (JSON)', path, `${name}-figures.json`, told),
      ),
      told,
    ),
    more,
  )
  return { element, choose }
}

function badges(plan: RankedPlan): HTMLElement[] {
  const { mean, sd } = plan.leak_mm2
  const robust =
    plan.status === 'converged' &&
    !plan.crossing &&
    plan.region_failures === 0 &&
    mean !== null &&
    sd !== null &&
    mean + sd < 1
  const badge = (words: string, tone: string) => h('span', { class: `${parts.badge} ${parts[tone]}` }, words)
  return [
    ...(robust ? [badge('✓ robust', 'good')] : [badge('! not shown to close robustly', 'warn')]),
    ...(plan.tie_with_next ? [badge('= ties with the next', 'soft')] : []),
    ...(plan.pareto ? [badge('Pareto', 'soft')] : []),
  ]
}

function figures(plan: RankedPlan): HTMLElement {
  const { measure } = plan
  const entries: [string, string][] = [
    ['Leak over the region', meanAndSd(plan.leak_mm2)],
    ['Leak, 95th percentile', withUnit(plan.leak_mm2.p95, 'mm²')],
    ['Orifice over the region', meanAndSd(plan.orifice_area_mm2)],
    [
      'Orifice, gap as planned',
      `${withUnit(measure.orifice_area_mm2, 'mm²')}, ${withUnit(measure.coaptation.gap_area_mm2, 'mm²')}`,
    ],
    ['Margin to leak', marginWords(plan.margin_to_leak)],
    [
      'Coaptation, mean (minimum)',
      `${withUnit(measure.coaptation.height_mean_mm, 'mm')} (${withUnit(measure.coaptation.height_min_mm, 'mm')})`,
    ],
    ['Highest chordal tension', withUnit(measure.tension_max_n, 'N', 2)],
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
  return h('ul', { class: searchStyle.warnings }, ...said.map((warning) => h('li', {}, warning)))
}
