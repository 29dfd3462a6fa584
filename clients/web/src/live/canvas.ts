// A valve that moves, to be pulled: canvas, hooks, rates. A component of views; it needs no service and no closure.
import type { Plan, Vector } from '../api/types'
import { h } from '../dom'
import { number } from '../format'
import { readPicture, type Picture } from '../engine/picture'
import { hasRing } from '../repair/steps'
import { at, onFace } from '../viewer/geometry'
import { boxesOver } from '../viewer/label_layout'
import { type Label, Labels } from '../viewer/labels'
import { type Camera, lookAt } from '../viewer/camera'
import { turnToCut } from '../viewer/cut_sight'
import { wholeValve } from '../viewer/marks'
import { Neighbours } from '../viewer/neighbours'
import { pickAt, type Pick, type PickKind } from '../viewer/pick'
import { type Sight, Stage, type ViewName } from '../viewer/stage'
import { startLive, type LiveClient, type LivePicture, type LiveValve } from './client'
import { cutOf, LiveDrawing, type LiveLook } from './drawing'
import { Hooks } from './hooks'
import { Pictures, Rate } from './rates'
import { edgeOf } from './surface'
import liveStyle from './live.module.css'
import viewerStyle from '../viewer/viewer.module.css'

const TURNED_PX = 4 // a pointer that moved so far has turned the valve, not clicked it

export interface LiveOptions {
  label: string // of the canvas
  view: ViewName
  isFixed: boolean // it cannot be turned
  look: LiveLook
}

export class LiveCanvas {
  readonly element: HTMLElement
  readonly stage: Stage
  readonly hooks: Hooks
  look: LiveLook
  picture: Picture | null = null // that is drawn
  picks: PickKind[] = [] // what a click may mean, in place of a hook
  onPick: ((pick: Pick) => void) | null = null
  onPicture: (picture: Picture) => void = () => {} // after each drawing
  onFailure: (message: string) => void = () => {}
  latency_ms: number | null = null // from the last move to its picture
  private names: Label[] = []
  private marks: Label[] = []
  private labelled = '' // the labels that are set
  private wasCut = false
  private client: LiveClient | null = null
  private readonly labels: Labels
  private readonly drawing: LiveDrawing
  private readonly neighbours: Neighbours
  private readonly steps = new Rate()
  private readonly pictures = new Pictures()
  private readonly rates = h('p', { class: liveStyle.rates, 'data-part': 'rates' })
  private last: LivePicture | null = null // not drawn yet
  private pressed: [number, number] = [0, 0] // where on the screen
  private isShown = false
  private isStarted = false

  constructor(private readonly options: LiveOptions) {
    this.look = options.look
    this.stage = new Stage(options.label)
    this.labels = new Labels(this.stage)
    this.drawing = new LiveDrawing(this.stage)
    this.neighbours = new Neighbours(this.stage)
    this.element = h('div', { class: `${viewerStyle.viewer} ${liveStyle.live}`, 'data-part': 'live' })
    this.hooks = new Hooks(
      this.stage,
      this.drawing,
      (command) => this.client?.send(command),
      this.element,
      () => this.picks.length > 0,
    )
    this.labels.avoid = () => boxesOver(this.stage.canvas, [this.rates, ...this.hooks.forces()])
    this.element.append(this.stage.canvas, this.labels.element, this.hooks.element, this.rates)
    this.stage.controls.enabled = !options.isFixed
    this.stage.controls.addEventListener('change', () => this.redraw())
    this.stage.canvas.addEventListener('pointerdown', ({ clientX, clientY }) => (this.pressed = [clientX, clientY]))
    this.stage.canvas.addEventListener('click', (event) => this.click(event))
    if (options.isFixed) this.stage.canvas.addEventListener('keydown', keepStill, { capture: true })
  }

  /// Another valve; `document`: its text. Rejects with what is wrong with it, or where the browser or the engine is missing.
  async start(document: string, plan: Plan | null, pressure_mmhg?: number): Promise<LiveValve> {
    this.client ??= this.begin()
    this.hooks.releaseAll()
    return this.take(await this.client.start(document, plan, pressure_mmhg), plan)
  }

  /// The same valve with another plan.
  async change(document: string, plan: Plan | null): Promise<LiveValve> {
    if (!this.client) return this.start(document, plan)
    return this.take(await this.client.change(document, plan), plan)
  }

  setPressure(mmhg: number): void {
    this.client?.send({ live: 'pressure', mmhg })
  }

  /// The free edge in the middle of a segment, such as P2; the hook's handle gets the focus.
  grabEdge(segment: string): void {
    const hook = this.hooks.free()
    const vertex = this.drawing.valve ? edgeOf(this.drawing.valve.scene, segment) : -1
    if (hook >= 0 && vertex >= 0) this.hooks.grabWithFocus(hook, vertex)
  }
  /// The same, lifted towards the atrium; the focus stays where it is.
  pullEdge(segment: string, lift_mm: number): void {
    const vertex = this.drawing.valve ? edgeOf(this.drawing.valve.scene, segment) : -1
    if (vertex < 0) return
    this.grabVertex(0, vertex)
    this.hooks.lift(lift_mm)
    this.hooks.place()
  }
  grabVertex(hook: number, vertex: number): void {
    this.hooks.grab(hook, { vertex, at_mm: at(this.drawing.nodes, vertex) })
  }

