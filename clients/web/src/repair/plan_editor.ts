// The list of steps of the plan at hand: adding, setting, taking out, undo.
import { rings as askForRings } from '../api/calls'
import type { LeafletPoint, Rings, Scene, Step, Vector } from '../api/types'
import { button, h, select } from '../dom'
import { iconButton } from '../icons'
import { edgeOf } from '../live/surface'
import { at, closedNodes } from '../viewer/geometry'
import { problemsOf, type Workspace } from '../workspace'
import { stepForm, type StepContext } from './forms'
import type { AskForPick } from './picking'
import {
  describe,
  FIRST_STEPS,
  FREE_EDGE,
  newApproximation,
  newNeochorda,
  placeWords,
  SIDES,
  withStep,
  type Anatomy,
} from './steps'
import parts from '../style/parts.module.css'
import repairStyle from './repair.module.css'

export class PlanEditor {
  readonly element = h('section', { class: parts.panel, 'aria-label': 'The plan' })
  private readonly list = h('ol', { class: repairStyle.steps, 'data-part': 'steps' })
  private readonly undo = iconButton('undo', 'Undo', () => void this.workspace.undo(), { title: 'Undo (Ctrl+Z)' })
  private readonly redo = iconButton('redo', 'Redo', () => void this.workspace.redo(), { title: 'Redo (Ctrl+Shift+Z)' })
  rings: Rings = { rings: [], sizes_mm: { min: 24, max: 40, step: 2 } }
  private open = -1 // step whose controls are shown
  private titles: HTMLElement[] = [] // one a step
  private shown = '' // steps whose items are in the list, and the annulus that they are for

