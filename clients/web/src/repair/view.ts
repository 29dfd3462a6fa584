// A repair by hand: the valve before and after, side by side, and what it would measure.
import type { Step } from '../api/types'
import { h } from '../dom'
import { closureSaver, type FileSaver } from '../files'
import type { Figure } from '../picture/figure'
import { figureLines, pictureSaver } from '../picture/saver'
import { labelledButton } from '../icons'
import { problemList } from '../problems'
import type { Slide } from '../story/types'
import type { Command, View } from '../view'
import { certainty } from '../valve/certainty'
import { Looks } from '../valve/looks'
import { headline } from '../valve/headline'
import { measures } from '../valve/measures'
import { sectionInset } from '../valve/section_inset'
import { TissueError } from '../valve/tissue_error'
import { kindsOn, legend } from '../viewer/legend'
import type { Grip } from '../viewer/handles'
import { Viewer } from '../viewer/viewer'
import type { Sight } from '../viewer/stage'
import { problemsOf, type Workspace } from '../workspace'
import { handlesOf } from './handles'
import { KeptPlans } from './kept_plans'
import { Picking } from './picking'
import { PlanEditor } from './plan_editor'
import { hasRing } from './steps'
import { TolerancePanel } from './tolerance_panel'
import parts from '../style/parts.module.css'
import repairStyle from './repair.module.css'
import valveStyle from '../valve/valve.module.css'
import viewerStyle from '../viewer/viewer.module.css'

export class RepairView implements View {
  readonly element: HTMLElement
  private readonly before = new Viewer('The valve before the repair')
  private readonly after = new Viewer('The repaired valve; click it to pick points')
  private readonly looks = new Looks(false)
  private readonly editor: PlanEditor
  private readonly kept: KeptPlans
  private readonly legend = h('div', {})
  private readonly headline = h('div', {})
  private readonly tissue = new TissueError(() => this.tell())
  private readonly insets = {
    before: h('div', { class: valveStyle.inset, hidden: true }),
    after: h('div', { class: valveStyle.inset, hidden: true }),
  }
  private readonly certainty: HTMLElement
  private readonly measures = h('section', { class: parts.panel, 'aria-label': 'Measured' })
  private readonly problems = h('div', {})
  private readonly said = h('p', { class: repairStyle.answer, 'data-part': 'answer', 'aria-live': 'polite' })
  /// Chordae of the plan itself are none that it may change.
  private readonly picking = new Picking((kinds) =>
    kinds.includes('chorda') ? [this.before] : [this.before, this.after],
  )
  private readonly tolerance: TolerancePanel
  private readonly save: FileSaver
  private ringed = false // the valve on the right has a ring
  private readonly afterTitle = h('figcaption', {})
  private readonly accept = labelledButton('keep', 'Keep', 'Keep this repair', () => void this.keep(), {
    class: parts.primary,
  })

  constructor(private readonly workspace: Workspace) {
    this.certainty = certainty(workspace, true)
    this.save = closureSaver(workspace, true, this.problems)
    this.editor = new PlanEditor(workspace, (request) => this.picking.ask(request, workspace.plan))
    this.kept = new KeptPlans(workspace)
    this.tolerance = new TolerancePanel(workspace, this.after, () => this.editor.rings)
    this.after.handles.onGrab = (key) => this.tolerance.grab(key)
    this.before.stage.pair(this.after.stage)
    this.before.inset = this.insets.before
    this.after.inset = this.insets.after
    this.looks.onChange = () => this.draw()
    this.looks.onView = (view) => this.before.view(view)
    this.element = h(
      'div',
      { class: `${parts.sides} ${repairStyle.repair}` },
      h(
        'div',
        { class: viewerStyle.stage },
        h('h1', { class: parts.unseen }, 'Repair'),
        h(
          'div',
          { class: viewerStyle.tools },
          this.looks.views,
          this.accept,
          this.save.element,
          pictureSaver((width_px) => this.figure(width_px), this.problems),
        ),
        h(
          'div',
          { class: repairStyle.asking },
          h('div', { class: repairStyle.outcome }, this.headline, this.said),
          this.picking.element,
        ),
        this.problems,
        h(
          'div',
          { class: `${viewerStyle.stageBody} ${repairStyle.both}` },
          h('figure', {}, h('figcaption', {}, 'Before'), this.before.element, this.insets.before),
          h('figure', {}, this.afterTitle, this.after.element, this.insets.after),
        ),
        this.legend,
      ),
      h(
        'div',
        { class: parts.side },
        this.editor.element,
        this.tolerance.element,
        this.measures,
        this.kept.element,
        this.looks.element,
      ),
    )
    this.element.addEventListener('keydown', (event) => event.key === 'Escape' && this.escape())
    workspace.subscribe(() => this.take())
  }

  show(): void {
    this.take()
  }
  hide(): void {
    this.picking.end()
    this.tolerance.end()
  }

