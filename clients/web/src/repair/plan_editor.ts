// The list of steps of the plan at hand: adding, setting, taking out, undo.
import { rings as askForRings } from '../api/calls'
import type { LeafletPoint, Rings, Scene, Step } from '../api/types'
import { button, h, select } from '../dom'
import type { Pick, PickKind } from '../viewer/pick'
import { problemsOf, type Workspace } from '../workspace'
import { stepForm, type StepContext } from './forms'
import { describe, newApproximation, newNeochorda, SIDES, type Anatomy } from './steps'

/// Asks for a click on the valve; `hint` says what for.
export type AskForPick = (hint: string, kinds: PickKind[], use: (pick: Pick) => void) => void

export class PlanEditor {
  readonly element = h('section', { class: 'panel plan', 'aria-label': 'The plan' })
  private readonly list = h('ol', { class: 'steps' })
  private readonly undo = button('Undo', () => void this.workspace.undo())
  private readonly redo = button('Redo', () => void this.workspace.redo())
  private rings: Rings = { rings: [], sizes_mm: { min: 24, max: 40, step: 2 } }
  private open = -1 // step whose controls are shown
  private shown = '' // steps whose items are in the list, and the annulus that they are for

  constructor(
    private readonly workspace: Workspace,
    private readonly ask: AskForPick,
  ) {
    this.element.append(
      h('h2', {}, 'Repair by hand'),
      this.adding(),
      this.list,
      h('p', { class: 'row' }, this.undo, this.redo, button('Clear', () => void this.set([]))),
    )
    askForRings().then(
      (rings) => (this.rings = rings),
      (error: unknown) => (this.workspace.problems = problemsOf(error)),
    )
  }

  /// Follows the workspace; a slider that is being dragged stays as it is.
  update(): void {
    this.undo.disabled = !this.workspace.canUndo
    this.redo.disabled = !this.workspace.canRedo
    const { steps } = this.workspace.plan
    const key = this.key(steps)
    if (key === this.shown || this.workspace.isDragging) return
    this.shown = key
    const focused = this.controls().indexOf(document.activeElement as HTMLElement)
    const anatomy = this.anatomy()
    if (anatomy) this.list.replaceChildren(...steps.map((step, i) => this.item(anatomy, step, i)))
    if (steps.length === 0) this.list.replaceChildren(h('li', { class: 'hint' }, 'No step yet: add one above.'))
    // Who sets values with the keyboard goes on where they were.
    if (focused >= 0) this.controls()[focused]?.focus()
  }

  private controls(): HTMLElement[] {
    return [...this.list.querySelectorAll<HTMLElement>('button, input, select')]
  }

  private anatomy(): Anatomy | null {
    const { before, after } = this.workspace
    return before && { before, ringed: after ?? before }
  }

  private key(steps: Step[]): string {
    const ringed = this.workspace.after?.annulus_mm.slice(0, 3)
    return JSON.stringify([this.workspace.valve?.reference, this.open, steps, ringed])
  }

  private adding(): HTMLElement {
    /// Where it stands in the plan.
    const add = (step: Step): number => {
      const index = (this.open = this.workspace.plan.steps.length)
      void this.set([...this.workspace.plan.steps, step])
      return index
    }
    const withScene = (use: (scene: Scene) => void) => () => this.workspace.before && use(this.workspace.before)
    const withAnatomy = (use: (anatomy: Anatomy) => void) => () => {
      const anatomy = this.anatomy()
      if (anatomy) use(anatomy)
    }
    const sutures = SIDES.map(([side, label]) =>
      button(`Suture ${label.slice(0, 1) === 'A' ? 'AL' : 'PM'}`, withAnatomy((anatomy) => {
        const others = this.workspace.plan.steps.filter((step) => step.step !== 'papillary_approximation' || step.side !== side)
        this.open = others.length
        void this.set([...others, newApproximation(anatomy, side, 'ipsilateral_trigone')])
      }), { title: `${label} papillary muscle to the annulus` }),
    )
    return h(
      'div',
      { class: 'row', role: 'group', 'aria-label': 'Add a step' },
      button('Ring', () => {
        const others = this.workspace.plan.steps.filter((step) => step.step !== 'annuloplasty')
        this.open = others.length
        void this.set([...others, { step: 'annuloplasty', shape: 'own', sizes_below: 2 }])
      }),
      ...sutures,
      button('Neochorda', withScene((scene) => {
        const index = add(newNeochorda(scene, scene.heads[0]?.id ?? '', { leaflet: 'posterior', along: 0.5, height: 1 }))
        this.ask('Click where the neochorda is to insert, then a papillary head.', ['leaflet'], (place) => this.placeNeochorda(scene, index, place))
      })),
      button('Chorda', withScene((scene) => this.chooseChorda(scene, add))),
    )
  }

