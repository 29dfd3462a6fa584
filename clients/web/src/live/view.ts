// The valve under the hand: pulled, pressed, repaired while it moves.
import type { Plan } from '../api/types'
import { h } from '../dom'
import { EchoPanel } from '../echo/panel'
import { labelledButton } from '../icons'
import type { Picture } from '../engine/picture'
import { problemList } from '../problems'
import { KeptPlans } from '../repair/kept_plans'
import { Picking } from '../repair/picking'
import { PlanEditor } from '../repair/plan_editor'
import { valveText } from '../state/valves'
import { DistanceTool } from '../valve/distance'
import { headline } from '../valve/headline'
import { knownTissue } from '../valve/tissue_error'
import { viewButtons } from '../valve/looks'
import type { View } from '../view'
import { dot, minus } from '../viewer/geometry'
import { namesAround } from '../viewer/marks'
import type { Sight } from '../viewer/stage'
import { problemsOf, type Workspace } from '../workspace'
import { LiveCanvas } from './canvas'
import type { LiveValve } from './client'
import { HookPanel, lookControls, Pressure } from './controls'
import { cutPoint } from './drawing'
import { liveLegend } from './legend'
import { liveScripts } from './scripting'
import { stateWords } from './state_words'
import { offer } from '../shell/scripting'
import { tellReadings } from '../state/readings'
import type { Slide } from '../story/types'
import parts from '../style/parts.module.css'
import repairStyle from '../repair/repair.module.css'
import viewerStyle from '../viewer/viewer.module.css'
import liveStyle from './live.module.css'

export class LiveView implements View {
  readonly element: HTMLElement
  private readonly canvas = new LiveCanvas({
    label: 'The moving valve: press and drag it; Enter grabs the centre, arrow keys rotate it, plus and minus zoom',
    view: 'atrial',
    isFixed: false,
    look: { strain: true, prolapse: true, plane: false, cut: null },
  })
  private readonly pressure = new Pressure((mmhg) => this.canvas.setPressure(mmhg))
  private readonly hooks = new HookPanel(this.canvas)
  private readonly distance = new DistanceTool(this.canvas)
  private readonly picking = new Picking(() => [this.canvas])
  private readonly editor: PlanEditor
  private readonly kept: KeptPlans
  private readonly accept = labelledButton('keep', 'Keep', 'Keep this repair', () => void this.keep(), {
    class: parts.primary,
  })
  private readonly echo = new EchoPanel()
  private readonly headline = h('div', {})
  private readonly legend = h('div', {})
  private readonly state = h('p', { class: liveStyle.state, role: 'status', 'data-part': 'live-state' })
  private readonly told = h('div', {})
  private valve: LiveValve | null = null
  private moving: { reference: string; text: string } | null = null // the valve that moves, and its document
  private asked: { reference: string; plan: Plan } | null = null // last
  private isAsking = false
  private slide: Slide | null = null // of a story, until the valve is at rest and is pulled

  constructor(private readonly workspace: Workspace) {
    this.editor = new PlanEditor(workspace, (request) => this.picking.ask(request, workspace.plan))
    this.kept = new KeptPlans(workspace)
    this.canvas.onPicture = (picture) => this.tell(picture)
    this.canvas.onFailure = (message) => this.refuse(new Error(message))
    const { look } = this.canvas
    const looked = (): void => {
      this.legend.replaceChildren(liveLegend(look))
      this.canvas.redraw()
    }
    looked()
    this.element = h(
      'div',
      { class: parts.sides },
      h(
        'div',
        { class: viewerStyle.stage },
        h('h1', { class: parts.unseen }, 'Live'),
        h(
          'div',
          { class: viewerStyle.tools },
          viewButtons((view) => this.canvas.view(view)),
          this.distance.element,
          this.accept,
        ),
        h('div', { class: repairStyle.asking }, this.state, this.picking.element),
        this.told,
        h('div', { class: viewerStyle.stageBody }, this.canvas.element),
        this.legend,
      ),
      h(
        'div',
        { class: parts.side },
        h(
          'section',
          { class: parts.panel, 'aria-label': 'Press and pull' },
          h('h2', {}, 'Press and pull'),
          this.pressure.element,
          this.hooks.element,
        ),
        lookControls(look, looked),
        this.echo.element,
        this.editor.element,
        h('section', { class: parts.panel }, h('h2', {}, 'Closed, without hooks'), this.headline),
        this.kept.element,
      ),
    )
    this.element.addEventListener('keydown', (event) => event.key === 'Escape' && this.picking.end())
    workspace.subscribe(() => this.take())
  }

