// Studies of a valve: asked for on the left, what they do and find on the right.
import '../style/search.css'
import '../style/studies.css'
import { postJson } from '../api/http'
import type { Job } from '../api/types'
import { h } from '../dom'
import { hasEnded } from '../jobs/calls'
import { followJob } from '../jobs/follow'
import { jobList } from '../jobs/job_list'
import { noteJob } from '../jobs/notes'
import { progressPanel, type ProgressPanel } from '../jobs/progress_panel'
import { lookAt } from '../jobs/look'
import { rememberValve, valveOf } from '../jobs/valves'
import { problemList } from '../problems'
import type { View } from '../view'
import { problemsOf, type Workspace } from '../workspace'
import { studyForm } from './form'
import { studyResults } from './results'

const OPENED = 'coapt-study' // in this tab, so that it is open again after a reload

export class StudiesView implements View {
  readonly element: HTMLElement
  private readonly form = studyForm((study) => void this.start(study))
  private readonly list = jobList('study', 'Earlier studies', (job) => this.openAndLook(job))
  private readonly found = h('div', {}, empty())
  private opened: AbortController | null = null
  private states = new Map<string, Job['state']>()

  constructor(private readonly workspace: Workspace) {
    this.element = h('div', { class: 'job-view' }, h('div', {}, this.form.element, this.list.element), this.found)
    workspace.subscribe(() => this.form.show(workspace.valve?.label ?? null))
    this.form.show(workspace.valve?.label ?? null)
  }

  show(): void {
    void this.list.refresh().then((jobs) => {
      if (this.opened) return
      const last = jobs.find((job) => job.id === sessionStorage.getItem(OPENED))
      const job = last ?? jobs.find((one) => !hasEnded(one.state))
      if (job) this.open(job)
    })
  }
  hide(): void {}

  private async start(study: Record<string, unknown>): Promise<void> {
    const { valve } = this.workspace
    if (!valve) return
    this.form.complain([])
    this.form.busy(true)
    try {
      const job = await postJson<Job>('/v1/studies', { valve: valve.reference, study })
      rememberValve(job.valve, valve)
      noteJob(job.id, String(study['name']))
      this.openAndLook(job)
    } catch (error) {
      this.form.complain(problemsOf(error))
    }
    this.form.busy(false)
  }

  private openAndLook(job: Job): void {
    this.open(job)
    lookAt(this.found)
  }

  private open(job: Job): void {
    this.opened?.abort()
    const { signal } = (this.opened = new AbortController())
    sessionStorage.setItem(OPENED, job.id)
    this.list.mark(job.id)
    this.found.replaceChildren(
      studyPanel(
        job,
        (now) => {
          if (this.states.get(now.id) !== now.state) void this.list.refresh()
          this.states.set(now.id, now.state)
        },
        signal,
      ),
    )
  }
}

/// Progress while it runs, figures once it has ended; followed until `signal` aborts.
function studyPanel(first: Job, told: (job: Job) => void, signal: AbortSignal): HTMLElement {
  const title = h('h1', {}, 'Study')
  const body = h('div', {})
  let panel: ProgressPanel | null = null
  void valveOf(first).then(({ label }) => (title.textContent = `Study: ${label}`))
  const say = (...children: Node[]) => body.replaceChildren(h('section', { class: 'panel' }, ...children))
  const complain = (error: unknown) => {
    if (!signal.aborted) say(problemList(problemsOf(error)))
  }

  function changed(job: Job): void {
    told(job)
    if (job.state === 'FAILED') return say(h('h2', {}, 'The study failed'), problemList(job.problems))
    if (job.state === 'CANCELLED')
      return say(h('p', {}, 'It was cancelled. What it has closed is kept: asked for again it goes on.'))
    if (job.state === 'SUCCEEDED')
      return void studyResults(job, signal).then((results) => body.replaceChildren(results), complain)
    if (panel) return panel.change(job)
    panel = progressPanel(job, 'study')
    body.replaceChildren(panel.element)
  }

  followJob(first.id, { changed, progress: (now) => panel?.show(now) }, signal).catch(complain)
  return h('div', { class: 'search-job' }, title, body)
}

function empty(): HTMLElement {
  return h(
    'div',
    {},
    h('h1', {}, 'Studies'),
    h(
      'div',
      { class: 'panel' },
      h(
        'p',
        {},
        'The studies of the thesis “Fast Surgical Simulation to Improve Mitral Valve Repair”, repeated on the open valve: each of its findings beside what this valve shows, and its figures to be looked into.',
      ),
      h('p', {}, 'The study of the annulus takes seconds, all of them about a minute on two cores.'),
    ),
  )
}
