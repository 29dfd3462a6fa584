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
  valve: ValveSource // that it was made for
}

export const NO_PLAN: Plan = { schema: 'coapt.plan/1', steps: [] }

export class Workspace {
  valve: ValveSource | null = null
  before: Scene | null = null
  after: Scene | null = null // of closedPlan; null if that has no steps or cannot be closed
  kept: KeptPlan[] = []
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

  keep(name: string, plan = this.plan, valve = this.valve): void {
    if (valve) this.kept.push({ name, plan, valve })
    this.changed()
  }
  forget(kept: KeptPlan): void {
    this.kept = this.kept.filter((other) => other !== kept)
    this.changed()
  }

  /// One closure at a time: those of plans that were only passed through are left out.
  private async close(): Promise<void> {
    this.changed_at = performance.now()
    this.changed()
    if (this.closing) return
    this.closing = true
    while (this.valve && !this.isAnswered) await this.closePresent(this.valve, this.plan)
    this.closing = false
  }

  private async closePresent(valve: ValveSource, plan: Plan): Promise<void> {
    let after: Scene | null = null
    let problems: Problem[] = []
    try {
      if (plan.steps.length > 0) after = await drawScene(valve.reference, plan, 0)
    } catch (error) {
      problems = problemsOf(error)
    }
    if (valve !== this.valve) return
    this.after = after
    this.problems = problems
    this.answer_ms = after ? performance.now() - this.changed_at : null
    this.closedPlan = plan
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
