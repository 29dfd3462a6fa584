// Two nerve hooks on a valve that moves. A press on a leaflet or a chorda grabs it, with the pointer or a finger; it moves in the
// plane through the spot that is parallel to the screen, the wheel moves it along the sight. Who lets go lets the tissue go,
// unless the hook is pinned. Its handle, the hand, takes arrow keys, too.
import { Raycaster } from 'three'
import type { Vector } from '../api/types'
import { h } from '../dom'
import { number } from '../format'
import type { LiveCommand } from '../engine/live_loop'
import { HOOKS, type Picture } from '../engine/picture'
import { at, blend, distance, dot, minus, plus, times } from '../viewer/geometry'
import { pickAt } from '../viewer/pick'
import type { Stage } from '../viewer/stage'
import type { LiveDrawing } from './drawing'
import liveStyle from './live.module.css'

/// What a hook can hold.
export type Grip = ({ vertex: number } | { cable: number; share: number }) & { at_mm: Vector }

interface Held {
  hand_mm: Vector
  pointer: number | null // that drags it
  offset_mm: Vector // from the pointer, in the plane of the screen
  isPinned: boolean // stays where the pointer lets it go
}

interface Handle {
  whole: HTMLElement
  button: HTMLButtonElement
  force: HTMLElement // what the hook pulls with
}

const REACH_PX = 8 // of a chorda
const BEHIND_MM = 1 // a chorda that lies so far behind tissue is hidden
const STEP_MM = 0.5 // a key press
const LONG_STEP_MM = 2 // with Shift
const WHEEL_MM = 0.01 // a pixel that is scrolled
const NAMES = ['Hook 1', 'Hook 2']

export class Hooks {
  readonly element = h('div', { class: liveStyle.hooks, 'data-part': 'hooks' })
  pins = false // each hook stays where it is let go
  path_mm = 0 // of the hands while they hold
  largest_n = 0 // force so far
  onGrab: (grip: Grip) => void = () => {}
  private readonly held: (Held | null)[] = Array<Held | null>(HOOKS).fill(null)
  private readonly handles: Handle[]

  /// `body`: the canvas's parent, which sees events before the camera's controls do.
  constructor(
    private readonly stage: Stage,
    private readonly drawing: LiveDrawing,
    private readonly send: (command: Exclude<LiveCommand, { live: 'start' | 'change' }>) => void,
    body: HTMLElement,
    private readonly isAside: () => boolean, // a press is not for the hooks
  ) {
    this.handles = NAMES.map((name, hook) => this.handle(name, hook))
    this.element.append(...this.handles.map(({ whole }) => whole))
    const early = { capture: true }
    body.addEventListener('pointerdown', (event) => this.press(event), early)
    body.addEventListener('pointermove', (event) => this.drag(event), early)
    body.addEventListener('pointerup', (event) => this.drop(event), early)
    body.addEventListener('pointercancel', (event) => this.drop(event), early)
    body.addEventListener('wheel', (event) => this.wheel(event), { capture: true, passive: false })
    stage.canvas.addEventListener('keydown', (event) => this.key(event))
  }

  /// Moves say where the middle of what it holds is pulled to.
  grab(hook: number, grip: Grip): void {
    this.take(hook, grip, null, null)
  }

  /// Of a hook that holds something. `asked_ms`: when the person moved, of performance.now().
  moveTo(hook: number, hand_mm: Vector, asked_ms = performance.now()): void {
    const held = this.held[hook]
    if (!held || !hand_mm.every(Number.isFinite)) return
    this.path_mm += distance(held.hand_mm, hand_mm)
    held.hand_mm = hand_mm
    this.send({ live: 'move', hook, to_mm: hand_mm, asked_ms })
  }

  release(hook: number): void {
    if (!this.held[hook]) return
    this.held[hook] = null
    this.send({ live: 'release', hook })
    if (document.activeElement === this.handles[hook]?.button) this.stage.canvas.focus()
    this.place()
  }

  releaseAll(): void {
    for (let hook = 0; hook < HOOKS; ++hook) this.release(hook)
  }

  /// What is at the middle of the view, or nearest to it.
  grabMiddle(): void {
    const { nodes, valve } = this.drawing
    const hook = this.free()
    if (hook < 0 || !valve) return
    const { x: width, y: height } = this.stage.size
    const count = valve.scene.rest_mm.length / 3
    const away = (vertex: number): number => {
      const { x, y, depth } = this.stage.place(at(nodes, vertex))
      return Math.hypot(x - width / 2, y - height / 2) + depth // of two alike the nearer one
    }
    let best = 0
    for (let vertex = 1; vertex < count; ++vertex) if (away(vertex) < away(best)) best = vertex
    this.grabWithFocus(hook, best)
  }

