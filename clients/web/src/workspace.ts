// The page's state: a valve, its closure, a repair of it, the plans that were kept, the jobs that are looked at.
import { drawScene } from './api/calls'
import { ApiError } from './api/http'
import type { Job, Plan, Problem, Scene, Step } from './api/types'
import type { StoryPlace } from './state/address'
import { fittingName, shelf as keptPlans, type KeptPlan, type Shelf } from './state/kept_plans'
import { tellTabs } from './state/tabs'
import { nameOfValve } from './state/valves'

const FRAMES = 40 // of the closing animation

export interface ValveSource {
  reference: string // a preset's name or a stored valve's id
  label: string
}

export const NO_PLAN: Plan = { schema: 'coapt.plan/1', steps: [] }

export class Workspace {
  valve: ValveSource | null = null
  before: Scene | null = null
  after: Scene | null = null // of closedPlan; null if that has no steps or cannot be closed
  kept: KeptPlan[] = [] // newest last
  jobs: Record<Job['kind'], string | null> = { plans: null, study: null, import: null, fit: null, model: null } // that are looked at
  story: StoryPlace | null = null // that is told
  answer_ms: number | null = null // from letting go to the answer, of the last closure
  problems: Problem[] = [] // what is said against the valve or closedPlan

  private closedPlan: Plan = NO_PLAN // the last that was answered
  private plans: Plan[] = [NO_PLAN] // undo goes back in them
  private at = 0
  private dragging = false
  private closing = false
  private opened = 0 // valves asked for
  private changed_at = 0
  private listeners: (() => void)[] = []

  constructor(private readonly shelf: Shelf = keptPlans()) {}

  get plan(): Plan {
    return this.plans[this.at] ?? NO_PLAN
  }
  /// Whether `after` and `problems` are of the present plan: else its closure is on its way.
  get isAnswered(): boolean {
    return this.closedPlan === this.plan
  }
  /// Between the first passing value and the one where the person let go.
  get isDragging(): boolean {
    return this.dragging
  }
  get canUndo(): boolean {
    return this.at > 0
  }
  get canRedo(): boolean {
    return this.at + 1 < this.plans.length
  }

  /// `listener` is called after every change.
  subscribe(listener: () => void): void {
    this.listeners.push(listener)
  }

  /// Of several valves that are asked for the last one is opened, whichever is answered first.
  async open(valve: ValveSource): Promise<void> {
    const mine = ++this.opened
    const before = await drawScene(valve.reference, null, FRAMES)
    if (mine !== this.opened) return
    Object.assign(this, { valve, before, after: null, problems: [], answer_ms: null, dragging: false })
    this.plans = [NO_PLAN]
    this.at = 0
    this.closedPlan = NO_PLAN
    this.changed()
  }

  /// Takes a plan as the present one and closes the valve with it; undo comes back from it. While a value is dragged
  /// (`passing`) and when it is let go, the plan takes the place of the one before: one drag is undone at once.
  async setPlan(steps: Step[], passing = false): Promise<void> {
    const isSame = JSON.stringify(steps) === JSON.stringify(this.plan.steps)
    if (!isSame) {
      const plan: Plan = { schema: 'coapt.plan/1', steps }
      if (this.dragging) this.plans[this.at] = plan
      else this.plans = [...this.plans.slice(0, ++this.at), plan]
    }
    this.dragging = passing
    await this.close()
  }

  async undo(): Promise<void> {
    if (!this.canUndo) return
    --this.at
    this.dragging = false
    await this.close()
  }
  async redo(): Promise<void> {
    if (!this.canRedo) return
    ++this.at
    this.dragging = false
    await this.close()
  }

  /// The open valve's name here.
  relabel(label: string): void {
    if (this.valve) this.valve = { ...this.valve, label }
    this.changed()
  }

  lookAt(kind: Job['kind'], job: string | null): void {
    if (this.jobs[kind] === job) return
    this.jobs[kind] = job
    this.changed()
  }

  /// A slide of a story; null: none any more.
  tell(story: StoryPlace | null): void {
    if (JSON.stringify(story) === JSON.stringify(this.story)) return
    this.story = story
    this.changed()
  }

  /// What was kept before, here or in another tab.
  async loadKept(): Promise<void> {
    this.kept = (await this.shelf.list()).reverse()
    this.changed()
  }
  /// A plan that is kept for this valve already stays the one; `isNew` says so.
  async keep(name: string, plan = this.plan, valve = this.valve): Promise<{ kept: KeptPlan; isNew: boolean }> {
    if (!valve) throw new Error('No valve is open.')
    const steps = JSON.stringify(plan.steps)
    const same = (other: KeptPlan) => other.valve === valve.reference && JSON.stringify(other.plan.steps) === steps
    const before = this.kept.find(same)
    if (before) return { kept: before, isNew: false }
    const kept = await this.shelf.add({ name: fittingName(name), plan, valve: valve.reference })
    this.kept = [...this.kept, kept]
    this.keptChanged()
    return { kept, isNew: true }
  }
  async rename(kept: KeptPlan, name: string): Promise<void> {
    const fitting = fittingName(name)
    await this.shelf.rename(kept.id, fitting)
    this.kept = this.kept.map((other) => (other === kept ? { ...kept, name: fitting } : other))
    this.keptChanged()
  }
  async forget(kept: KeptPlan): Promise<void> {
    await this.shelf.remove(kept.id)
    this.kept = this.kept.filter((other) => other.id !== kept.id)
    this.keptChanged()
  }

  private keptChanged(): void {
    tellTabs('kept plans')
    this.changed()
  }

  /// Opens the plan's valve first, if another one is open.
  async revise({ plan, valve }: KeptPlan): Promise<void> {
    if (valve !== this.valve?.reference) await this.open({ reference: valve, label: nameOfValve(valve) })
    await this.setPlan(plan.steps)
  }

  /// Of a plan whose closure the service did not answer.
  closeAgain(): Promise<void> {
    return this.close()
  }

  /// One closure at a time: those of plans that were only passed through are left out.
  private async close(): Promise<void> {
    this.changed_at = performance.now()
    this.changed()
    if (this.closing) return
    this.closing = true
    let answers = true
    while (this.valve && !this.isAnswered && answers) answers = await this.closePresent(this.valve, this.plan)
    this.closing = false
  }

  /// False if the service did not answer: what was closed last stays, as not answered.
  private async closePresent(valve: ValveSource, plan: Plan): Promise<boolean> {
    let after: Scene | null = null
    let problems: Problem[] = []
    try {
      if (plan.steps.length > 0) after = await drawScene(valve.reference, plan, 0)
    } catch (error) {
      if (error instanceof TypeError) return false
      problems = problemsOf(error)
    }
    if (valve.reference !== this.valve?.reference) return true
    this.after = after
    this.problems = problems
    this.answer_ms = after ? performance.now() - this.changed_at : null
    this.closedPlan = plan
    this.changed()
    return true
  }

  private changed(): void {
    for (const listener of this.listeners) listener()
  }
}

/// A job that has failed.
export class JobFailed extends Error {
  constructor(readonly problems: Problem[]) {
    super(problems[0]?.message ?? '')
  }
}

/// An error as problems that can be listed.
export function problemsOf(error: unknown): Problem[] {
  if ((error instanceof ApiError || error instanceof JobFailed) && error.problems.length > 0) return error.problems
  if (error instanceof TypeError) return [{ code: 'failed', path: '', message: 'The service does not respond.' }]
  const message = error instanceof Error ? error.message : String(error)
  return [{ code: 'failed', path: '', message }]
}