  view(camera: Camera): void {
    const scene = this.drawing.valve?.scene
    if (!scene) return
    const { nodes } = this.drawing
    lookAt(this.stage, camera, scene, nodes.length > 0 ? nodes : undefined)
  }
  get sight(): Sight | null {
    const scene = this.drawing.valve?.scene
    return scene ? this.stage.sight(wholeValve(scene)) : null
  }

  /// While it is hidden no picture is asked for; the valve comes to rest.
  show(): void {
    if (this.isShown) return
    this.isShown = true
    this.client?.send({ live: 'picture' })
  }
  hide(): void {
    this.isShown = false
    this.hooks.releaseAll()
  }
  end(): void {
    this.hide()
    this.client?.end()
    this.client = null
  }

  /// With another look, or from elsewhere.
  redraw(): void {
    if (this.picture) {
      this.turnToCut()
      this.drawing.move(this.picture, this.look)
    }
    this.setLabels()
    this.hooks.place()
    this.stage.draw()
  }

  /// Lines over everything, six numbers each.
  draw(points: number[]): void {
    this.drawing.measure(points)
    this.stage.draw()
  }
  /// Words over the valve: what its parts are called; what was picked.
  name(labels: Label[]): void {
    this.names = labels
    this.mark(this.marks)
  }
  mark(labels: Label[]): void {
    this.marks = labels
    this.setLabels()
  }

  /// Where a point that was picked is now.
  placeOf(pick: Pick): Vector {
    const scene = this.drawing.valve?.scene
    return scene && pick.kind === 'leaflet' ? onFace(scene, this.drawing.nodes, pick.face, pick.weights) : pick.point_mm
  }

  get stepsPerSecond(): number {
    return this.steps.aSecond
  }
  get picturesPerSecond(): number {
    return this.pictures.aSecond
  }
  get vertices(): Float32Array {
    return this.drawing.nodes.subarray(0, this.drawing.valve?.scene.rest_mm.length ?? 0)
  }

  /// Names of what the cut leaves, root and appendage where the valve is seen from above, and what was picked.
  private setLabels(): void {
    const scene = this.drawing.valve?.scene ?? null
    const beside = this.neighbours.show(scene)
    const names = [...this.names, ...beside].filter(({ point_mm }) => this.drawing.leaves(point_mm, this.look))
    const labels = [...names, ...this.marks]
    const asked = JSON.stringify(labels)
    if (asked === this.labelled) return
    this.labelled = asked
    this.labels.set(labels)
    this.stage.draw()
  }

  /// Once, when the valve is cut.
  private turnToCut(): void {
    const scene = this.drawing.valve?.scene
    const cut = scene ? cutOf(scene, this.look) : null
    const isNew = cut !== null && !this.wasCut
    this.wasCut = cut !== null
    const { nodes } = this.drawing
    if (scene && cut && isNew) turnToCut(this.stage, scene, nodes.length > 0 ? nodes : undefined, cut)
  }

  private begin(): LiveClient {
    const client = startLive()
    client.onPicture = (picture) => this.receive(picture)
    client.onFailure = (message) => this.onFailure(message)
    if (this.isShown) client.send({ live: 'picture' })
    return client
  }

  /// What the engine has let go, because the tissue or chorda that it held is another one, is let go here, too.
  private take(valve: LiveValve, plan: Plan | null): LiveValve {
    for (const [hook, holds] of valve.hooks.entries()) if (!holds) this.hooks.release(hook)
    this.last = null
    this.drawing.set(valve, hasRing(plan))
    if (!this.isStarted || this.options.isFixed) this.view(this.options.view)
    this.isStarted = true
    this.client?.send({ live: 'picture' })
    return valve
  }

  private receive(picture: LivePicture): void {
    if (!this.drawing.valve) return
    if (this.last === null) requestAnimationFrame(() => this.present())
    this.last = picture
  }

  private present(): void {
    const { last } = this
    this.last = null
    if (!last || !this.drawing.valve) return
    if (this.isShown) this.client?.send({ live: 'picture' })
    this.picture = readPicture(last.numbers, this.drawing.valve.cables.length)
    this.turnToCut()
    this.drawing.move(this.picture, this.look)
    this.hooks.tell(this.picture)
    this.stage.drawNow()
    const now_ms = performance.now()
    if (last.asked_ms !== null) this.latency_ms = now_ms - last.asked_ms
    this.steps.add(last.steps, last.running_ms)
    this.pictures.drawn(now_ms)
    this.rates.textContent = this.rateWords()
    this.onPicture(this.picture)
  }

  private rateWords(): string {
    const steps = Math.round(this.stepsPerSecond / 100) * 100
    const words = [`${steps.toLocaleString('en')} steps per second`]
    if (this.picturesPerSecond > 0) words.push(`${Math.round(this.picturesPerSecond)} frames per second`)
    if (this.latency_ms !== null) words.push(`${number(this.latency_ms, 0)} ms latency`)
    return words.join(' · ')
  }

  private click(event: MouseEvent): void {
    const { valve, leaflets, nodes } = this.drawing
    const [x, y] = this.pressed
    if (!this.onPick || this.picks.length === 0 || !valve || !leaflets) return
    if (Math.hypot(event.clientX - x, event.clientY - y) > TURNED_PX) return
    const named = this.picks.includes('head') ? this.labels.headAt(event) : null
    const pick = named ?? pickAt(event, this.stage, valve.scene, nodes, leaflets, this.picks)
    if (pick) this.onPick(pick)
  }
}

/// Arrow keys do not turn a valve that is looked at from one side.
function keepStill(event: KeyboardEvent): void {
  if (event.key.startsWith('Arrow') || event.key === '+' || event.key === '-') event.stopImmediatePropagation()
}