  private escape(): void {
    if (this.picking.isAsking) this.picking.end()
    else this.tolerance.end()
  }

  settings(): Command[] {
    return this.looks.settings()
  }

  perform({ camera, vary, ...shown }: Slide): void {
    this.looks.ask(shown)
    if (camera) this.before.view(camera)
    if (vary !== undefined) this.tolerance.grab(this.after.handles.keyOf(`${vary - 1} `))
    else this.tolerance.end()
  }
  get sight(): Sight | null {
    return this.before.sight
  }

  private take(): void {
    const { before, problems, plan, answer_ms, isAnswered } = this.workspace
    if (!before || !this.element.isConnected) return
    this.picking.follow(plan)
    this.element.setAttribute('aria-busy', String(!isAnswered))
    const after = this.workspace.after ?? before
    const isClosed = this.workspace.after !== null
    const look = this.looks.look(isClosed ? [before, after] : [before])
    const ringed = isClosed && hasRing(plan)
    if (this.before.shown !== before) this.before.set(before, look)
    if (this.after.shown !== after || this.ringed !== ringed) this.after.set(after, look, ringed)
    this.ringed = ringed
    this.afterTitle.textContent =
      problems.length > 0 ? 'The repaired valve could not be closed; the valve is shown without the repair' : 'Repaired'
    this.editor.update()
    this.kept.update()
    this.accept.disabled = this.save.button.disabled = this.workspace.after === null || !isAnswered
    this.problems.replaceChildren(problemList(problems))
    this.said.textContent = !isAnswered
      ? 'closing ...'
      : answer_ms === null
        ? ''
        : `Closed and measured in ${Math.round(answer_ms)} ms.`
    const { warnings } = after.closure
    this.tell()
    this.measures.replaceChildren(
      h('h2', {}, 'Measured'),
      ...(warnings.length > 0 && this.workspace.after
        ? [h('ul', { class: parts.warn }, ...warnings.map((words) => h('li', {}, words)))]
        : []),
      this.certainty,
      measures(before, this.workspace.after),
    )
    this.draw()
    this.after.handles.set(this.grips())
    this.tolerance.follow()
  }

  /// What is passed through while a handle is drawn has its numerical error alone.
  private tell(): void {
    const { before, after, plan, valve, isAnswered } = this.workspace
    if (!before) return
    const drawn = isAnswered ? this.tissue.of(after ?? before, valve?.reference, after ? plan : null) : null
    this.headline.replaceChildren(headline(before, after, drawn))
  }

  /// Of the repair that is shown; none while there is none.
  private grips(): Grip<Step>[] {
    const { before, after, plan } = this.workspace
    if (!before || !after) return []
    return handlesOf(plan, { before, ringed: after }, this.editor.rings).map(({ step, handle }) => ({
      handle,
      present: plan.steps[step] as Step,
      apply: (value, isPassing) => this.apply(step, value, isPassing),
    }))
  }

  private apply(i: number, step: Step, isPassing: boolean): void {
    const steps = this.workspace.plan.steps.map((other, at) => (at === i ? step : other))
    void this.workspace.setPlan(steps, isPassing)
  }

  private draw(): void {
    const { before } = this.workspace
    if (!before || this.before.shown !== before) return
    const after = this.workspace.after ?? before
    const look = this.looks.look(this.workspace.after ? [before, after] : [before])
    this.before.show(look)
    this.after.show(look)
    this.legend.replaceChildren(legend(look.mode, look.scale, kindsOn([before, after], this.ringed)))
    const { cut } = look
    this.insets.before.hidden = cut === null
    this.insets.after.hidden = cut === null || this.workspace.after === null
    if (cut === null) return
    this.insets.before.replaceChildren(sectionInset(before, cut))
    this.insets.after.replaceChildren(sectionInset(after, cut))
  }

  private figure(width_px: number): Figure {
    const { before, after, plan, valve } = this.workspace
    if (!before) throw new Error('No valve is open.')
    const { scale } = this.looks.look(after ? [before, after] : [before])
    const shown = after ? [this.before, this.after] : [this.before]
    const titles = after ? ['Before', 'Repaired'] : ['']
    const shots = shown.map((viewer, i) => ({ title: titles[i] ?? '', shot: viewer.shot(width_px / shown.length) }))
    const kinds = kindsOn(after ? [before, after] : [before], this.ringed)
    return { name: valve?.label ?? 'valve', lines: figureLines(before, after, plan), shots, scale, kinds }
  }

  private async keep(): Promise<void> {
    try {
      const { kept, isNew } = await this.workspace.keep(`plan ${this.workspace.kept.length + 1}`)
      this.said.textContent = isNew ? `Kept as “${kept.name}”.` : `This repair is already kept as “${kept.name}”.`
    } catch (error) {
      this.problems.replaceChildren(problemList(problemsOf(error)))
    }
  }
}
