// Searches for repair plans: asked for on the left, what they do and find on the right.
import '../style/search.css'
import { postJson } from '../api/http'
import type { Job } from '../api/types'
import { h } from '../dom'
import { hasEnded } from '../jobs/calls'
import { jobList } from '../jobs/job_list'
import { noteJob } from '../jobs/notes'
import { grouped } from '../jobs/progress_panel'
import { lookAt } from '../jobs/look'
import { rememberValve } from '../jobs/valves'
import type { View } from '../view'
import { problemsOf, type Workspace } from '../workspace'
import { searchForm } from './form'
import { searchPanel } from './job_panel'
import { Pictures } from './pictures'

const OPENED = 'coapt-search' // in this tab, so that it is open again after a reload

export class SearchView implements View {
  readonly element: HTMLElement
  private readonly form = searchForm((search) => void this.start(search))
  private readonly list = jobList('plans', 'Earlier searches', (job) => this.openAndLook(job))
  private readonly found = h('div', {}, empty())
  private readonly pictures = new Pictures()
  private opened: AbortController | null = null
  private states = new Map<string, Job['state']>()

  constructor(private readonly workspace: Workspace) {
    this.element = h('div', { class: 'job-view' }, h('div', {}, this.form.element, this.list.element), this.found)
    workspace.subscribe(() => this.showValve())
    this.showValve()
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

  private showValve(): void {
    this.form.show(this.workspace.valve?.label ?? null, this.workspace.plan)
  }

  private async start(search: Record<string, unknown>): Promise<void> {
    const { valve } = this.workspace
    if (!valve) return
    this.form.complain([])
    this.form.busy(true)
    try {
      const job = await postJson<Job>('/v1/plans', { valve: valve.reference, search })
      rememberValve(job.valve, valve)
      noteJob(job.id, `${grouped(Number(search['evaluations'] ?? 2000))} closures`)
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
    this.pictures.release()
    const opened = (this.opened = new AbortController())
    sessionStorage.setItem(OPENED, job.id)
    this.list.mark(job.id)
    const changed = (now: Job) => {
      if (this.states.get(now.id) !== now.state) void this.list.refresh()
      this.states.set(now.id, now.state)
    }
    this.found.replaceChildren(
      searchPanel(job, { workspace: this.workspace, pictures: this.pictures, signal: opened.signal, changed }),
    )
  }
}

function empty(): HTMLElement {
  return h(
    'div',
    {},
    h('h1', {}, 'Search'),
    h(
      'div',
      { class: 'panel' },
      h(
        'p',
        {},
        'coapt tries rings, papillary sutures and neochordae on the open valve and ranks the best plans by how they close it, also when the surgeon’s hand varies.',
      ),
      h(
        'p',
        {},
        'The defaults are sensible: about half a minute on two cores. A search goes on while you do something else, also when this page is closed.',
      ),
    ),
  )
}
