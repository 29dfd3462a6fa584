// A repair by hand: the valve before and after, side by side, and what it would measure.
import '../style/viewer.css'
import '../style/repair.css'
import type { Plan } from '../api/types'
import { button, h } from '../dom'
import { closureSaver, type FileSaver } from '../files'
import { problemList } from '../problems'
import type { View } from '../view'
import { Looks } from '../valve/looks'
import { measures } from '../valve/measures'
import { sectionInset } from '../valve/section_inset'
import { legend } from '../viewer/legend'
import { Viewer } from '../viewer/viewer'
import type { Workspace } from '../workspace'
import { KeptPlans } from './kept_plans'
import { PlanEditor } from './plan_editor'

export class RepairView implements View {
  readonly element: HTMLElement
  private readonly before = new Viewer('The valve before the repair')
  private readonly after = new Viewer('The repaired valve; click it to pick points')
  private readonly looks = new Looks(false)
  private readonly editor: PlanEditor
  private readonly kept: KeptPlans
  private readonly legend = h('div', {})
  private readonly insets = h('div', { class: 'insets' })
  private readonly measures = h('section', { class: 'panel', 'aria-label': 'Measured' })
  private readonly problems = h('div', {})
  private readonly said = h('p', { class: 'answer', 'aria-live': 'polite' })
  private readonly picking = h('p', { class: 'picking', role: 'status', hidden: true })
  private readonly save: FileSaver
  private pickedFor: Plan | null = null
  private ringed = false // the valve on the right has a ring
  private readonly afterTitle = h('figcaption', {})
  private readonly accept = button('Accept', () => this.keep(), { class: 'primary' })

  constructor(private readonly workspace: Workspace) {
    this.save = closureSaver(workspace, true, this.problems)
    this.editor = new PlanEditor(workspace, (hint, kinds, use) => {
      this.picking.textContent = hint
      this.picking.hidden = false
      this.pickedFor = workspace.plan
      // Chordae of the plan itself are none that it may change.
      for (const viewer of kinds.includes('chorda') ? [this.before] : [this.before, this.after]) {
        viewer.picks = kinds
        viewer.onPick = (pick) => {
          this.endPicking()
          use(pick)
        }
      }
    })
    this.kept = new KeptPlans(workspace)
    this.before.stage.pair(this.after.stage)
    this.looks.onChange = () => this.draw()
    this.looks.onView = (view) => this.before.view(view)
    this.element = h(
      'div',
      { class: 'sides repair' },
      h('div', {}, this.editor.element, this.kept.element, this.looks.element),
      h(
        'div',
        { class: 'stage' },
        h('h1', { class: 'unseen' }, 'Repair'),
        h('div', { class: 'row' }, this.looks.views, this.accept, this.save.element),
        this.picking,
        h('div', { class: 'stage-body' }, titled('Before', this.before.element), h('figure', {}, this.afterTitle, this.after.element)),
        this.said,
        this.problems,
        this.legend,
        this.insets,
        this.measures,
      ),
    )
    this.element.addEventListener('keydown', (event) => event.key === 'Escape' && this.endPicking())
    workspace.subscribe(() => this.take())
  }

  show(): void {
    this.take()
  }
  hide(): void {
    this.endPicking()
  }

  private endPicking(): void {
    this.picking.hidden = true
    for (const viewer of [this.before, this.after]) Object.assign(viewer, { picks: [], onPick: null })
  }

  private take(): void {
    const { before, problems, plan, answer_ms, isAnswered } = this.workspace
    if (!before || !this.element.isConnected) return
    if (plan !== this.pickedFor) this.endPicking()
    this.element.classList.toggle('waiting', !isAnswered)
    const after = this.workspace.after ?? before
    const isClosed = this.workspace.after !== null
    const look = this.looks.look(isClosed ? [before, after] : [before])
    const ringed = isClosed && plan.steps.some((step) => step.step === 'annuloplasty')
    if (this.before.shown !== before) this.before.set(before, look)
    if (this.after.shown !== after || this.ringed !== ringed) this.after.set(after, look, ringed)
    this.ringed = ringed
    this.afterTitle.textContent = problems.length > 0 ? 'Not closed: the valve without a repair' : 'Repaired'
    this.editor.update()
    this.kept.update()
    this.accept.disabled = this.save.button.disabled = this.workspace.after === null || !isAnswered
    this.problems.replaceChildren(problemList(problems))
    this.said.textContent = !isAnswered ? 'closing ...' : answer_ms === null ? '' : `Closed and measured in ${Math.round(answer_ms)} ms.`
    const { warnings } = after.closure
    this.measures.replaceChildren(
      h('h2', {}, 'Measured'),
      ...(warnings.length > 0 && this.workspace.after ? [h('ul', { class: 'warn' }, ...warnings.map((words) => h('li', {}, words)))] : []),
      measures(before, this.workspace.after),
    )
    this.draw()
  }

  private draw(): void {
    const { before } = this.workspace
    if (!before || this.before.shown !== before) return
    const after = this.workspace.after ?? before
    const look = this.looks.look(this.workspace.after ? [before, after] : [before])
    this.before.show(look)
    this.after.show(look)
    this.legend.replaceChildren(legend(look.mode, look.scale))
    const { cut } = look
    const sections = [titled('Before', sectionInset(before, cut ?? 0))]
    if (this.workspace.after) sections.push(titled('Repaired', sectionInset(after, cut ?? 0)))
    this.insets.replaceChildren(...(cut === null ? [] : sections))
  }

  private keep(): void {
    this.workspace.keep(`plan ${this.workspace.kept.length + 1}`)
  }
}

function titled(title: string, viewer: Element): HTMLElement {
  return h('figure', {}, h('figcaption', {}, title), viewer)
}