  grabWithFocus(hook: number, vertex: number): void {
    this.take(hook, { vertex, at_mm: at(this.drawing.nodes, vertex) }, null, [0, 0, 0])
    this.place()
    this.handles[hook]?.button.focus()
  }

  /// The first hook that holds nothing; -1: both hold.
  free(): number {
    return this.held.indexOf(null)
  }
  isHeld(hook: number): boolean {
    return this.held[hook] != null
  }
  get isDragged(): boolean {
    return this.held.some((held) => held !== null && held.pointer !== null)
  }

  /// The words of the hooks that hold something.
  forces(): HTMLElement[] {
    return this.handles.filter(({ whole }) => !whole.hidden).map(({ force }) => force)
  }

  /// Tells the forces of a picture.
  tell({ hooks }: Picture): void {
    for (const [hook, state] of hooks.entries()) {
      const handle = this.handles[hook]
      if (handle) handle.force.textContent = `${number(state?.force_n, 2)} N`
      if (state && this.held[hook]) this.largest_n = Math.max(this.largest_n, state.force_n)
    }
    this.place()
  }

  /// The handles to where the hands are seen.
  place(): void {
    for (const [hook, { whole }] of this.handles.entries()) {
      const held = this.held[hook]
      whole.hidden = !held
      if (!held) continue
      const { x, y } = this.stage.place(held.hand_mm)
      whole.style.transform = `translate(${x.toFixed(1)}px, ${y.toFixed(1)}px)`
    }
  }

  private handle(name: string, hook: number): Handle {
    const force = h('span', { 'aria-hidden': 'true', 'data-part': 'force' })
    const label = `${name}: drag, or arrow keys; Page Up lifts, Page Down lowers, Escape releases`
    const button = h('button', {
      type: 'button',
      'aria-label': label,
      title: label,
      onkeydown: (event: KeyboardEvent) => this.step(hook, event),
    })
    const whole = h('div', { class: liveStyle.hook, 'data-part': 'hook', hidden: true }, button, force)
    return { whole, button, force }
  }

  /// `offset_mm`: from the pointer to the hand; null: of no hand.
  private take(hook: number, grip: Grip, pointer: number | null, offset_mm: Vector | null): void {
    this.held[hook] = { hand_mm: grip.at_mm, pointer, offset_mm: offset_mm ?? [0, 0, 0], isPinned: false }
    const at_mm = offset_mm && grip.at_mm
    if ('vertex' in grip) this.send({ live: 'grab', hook, vertex: grip.vertex, at_mm })
    else this.send({ live: 'grab cable', hook, cable: grip.cable, share: grip.share, at_mm })
    this.onGrab(grip)
  }

  private press(event: PointerEvent): void {
    if (event.button !== 0 || this.isAside()) return
    const again = this.handles.findIndex(({ button }) => button.contains(event.target as Node))
    const held = this.held[again]
    if (held) {
      this.follow(event)
      held.pointer = event.pointerId
      held.isPinned = false
      held.offset_mm = minus(held.hand_mm, this.onPlane(event, held.hand_mm))
      return
    }
    if (event.target !== this.stage.canvas) return
    const grip = this.gripAt(event)
    if (!grip) return
    this.follow(event)
    const hook = this.free()
    if (hook >= 0) this.take(hook, grip, event.pointerId, minus(grip.at_mm, this.onPlane(event, grip.at_mm)))
    this.place()
  }

  /// The camera stays where it is; the canvas has the pointer and the keys until it is let go.
  private follow(event: PointerEvent): void {
    event.stopPropagation()
    event.preventDefault()
    if (event.target === this.stage.canvas) this.stage.canvas.focus({ preventScroll: true })
    ;(event.target as HTMLElement).setPointerCapture(event.pointerId)
  }

  private drag(event: PointerEvent): void {
    const hook = this.heldBy(event)
    const held = this.held[hook]
    if (!held) return
    event.stopPropagation()
    this.moveTo(hook, plus(this.onPlane(event, held.hand_mm), held.offset_mm), event.timeStamp)
    this.place()
  }

  private drop(event: PointerEvent): void {
    const hook = this.heldBy(event)
    const held = this.held[hook]
    if (!held) return
    event.stopPropagation()
    held.pointer = null
    held.isPinned ||= this.pins || event.shiftKey
    if (!held.isPinned) this.release(hook)
  }

  private heldBy(event: PointerEvent): number {
    return this.held.findIndex((held) => held?.pointer === event.pointerId)
  }

