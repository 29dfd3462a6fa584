// Earlier jobs, to be opened again or removed. They outlive the page. What other tabs start or remove comes and goes here,
// what others start when the page is looked at again.
import type { Job } from '../api/types'
import { h } from '../dom'
import { iconButton } from '../icons'
import { problemList } from '../problems'
import { onOtherTab } from '../state/tabs'
import { problemsOf } from '../workspace'
import { hasEnded, jobsOf } from './calls'
import { noteOf } from './notes'
import { stateBadge } from './state'
import { valveOf } from './valves'
import jobsStyle from './jobs.module.css'
import parts from '../style/parts.module.css'

const NAMES: Record<Job['kind'], string> = {
  plans: 'search',
  study: 'study',
  import: 'import',
  fit: 'fit',
  model: 'study of variants',
}

export interface ListedJobs {
  kind: Job['kind']
  title: string
  outcome(job: Job): string | null // in a few words
  open(job: Job): void
  remove(job: Job): Promise<void>
}

export interface JobList {
  element: HTMLElement
  refresh(): Promise<Job[]>
  mark(id: string | null): void // the one that is open
}

export function jobList(listed: ListedJobs): JobList {
  const list = h('ul', { class: jobsStyle.jobs, 'data-part': 'jobs' })
  const told = h('div', {})
  const element = h('section', { class: parts.panel }, h('h2', {}, listed.title), told, list)
  const buttons = new Map<string, HTMLElement>()
  let marked: string | null = null

  function entry(job: Job): HTMLElement {
    const valve = h('strong', {}, `valve ${job.valve.slice(0, 8)}`)
    void valveOf(job).then((source) => (valve.textContent = source.label))
    const button = h(
      'button',
      { type: 'button', onclick: () => listed.open(job), 'aria-current': job.id === marked && 'true' },
      h('span', { class: jobsStyle.head }, valve, stateBadge(job.state)),
      h(
        'span',
        { class: parts.hint },
        [when(job.created), noteOf(job.id)?.words].filter((words) => words !== undefined).join(', '),
      ),
      h('span', { class: jobsStyle.outcome }, listed.outcome(job)),
    )
    buttons.set(job.id, button)
    const name = `${NAMES[listed.kind]} of ${when(job.created)}`
    return h(
      'li',
      {},
      button,
      hasEnded(job.state) && iconButton('remove', `Remove the ${name}`, () => void remove(job), { title: 'Remove' }),
    )
  }

  async function remove(job: Job): Promise<void> {
    try {
      await listed.remove(job)
      told.replaceChildren()
    } catch (error) {
      told.replaceChildren(problemList(problemsOf(error)))
    }
    await refresh()
  }

  async function refresh(): Promise<Job[]> {
    try {
      const jobs = await jobsOf(listed.kind)
      buttons.clear()
      list.replaceChildren(...jobs.map(entry))
      if (jobs.length === 0) list.append(h('li', { class: parts.hint }, 'None yet.'))
      return jobs
    } catch (error) {
      list.replaceChildren(h('li', {}, problemList(problemsOf(error))))
      return []
    }
  }

  onOtherTab('jobs', () => void refresh())
  document.addEventListener('visibilitychange', () => {
    if (document.visibilityState === 'visible' && element.isConnected) void refresh()
  })
  return {
    element,
    refresh,
    mark(id) {
      marked = id
      for (const [of, button] of buttons) {
        if (of === id) button.setAttribute('aria-current', 'true')
        else button.removeAttribute('aria-current')
      }
    },
  }
}

/// "today 12:07", "3 Nov 12:07".
function when(time: string): string {
  const date = new Date(time)
  const clock = date.toLocaleTimeString('en-GB', { hour: '2-digit', minute: '2-digit' })
  const isToday = date.toDateString() === new Date().toDateString()
  return `${isToday ? 'today' : date.toLocaleDateString('en-GB', { day: 'numeric', month: 'short' })} ${clock}`
}