  constructor(
    private readonly workspace: Workspace,
    private readonly ask: AskForPick,
  ) {
    this.element.append(
      h('h2', {}, 'Repair by hand'),
      this.adding(),
      this.list,
      h(
        'p',
        { class: parts.row },
        this.undo,
        this.redo,
        button('Clear', () => void this.set([])),
      ),
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
    this.titles = []
    if (anatomy) this.list.replaceChildren(...steps.map((step, i) => this.item(anatomy, step, i)))
    if (steps.length === 0) this.list.replaceChildren(h('li', { class: parts.hint }, 'No steps yet. Add one above.'))
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
    const add = (step: Step): void => {
      const steps = withStep(this.workspace.plan.steps, step)
      this.open = steps.length - 1
      void this.set(steps)
    }
    const first = (name: keyof typeof FIRST_STEPS): HTMLElement => button(name, () => add(FIRST_STEPS[name]))
    const withScene = (use: (scene: Scene) => void) => () => this.workspace.before && use(this.workspace.before)
    const withAnatomy = (use: (anatomy: Anatomy) => void) => () => {
      const anatomy = this.anatomy()
      if (anatomy) use(anatomy)
    }
    const sutures = SIDES.map(([side, label]) =>
      button(
        `Suture ${label.slice(0, 1) === 'A' ? 'AL' : 'PM'}`,
        withAnatomy((anatomy) => {
          const others = this.workspace.plan.steps.filter(
            (step) => step.step !== 'papillary_approximation' || step.side !== side,
          )
          this.open = others.length
          void this.set([...others, newApproximation(anatomy, side, 'ipsilateral_trigone')])
        }),
        { title: `${label} papillary muscle to the annulus` },
      ),
    )
    return h(
      'div',
      { class: parts.row, role: 'group', 'aria-label': 'Add a step' },
      first('Ring'),
      ...sutures,
      button(
        'Neochorda',
        withScene((scene) => this.placeNeochorda(scene, add)),
      ),
      button(
        'Chorda',
        withScene((scene) => this.chooseChorda(scene, add)),
      ),
      first('Resection'),
      first('Edge-to-edge'),
    )
  }

  private placeNeochorda(scene: Scene, add: (step: Step) => void): void {
    const from = (insertion: LeafletPoint, point_mm: Vector): void => {
      const use = (head: string): void => add(newNeochorda(scene, head, insertion))
      this.ask({
        hint: 'Now click a papillary head.',
        kinds: ['head'],
        marks: [{ point_mm, text: `neochorda to ${placeWords(insertion)}`, kind: 'distance' }],
        view: 'anterior', // from the atrium the leaflets hide the heads
        use: (pick) => pick.kind === 'head' && use(pick.id),
        list: { label: 'or choose the head', options: scene.heads.map(({ id }) => [id, id] as const), use },
      })
    }
    const places = Object.keys(FREE_EDGE).map((name) => [name, `free edge of ${name}`] as const)
    this.ask({
      hint: 'Click the insertion of the neochorda.',
      kinds: ['leaflet'],
      use: (pick) => pick.kind === 'leaflet' && from(pick.point, pick.point_mm),
      list: {
        label: 'or choose the place',
        options: places,
        use: (name) => from(FREE_EDGE[name] as LeafletPoint, at(closedNodes(scene), edgeOf(scene, name))),
      },
    })
  }

  /// Picked on the valve or by its name; then shortened, cut or moved.
  private chooseChorda(scene: Scene, add: (step: Step) => void): void {
    const use = (chorda: string): void => add({ step: 'chordal_length_change', chorda, change_mm: -2 })
    this.ask({
      hint: 'Click a chorda.',
      kinds: ['chorda'],
      use: (pick) => pick.kind === 'chorda' && use(pick.id),
      list: { label: 'or choose it', options: scene.chordae.map(({ id }) => [id, id] as const), use },
    })
  }

  private item(anatomy: Anatomy, step: Step, i: number): HTMLElement {
    const title = h(
      'button',
      {
        type: 'button',
        class: `${parts.quiet} ${repairStyle.step}`,
        'data-part': 'step',
        'aria-expanded': String(i === this.open),
        onclick: () => this.unfold(i),
      },
      describe(step),
    )
    this.titles.push(title)
    const remove = iconButton(
      'remove',
      `Remove step ${i + 1}`,
      () => void this.set(this.workspace.plan.steps.filter((_, other) => other !== i)),
    )
    const item = h('li', {}, h('div', { class: parts.row }, title, remove))
    if (i === this.open)
      item.append(this.chordaFields(anatomy.before, step, i) ?? '', stepForm(step, this.context(anatomy, i)))
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
    const labels = [
      ['chordal_length_change', 'shorten or lengthen'],
      ['chordal_excision', 'cut'],
      ['chordal_transfer', 'move'],
    ] as const
    const chordae = scene.chordae.map(({ id }) => [id, id] as const)
    return h(
      'div',
      {},
      h(
        'label',
        { class: parts.field },
        h('span', {}, 'Chorda'),
        select(chordae, step.chorda, (chorda) => this.change(i, { ...step, chorda }, false)),
      ),
      h(
        'label',
        { class: parts.field },
        h('span', {}, 'Action'),
        select(labels, step.step, (kind) => {
          const make = kinds[kind]
          if (make) this.change(i, make(step.chorda), false)
        }),
      ),
    )
  }

  private context(anatomy: Anatomy, i: number): StepContext {
    return {
      ...anatomy,
      rings: this.rings,
      change: (step, passing) => this.change(i, step, passing),
      pickInsertion: (use) =>
        this.ask({
          hint: 'Click the new insertion.',
          kinds: ['leaflet'],
          use: (pick) => pick.kind === 'leaflet' && use(pick.point),
        }),
      pickAnchor: (use) =>
        this.ask({
          hint: 'Click the anchor of the suture on the annulus.',
          kinds: ['annulus'],
          use: (pick) => pick.kind === 'annulus' && use(pick.around),
        }),
    }
  }

  private unfold(i: number): void {
    this.open = i === this.open ? -1 : i
    this.update()
  }

  private change(i: number, step: Step, passing: boolean): void {
    const steps = this.workspace.plan.steps.map((other, at) => (at === i ? step : other))
    if (passing) this.shown = this.key(steps) // its controls are in use
    this.titles[i]?.replaceChildren(describe(step))
    void this.workspace.setPlan(steps, passing)
  }

  private set(steps: Step[]): Promise<void> {
    if (steps.length < this.workspace.plan.steps.length) this.open = -1
    return this.workspace.setPlan(steps)
  }
}