  private wheel(event: WheelEvent): void {
    const hook = this.held.findIndex((held) => held !== null && held.pointer !== null)
    const held = this.held[hook]
    if (!held) return
    event.preventDefault()
    event.stopPropagation()
    const { away } = this.axes()
    const side = dot(away, this.atrial) < 0 ? -1 : 1 // scrolling up lifts
    this.moveTo(hook, plus(held.hand_mm, times(-WHEEL_MM * side * event.deltaY, away)), event.timeStamp)
    this.place()
  }

  /// Towards the atrium.
  private get atrial(): Vector {
    return this.drawing.valve?.scene.plane.normal ?? [0, 0, 1]
  }

  /// What is held, towards the atrium.
  lift(by_mm: number): void {
    for (const [hook, held] of this.held.entries())
      if (held) this.moveTo(hook, plus(held.hand_mm, times(by_mm, this.atrial)))
    this.place()
  }

  private key(event: KeyboardEvent): void {
    const dragged = this.held.find((held) => held !== null && held.pointer !== null)
    if (event.key === 'Enter' && !this.isAside()) this.grabMiddle()
    else if (event.key === 'Escape') this.releaseAll()
    else if (event.key.toLowerCase() === 'p' && dragged) dragged.isPinned = true
    else return
    event.preventDefault()
  }

  private step(hook: number, event: KeyboardEvent): void {
    const held = this.held[hook]
    const { right, up } = this.axes()
    const ways: Record<string, Vector> = {
      ArrowLeft: times(-1, right),
      ArrowRight: right,
      ArrowUp: up,
      ArrowDown: times(-1, up),
      PageUp: this.atrial,
      PageDown: times(-1, this.atrial),
    }
    const way = ways[event.key]
    if (event.key === 'Escape') this.release(hook)
    else if (way && held)
      this.moveTo(hook, plus(held.hand_mm, times(event.shiftKey ? LONG_STEP_MM : STEP_MM, way)), event.timeStamp)
    else return
    event.preventDefault()
    this.place()
  }

  /// Of the screen, as long as 1.
  private axes(): { right: Vector; up: Vector; away: Vector } {
    const { elements } = this.stage.camera.matrixWorld
    const column = (k: number): Vector => at(elements, 0).map((_, axis) => elements[4 * k + axis] ?? 0) as Vector
    return { right: column(0), up: column(1), away: times(-1, column(2)) }
  }

  /// Under the pointer, in the plane through a point that is parallel to the screen.
  private onPlane(event: MouseEvent, through_mm: Vector): Vector {
    const { ray } = this.rayAt(event)
    const eye = ray.origin.toArray()
    const way = ray.direction.toArray()
    const { away } = this.axes()
    return plus(eye, times(dot(minus(through_mm, eye), away) / dot(way, away), way))
  }

  private rayAt(event: MouseEvent): Raycaster {
    const ray = new Raycaster()
    ray.setFromCamera(this.stage.pointer(event), this.stage.camera)
    return ray
  }

  private gripAt(event: PointerEvent): Grip | null {
    const { leaflets, valve, nodes } = this.drawing
    if (!leaflets || !valve) return null
    const pick = pickAt(event, this.stage, valve.scene, nodes, leaflets, ['leaflet'])
    const eye = this.stage.camera.position.toArray()
    const cable = this.cableAt(event)
    const isSeen = cable && (!pick || distance(cable.at_mm, eye) < distance(pick.point_mm, eye) + BEHIND_MM)
    if (isSeen) return cable
    if (pick?.kind !== 'leaflet') return null
    const corner = pick.weights.indexOf(Math.max(...pick.weights))
    const vertex = valve.scene.faces[3 * pick.face + corner] as number
    return { vertex, at_mm: at(nodes, vertex) }
  }

  /// The cable that is seen nearest to the pointer, within reach.
  private cableAt(event: MouseEvent): Extract<Grip, { cable: number }> | null {
    const box = this.stage.canvas.getBoundingClientRect()
    const pointer = { x: event.clientX - box.left, y: event.clientY - box.top }
    const { cableLines } = this.drawing
    let found: Extract<Grip, { cable: number }> | null = null
    let least = REACH_PX
    for (let cable = 0; 6 * cable < cableLines.length; ++cable) {
      const [a, b] = [at(cableLines, 2 * cable), at(cableLines, 2 * cable + 1)]
      const [from, to] = [this.stage.place(a), this.stage.place(b)]
      const way = { x: to.x - from.x, y: to.y - from.y }
      const along = ((pointer.x - from.x) * way.x + (pointer.y - from.y) * way.y) / (way.x ** 2 + way.y ** 2 || 1)
      const share = Math.min(Math.max(along, 0), 1)
      const away = Math.hypot(from.x + share * way.x - pointer.x, from.y + share * way.y - pointer.y)
      if (!(away < least)) continue
      least = away
      found = { cable, share, at_mm: blend(a, b, share) }
    }
    return found
  }
}