  private placeNeochorda(scene: Scene, index: number, place: Pick): void {
    if (place.kind !== 'leaflet') return
    this.ask('Now click a papillary head.', ['head'], (head) => {
      if (head.kind === 'head') this.change(index, newNeochorda(scene, head.id, place.point), false)
    })
  }

  /// A chorda is picked on the valve or by its name, then shortened, cut or moved.
  private chooseChorda(scene: Scene, add: (step: Step) => number): void {
    const first = scene.chordae[0]?.id ?? ''
    const index = add({ step: 'chordal_length_change', chorda: first, change_mm: -2 })
    this.ask('Click a chorda.', ['chorda'], (pick) => {
      if (pick.kind === 'chorda') this.change(index, { step: 'chordal_length_change', chorda: pick.id, change_mm: -2 }, false)
    })
  }

  private item(anatomy: Anatomy, step: Step, i: number): HTMLElement {
    const title = h('button', { type: 'button', class: 'quiet step', 'aria-expanded': String(i === this.open), onclick: () => this.unfold(i) }, describe(step))
    const remove = button('Remove', () => void this.set(this.workspace.plan.steps.filter((_, other) => other !== i)), {
      class: 'quiet',
      'aria-label': `Remove: ${describe(step)}`,
    })
    const item = h('li', {}, h('div', { class: 'row' }, title, remove))
    if (i === this.open) item.append(this.chordaFields(anatomy.before, step, i) ?? '', stepForm(step, this.context(anatomy, i)))
    return item
  }

  /// Which chorda, and what is done to it.
  private chordaFields(scene: Scene, step: Step, i: number): HTMLElement | null {
    if (!('chorda' in step)) return null
    const middle: LeafletPoint = { leaflet: 'posterior', along: 0.5, height: 0.9 }
    const kinds: Record<string, (chorda: string) => Step> = {
      chordal_length_change: (chorda) => ({ step: 'chordal_length_change', chorda, change_mm: -2 }),
      chordal_excision: (chorda) => ({ step: 'chordal_excision', chorda }),
      chordal_transfer: (chorda) => ({ step: 'chordal_transfer', chorda, insertion: middle }),
    }
    const labels = [['chordal_length_change', 'shorten or lengthen'], ['chordal_excision', 'cut'], ['chordal_transfer', 'move']] as const
    const chordae = scene.chordae.map(({ id }) => [id, id] as const)
    return h(
      'div',
      {},
      h('label', { class: 'field' }, h('span', {}, 'Chorda'), select(chordae, step.chorda, (chorda) => this.change(i, { ...step, chorda }, false))),
      h('label', { class: 'field' }, h('span', {}, 'What is done'), select(labels, step.step, (kind) => {
        const make = kinds[kind]
        if (make) this.change(i, make(step.chorda), false)
      })),
    )
  }

  private context(anatomy: Anatomy, i: number): StepContext {
    return {
      ...anatomy,
      rings: this.rings,
      change: (step, passing) => this.change(i, step, passing),
      pickInsertion: (use) =>
        this.ask('Click where it is to insert.', ['leaflet'], (pick) => pick.kind === 'leaflet' && use(pick.point)),
      pickAnchor: (use) =>
        this.ask('Click the annulus where the suture is tied.', ['annulus'], (pick) => pick.kind === 'annulus' && use(pick.around)),
    }
  }

  private unfold(i: number): void {
    this.open = i === this.open ? -1 : i
    this.update()
  }

  private change(i: number, step: Step, passing: boolean): void {
    const steps = this.workspace.plan.steps.map((other, at) => (at === i ? step : other))
    if (passing) this.shown = this.key(steps) // its controls are in use
    void this.workspace.setPlan(steps, passing)
  }

  private set(steps: Step[]): Promise<void> {
    if (steps.length < this.workspace.plan.steps.length) this.open = -1
    return this.workspace.setPlan(steps)
  }
}
