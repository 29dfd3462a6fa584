// What the page is about at present: a valve, its closure, a repair of it and the plans that were kept.
import { drawScene } from './api/calls'
import { ApiError } from './api/http'
import type { Plan, Problem, Scene, Step } from './api/types'

const FRAMES = 40 // of the closing animation

export interface ValveSource {
  reference: string // a preset's name or a stored valve's id
  label: string
}

export interface KeptPlan {
  name: string
  plan: Plan
  valve: string // reference of the valve that it was made for
}

export const NO_PLAN: Plan = { schema: 'coapt.plan/1', steps: [] }

export class Workspace {
  valve: ValveSource | null = null
  before: Scene | null = null
  after: Scene | null = null // of the present plan; null while it has no steps
  kept: KeptPlan[] = []
  answer_ms: number | null = null // from letting go to the answer, of the last closure
  problems: Problem[] = [] // what is said against the valve or the present plan

  private plans: Plan[] = [NO_PLAN] // undo goes back in them
  private at = 0
  private listeners: (() => void)[] = []
  private asked: AbortController | null = null

  get plan(): Plan {
    return this.plans[this.at] ?? NO_PLAN
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

  async open(valve: ValveSource): Promise<void> {
    const before = await drawScene(valve.reference, null, FRAMES)
    this.asked?.abort()
    Object.assign(this, { valve, before, after: null, problems: [], answer_ms: null })
    this.plans = [NO_PLAN]
    this.at = 0
    this.changed()
  }

  /// Takes a plan as the present one and closes the valve with it; undo comes back from it. A plan that is given while
  /// a value is dragged (`passing`) takes the place of the one before.
  async setPlan(steps: Step[], passing = false): Promise<void> {
    const plan: Plan = { schema: 'coapt.plan/1', steps }
    if (passing && this.dragging) this.plans[this.at] = plan
    else this.plans = [...this.plans.slice(0, ++this.at), plan]
    this.dragging = passing
    await this.close()
  }
  private dragging = false

  async undo(): Promise<void> {
    if (!this.canUndo) return
    --this.at
    await this.close()
  }
  async redo(): Promise<void> {
    if (!this.canRedo) return
    ++this.at
    await this.close()
  }

  keep(name: string, plan = this.plan): void {
    if (this.valve) this.kept.push({ name, plan, valve: this.valve.reference })
    this.changed()
  }
  forget(kept: KeptPlan): void {
    this.kept = this.kept.filter((other) => other !== kept)
    this.changed()
  }

  /// Only the last one asked for is answered.
  private async close(): Promise<void> {
    if (!this.valve) return
    this.asked?.abort()
    const asked = (this.asked = new AbortController())
    const { plan } = this
    const start = performance.now()
    this.changed()
    try {
      const after = plan.steps.length > 0 ? await drawScene(this.valve.reference, plan, 0, asked.signal) : null
      if (asked.signal.aborted) return
      this.after = after
      this.problems = []
      this.answer_ms = after ? performance.now() - start : null
    } catch (error) {
      if (asked.signal.aborted) return
      this.problems = problemsOf(error)
    }
    this.changed()
  }

  private changed(): void {
    for (const listener of this.listeners) listener()
  }
}

/// An error as problems that can be listed.
export function problemsOf(error: unknown): Problem[] {
  if (error instanceof ApiError && error.problems.length > 0) return error.problems
  const message = error instanceof Error ? error.message : String(error)
  return [{ code: 'failed', path: '', message: message || 'the service did not answer' }]
}
