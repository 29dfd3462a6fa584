// A click on a valve that a step of the plan waits for.
import type { Plan } from '../api/types'
import { button, h, select } from '../dom'
import type { Label } from '../viewer/labels'
import type { Pick as Picked, PickKind } from '../viewer/pick'
import type { Stage, ViewName } from '../viewer/stage'
import repairStyle from './repair.module.css'

/// A click on the valve that is waited for, or a choice from a list instead. Nothing is applied before one is made.
export interface PickRequest {
  hint: string // what to click
  kinds: PickKind[]
  use(pick: Picked): void
  marks?: Label[] // what was picked before
  view?: ViewName // from where it can be seen
  list?: { label: string; options: (readonly [value: string, label: string])[]; use(value: string): void }
}
export type AskForPick = (request: PickRequest) => void

/// Of a viewer, what is used here.
interface Clicked {
  picks: PickKind[]
  onPick: ((pick: Picked) => void) | null
  mark(labels: Label[]): void
  view(name: ViewName): void
  readonly stage: Pick<Stage, 'pose'>
}

export class Picking {
  readonly element = h('div', { class: repairStyle.picking, 'data-part': 'picking', hidden: true })
  private plan: Plan | null = null // that was shown when it was asked
  private asked: Clicked[] = []
  private backs: (() => void)[] = [] // to where the cameras were

  /// `viewers`: where these kinds may be clicked.
  constructor(private readonly viewers: (kinds: PickKind[]) => Clicked[]) {}

  ask({ hint, kinds, use, list, marks = [], view }: PickRequest, plan: Plan): void {
    this.end()
    const end = <T>(then: (value: T) => void): ((value: T) => void) => {
      return (value) => {
        this.end()
        then(value)
      }
    }
    this.element.replaceChildren(h('span', { role: 'status' }, hint))
    if (list) {
      const choice = select([['', list.label], ...list.options], '', end(list.use))
      choice.setAttribute('aria-label', list.label)
      this.element.append(choice)
    }
    this.element.append(button('Cancel', () => this.end()))
    this.element.hidden = false
    this.plan = plan
    this.asked = this.viewers(kinds)
    for (const viewer of this.asked) {
      Object.assign(viewer, { picks: kinds, onPick: end(use) })
      viewer.mark(marks)
    }
    if (!view) return
    this.backs = this.asked.map(({ stage }) => stage.pose()) // before any moves: paired ones move together
    for (const viewer of this.asked) viewer.view(view)
  }

  end(): void {
    this.element.hidden = true
    for (const viewer of this.asked) {
      Object.assign(viewer, { picks: [], onPick: null })
      viewer.mark([])
    }
    for (const back of this.backs) back()
    this.asked = []
    this.backs = []
  }

  /// Of another plan nothing is picked.
  follow(plan: Plan): void {
    if (plan !== this.plan) this.end()
  }

  get isAsking(): boolean {
    return this.asked.length > 0
  }
}
