// One study: its progress while it runs, findings and figures once it has ended.
import type { Job } from '../api/types'
import { h } from '../dom'
import { followJob } from '../jobs/follow'
import { progressPanel, type ProgressPanel } from '../jobs/progress_panel'
import { valveOf } from '../jobs/valves'
import { problemList } from '../problems'
import { problemsOf } from '../workspace'
import { studyResults } from './results'
import parts from '../style/parts.module.css'

/// Followed until `signal` aborts; `told` hears of its states.
export function studyPanel(first: Job, told: (job: Job) => void, signal: AbortSignal): HTMLElement {
  const title = h('h1', {}, 'Study')
  const body = h('div', {})
  let panel: ProgressPanel | null = null
  void valveOf(first).then(({ label }) => (title.textContent = `Study: ${label}`))
  const say = (...children: Node[]) => body.replaceChildren(h('section', { class: parts.panel }, ...children))
  const complain = (error: unknown) => {
    if (!signal.aborted) say(problemList(problemsOf(error)))
  }

  function changed(job: Job): void {
    told(job)
    if (job.state === 'FAILED') {
      say(h('h2', {}, 'The study failed'), problemList(job.problems))
    } else if (job.state === 'CANCELLED') {
      say(h('p', {}, 'The study was cancelled. Its closures are stored; start it again to continue.'))
    } else if (job.state === 'SUCCEEDED') {
      void studyResults(job, signal).then((results) => body.replaceChildren(results), complain)
    } else if (panel) {
      panel.change(job)
    } else {
      panel = progressPanel(job, 'study')
      body.replaceChildren(panel.element)
    }
  }

  followJob(first.id, { changed, progress: (now) => panel?.show(now) }, signal).catch(complain)
  return h('div', {}, title, body)
}
