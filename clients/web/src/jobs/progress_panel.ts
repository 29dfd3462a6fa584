// What a running job does: stage, closures of planned, time gone and time left; and the way to end it.
import type { Job, JobProgress } from '../api/types'
import { button, h } from '../dom'
import { grouped, seconds, withUnit, words } from '../format'
import { problemList } from '../problems'
import { problemsOf } from '../workspace'
import { cancelJob } from './calls'
import { noteOf } from './notes'
import { Pace, roughly, SEARCH_SHARES } from './pace'
import { standing, stateBadge } from './state'
import jobsStyle from './jobs.module.css'
import parts from '../style/parts.module.css'

export interface ProgressPanel {
  element: HTMLElement
  show(progress: JobProgress): void
  change(job: Job): void
}

export function progressPanel(first: Job, what: string): ProgressPanel {
  const pace = new Pace(first.kind === 'plans' ? SEARCH_SHARES : null)
  const limit_s = noteOf(first.id)?.limit_s ?? null
  let job = first
  let unit = 'closures'
  const bar = h('progress', { max: 1, 'aria-label': `Progress of the ${what}` })
  const state = h('span', {})
  const stage = h('strong', {})
  const standingText = h('p', { class: parts.hint, 'aria-live': 'polite' })
  const figures = h('dl', { class: parts.figures })
  const failed = h('div', {})
  const cancel = button('Cancel', () => void end())
  const element = h(
    'section',
    { class: `${parts.panel} ${jobsStyle.progress}`, 'data-part': 'progress', 'aria-label': `Running ${what}` },
    h('div', { class: parts.row }, state, stage, cancel),
    bar,
    figures,
    standingText,
    failed,
  )

  async function end(): Promise<void> {
    cancel.disabled = true
    try {
      change({ ...(await cancelJob(job.id)), state: job.state })
    } catch (error) {
      cancel.disabled = false
      failed.replaceChildren(problemList(problemsOf(error)))
    }
  }

  function change(now: Job): void {
    job = now
    state.replaceChildren(stateBadge(job.state))
    standingText.textContent = standing(job)
    cancel.disabled = job.cancel_requested
    if (job.progress.closures > 0) show(job.progress)
  }

  function show(progress: JobProgress): void {
    if (job.kind === 'study') unit = 'configurations'
    const { closures, closures_planned: planned } = progress
    stage.textContent = words(progress.stage)
    if (planned > 0) bar.value = closures / planned
    const left = pace.left(progress, limit_s)
    const entries: [string, string][] = [
      [unit, planned > 0 ? `${grouped(closures)} of ${grouped(planned)}` : grouped(closures)],
      ['time', seconds(progress.seconds)],
      [job.kind === 'study' ? 'remaining in this stage' : 'time left', left === null ? 'not yet known' : roughly(left)],
    ]
    if (progress.rms_mm !== undefined) entries.push(['distance, rms', withUnit(progress.rms_mm, 'mm', 2)])
    figures.replaceChildren(...entries.map(([name, value]) => h('div', {}, h('dt', {}, name), h('dd', {}, value))))
  }

  change(first)
  return { element, show, change }
}