  show(): void {
    offer({ live: liveScripts(this.canvas, (mmhg) => this.pressure.set(mmhg)) })
    this.canvas.show()
    this.take()
  }
  hide(): void {
    this.canvas.hide()
    this.picking.end()
    tellReadings({ force_n: null, height_mm: null })
  }

  get sight(): Sight | null {
    return this.canvas.sight
  }
  perform(slide: Slide): void {
    this.slide = slide
    this.canvas.hooks.releaseAll()
    tellReadings({ force_n: null, height_mm: null })
    if (!this.isAsking) this.prepare()
  }

  /// The valve of the slide moves.
  private prepare(): void {
    if (!this.slide || !this.valve) return
    const { camera, pull } = this.slide
    if (camera) this.canvas.view(camera)
    if (pull) this.pressure.set(pull.pressure_mmhg ?? Math.round(this.valve.systole_mmhg))
  }

  /// From where it has closed: an edge that is caught on the way would be held down.
  private pull({ at_rest, beats, pressure_mmhg }: Picture): void {
    const pull = this.slide?.pull
    const asked_mmhg = pull?.pressure_mmhg ?? Math.round(this.valve?.systole_mmhg ?? 0)
    if (!pull || !at_rest || beats || Math.abs(pressure_mmhg - asked_mmhg) > 1) return
    this.slide = null
    this.canvas.pullEdge(pull.segment, pull.lift_mm)
  }

  private take(): void {
    const { before, after, plan, isAnswered } = this.workspace
    if (!before || !this.element.isConnected) return
    this.picking.follow(plan)
    this.editor.update()
    this.kept.update()
    this.accept.disabled = after === null || !isAnswered
    this.headline.replaceChildren(headline(before, after, knownTissue(after ?? before) ?? undefined))
    void this.follow()
  }

  /// The valve and the plan of the workspace; those that were only passed through meanwhile are left out.
  private async follow(): Promise<void> {
    if (this.isAsking) return
    this.isAsking = true
    while (this.isBehind()) await this.askPresent()
    this.isAsking = false
    this.prepare()
  }

  private isBehind(): boolean {
    const { valve, plan } = this.workspace
    return valve !== null && (this.asked?.reference !== valve.reference || this.asked.plan !== plan)
  }

  private async askPresent(): Promise<void> {
    const { valve, plan } = this.workspace
    if (!valve) return
    this.asked = { reference: valve.reference, plan }
    const isOther = this.moving?.reference !== valve.reference
    try {
      const text = isOther ? await valveText(valve.reference) : (this.moving?.text ?? '')
      const before = this.valve
      this.valve = isOther ? await this.canvas.start(text, plan) : await this.canvas.change(text, plan)
      this.moving = { reference: valve.reference, text }
      if (isOther) this.pressure.begin(this.valve)
      const { scene } = this.valve
      const heads = scene.heads.map(({ id, tip_mm }) => ({ point_mm: tip_mm, text: id, kind: 'tip' as const }))
      this.canvas.name([...namesAround(scene, (segment) => segment), ...heads])
      if (isOther || before?.scene.faces.length !== this.valve.scene.faces.length) this.distance.clear()
      this.told.replaceChildren()
    } catch (error) {
      this.refuse(error)
    }
  }

  /// The valve before goes on; if there is none, with the next valve that is opened another attempt is made.
  private refuse(error: unknown): void {
    this.told.replaceChildren(problemList(problemsOf(error)))
  }

  private tell(picture: Picture): void {
    if (this.valve) {
      const { scene } = this.valve
      this.hooks.tell(picture, this.valve)
      this.echo.tell(scene, [picture.nodes], cutPoint(scene, this.canvas.look.cut ?? 0), picture.at_rest)
    }
    if (this.workspace.story) {
      this.pull(picture)
      this.read(picture)
    }
    this.distance.update()
    const words = stateWords(picture)
    if (words !== this.state.textContent) this.state.textContent = words
  }

  /// At rest, to the digits that are shown.
  private read({ hooks: [held], at_rest }: Picture): void {
    const { plane } = this.valve?.scene ?? {}
    const rounded = (value: number, digits: number): number => Number(value.toFixed(digits))
    if (held && !at_rest) return
    tellReadings({
      force_n: held ? rounded(held.force_n, 2) : null,
      height_mm: held && plane ? rounded(dot(minus(held.spot_mm, plane.origin_mm), plane.normal), 1) : null,
    })
  }

  private async keep(): Promise<void> {
    try {
      const { kept, isNew } = await this.workspace.keep(`plan ${this.workspace.kept.length + 1}`)
      this.told.replaceChildren(
        h(
          'p',
          { role: 'status' },
          isNew ? `Kept as “${kept.name}”.` : `This repair is already kept as “${kept.name}”.`,
        ),
      )
    } catch (error) {
      this.refuse(error)
    }
  }
}
