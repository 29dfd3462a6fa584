// A repair by hand: the valve before and after, side by side, and what it would measure.
import '../style/viewer.css'
import '../style/repair.css'
import { request } from '../api/http'
import { button, download, h } from '../dom'
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
  private readonly accept = button('Accept', () => this.keep(), { class: 'primary' })

  constructor(private readonly workspace: Workspace) {
    this.editor = new PlanEditor(workspace, (hint, kinds, use) => {
      this.picking.textContent = hint
      this.picking.hidden = false
      for (const viewer of [this.before, this.after]) {
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
        h('div', { class: 'row' }, this.looks.views, this.accept, button('Save mesh', () => void this.saveMesh(), { class: 'quiet' })),
        this.picking,
        h('div', { class: 'stage-body' }, titled('Before', this.before.element), titled('Repaired', this.after.element)),
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
    const { before, problems, plan, answer_ms } = this.workspace
    if (!before || !this.element.isConnected) return
    const after = this.workspace.after ?? before
    const scenes = this.workspace.after ? [before, after] : [before]
    const look = this.looks.look(scenes)
    if (this.before.shown !== before) this.before.set(before, look)
    if (this.after.shown !== after) this.after.set(after, look, plan.steps.some((step) => step.step === 'annuloplasty'))
    this.editor.update()
    this.kept.update()
    this.accept.disabled = this.workspace.after === null
    this.problems.replaceChildren(problemList(problems))
    this.said.textContent = answer_ms === null ? '' : `Closed and measured in ${Math.round(answer_ms)} ms.`
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
    this.insets.replaceChildren(...(cut === null ? [] : [before, after].map((scene) => sectionInset(scene, cut))))
  }

  private keep(): void {
    this.workspace.keep(`plan ${this.workspace.kept.length + 1}`)
  }

  private async saveMesh(): Promise<void> {
    const { valve, plan } = this.workspace
    if (!valve) return
    const answer = await request('POST', '/v1/exports', { valve: valve.reference, plan, format: 'glb' })
    download('repaired.glb', await answer.blob())
  }
}

function titled(title: string, viewer: HTMLElement): HTMLElement {
  return h('figure', {}, h('figcaption', {}, title), viewer)
}
