// A view over jobs of one kind: what asks for one and the earlier ones on the left, the open one on the right.
import { postJson } from '../api/http'
import type { Job, Plan, Problem } from '../api/types'
import { button, h } from '../dom'
import { tellTabs } from '../state/tabs'
import { problemsOf, type Workspace } from '../workspace'
import { problemList } from '../problems'
import { hasEnded, job, removeJob } from './calls'
import { jobList, type JobList } from './job_list'
import { forgetJob, noteJob } from './notes'
import { rememberValve } from './valves'
import jobsStyle from './jobs.module.css'

export type Asked = Record<string, unknown> // "search" or "study" of a request

export interface JobForm {
  element: HTMLElement
  show(valve: string | null, plan: Plan): void // of the page, at present
  complain(problems: Problem[]): void
  busy(is: boolean): void
}

export interface JobKind {
  kind: Job['kind']
  path: string // that takes requests
  member: string // of the request, what is asked
  earlier: string // title of the list
  another: string // leads from an open job to the form, where that stands below
  form(start: (asked: Asked) => void): JobForm
  note(asked: Asked): string // in a few words
  outcome(job: Job): string | null // in a few words: what it has found so far
  empty: HTMLElement // while none is open
  /// Shows a job until `signal` aborts; `changed` is told its states.
  panel(job: Job, changed: (job: Job) => void, signal: AbortSignal): HTMLElement
}

export class JobView {
  readonly element: HTMLElement
  private readonly form: JobForm
  private readonly list: JobList
  private readonly found: HTMLElement
  private readonly states = new Map<string, Job['state']>()
  private opened: AbortController | null = null
  private openId: string | null = null

  constructor(
    private readonly workspace: Workspace,
    private readonly kind: JobKind,
  ) {
    this.form = kind.form((asked) => void this.start(asked))
    this.list = jobList({
      kind: kind.kind,
      title: kind.earlier,
      outcome: kind.outcome,
      open: (job) => this.openAndLook(job),
      remove: (job) => this.remove(job),
    })
    this.found = h('div', {}, kind.empty)
    const asking = h('div', {}, this.form.element, this.list.element)
    const lead = button(kind.another, () => asking.scrollIntoView(), { class: jobsStyle.lead })
    this.element = h('div', { class: jobsStyle.jobView }, asking, h('div', {}, lead, this.found))
    const follow = () => {
      this.form.show(workspace.valve?.label ?? null, workspace.plan)
      if (this.element.isConnected) void this.openAsked()
    }
    workspace.subscribe(follow)
    follow()
  }

  /// The job that is looked at, or one that runs, is opened.
  async show(): Promise<void> {
    void this.openAsked()
    const jobs = await this.list.refresh()
    const running = jobs.find((one) => !hasEnded(one.state))
    if (this.workspace.jobs[this.kind.kind] === null && running) this.open(running)
  }

  private async openAsked(): Promise<void> {
    const asked = this.workspace.jobs[this.kind.kind]
    if (asked === null || asked === this.openId) return
    this.openId = asked
    try {
      const found = await job(asked)
      if (this.openId === asked) this.open(found)
    } catch (error) {
      this.found.replaceChildren(problemList(problemsOf(error)))
    }
  }

  private async start(asked: Asked): Promise<void> {
    const { valve } = this.workspace
    if (!valve) return
    this.form.complain([])
    this.form.busy(true)
    try {
      const job = await postJson<Job>(this.kind.path, { valve: valve.reference, [this.kind.member]: asked })
      rememberValve(job.valve, valve)
      const { seconds } = asked
      noteJob(job.id, { words: this.kind.note(asked), limit_s: typeof seconds === 'number' ? seconds : null })
      this.openAndLook(job)
    } catch (error) {
      this.form.complain(problemsOf(error))
    }
    this.form.busy(false)
  }

  private async remove(job: Job): Promise<void> {
    await removeJob(job.id)
    tellTabs('jobs')
    forgetJob(job.id)
    if (job.id !== this.openId) return
    this.opened?.abort()
    this.openId = null
    this.list.mark(null)
    this.workspace.lookAt(this.kind.kind, null)
    this.element.removeAttribute('data-open')
    this.found.replaceChildren(this.kind.empty)
  }

  private openAndLook(job: Job): void {
    this.open(job)
    const { top } = this.found.getBoundingClientRect()
    if (top < 0 || top > innerHeight / 2) this.found.scrollIntoView() // it stands out of sight
  }

  private open(job: Job): void {
    this.opened?.abort()
    this.opened = new AbortController()
    this.openId = job.id
    this.element.setAttribute('data-open', '')
    this.workspace.lookAt(this.kind.kind, job.id)
    this.list.mark(job.id)
    const changed = (now: Job) => {
      if (this.states.get(now.id) !== now.state) {
        void this.list.refresh()
        tellTabs('jobs')
      }
      this.states.set(now.id, now.state)
    }
    this.found.replaceChildren(this.kind.panel(job, changed, this.opened.signal))
  }
}
