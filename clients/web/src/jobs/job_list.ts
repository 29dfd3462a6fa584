// Earlier jobs, to be opened again. They outlive the page.
import type { Job } from '../api/types'
import { h } from '../dom'
import { jobsOf } from './calls'
import { noteOf } from './notes'
import { stateBadge } from './state'
import { valveOf } from './valves'
import { problemList } from '../problems'
import { problemsOf } from '../workspace'
import jobsStyle from './jobs.module.css'
import parts from '../style/parts.module.css'

export interface JobList {
  element: HTMLElement
  refresh(): Promise<Job[]>
  mark(id: string): void // the one that is open
}

export function jobList(kind: Job['kind'], title: string, open: (job: Job) => void): JobList {
  const list = h('ul', { class: jobsStyle.jobs, 'data-part': 'jobs' })
  const element = h('section', { class: parts.panel }, h('h2', {}, title), list)
  const buttons = new Map<string, HTMLElement>()
  let marked = ''

  function entry(job: Job): HTMLElement {
    const valve = h('span', {}, `valve ${job.valve.slice(0, 8)}`)
    const note = noteOf(job.id)
    void valveOf(job).then((source) => (valve.textContent = source.label))
    const button = h(
      'button',
      { type: 'button', onclick: () => open(job), 'aria-current': job.id === marked && 'true' },
      h('span', { class: jobsStyle.when }, when(job.created)),
      h('span', {}, valve, note && h('span', { class: parts.hint }, ` ${note}`)),
      stateBadge(job.state),
    )
    buttons.set(job.id, button)
    return h('li', {}, button)
  }

  return {
    element,
    async refresh() {
      try {
        const jobs = await jobsOf(kind)
        buttons.clear()
        list.replaceChildren(...jobs.map(entry))
        if (jobs.length === 0) list.append(h('li', { class: parts.hint }, 'None yet.'))
        return jobs
      } catch (error) {
        list.replaceChildren(h('li', {}, problemList(problemsOf(error))))
        return []
      }
    },
    mark(id) {
      marked = id
      for (const [of, button] of buttons) {
        if (of === id) button.setAttribute('aria-current', 'true')
        else button.removeAttribute('aria-current')
      }
    },
  }
}

function when(time: string): string {
  const date = new Date(time)
  const day = { day: 'numeric', month: 'short' } as const
  const clock = { hour: '2-digit', minute: '2-digit' } as const
  const today = date.toDateString() === new Date().toDateString()
  return date.toLocaleString('en-GB', today ? clock : { ...day, ...clock })
}
