// Points of the valve that can be grabbed, as buttons over the canvas: with the pointer, a finger or arrow keys. What is
// dragged is told beside the handle and applied once, when it is let go; Escape lets it be as it was.
import type { LeafletPoint, Vector } from '../api/types'
import { h } from '../dom'
import type { Box } from './label_layout'
import { Readout } from './readout'
import type { Stage } from './stage'
import viewerStyle from './viewer.module.css'

/// Where the pointer has come to since it grabbed a handle.
export interface Drag {
  mmAlong(from_mm: Vector, way: Vector): number // seen along this direction
  around(): number // the nearest place of the annulus, 0 to 1
  leaflet(): LeafletPoint | null // under the pointer
}

export interface Handle<Value> {
  key: string // the same handle has the same
  name: string
  at_mm: Vector
  value: number
  range: { min: number; max: number }
  words(value: Value): string
  dragged(drag: Drag): Value | null // null: nothing is there
  stepped(across: number, up: number): Value
}

export interface Grip<Value> {
  handle: Handle<Value>
  present: Value
  apply(value: Value, isPassing: boolean): void // passing: an arrow key is held
}

const HALF_PX = 12 // of a handle
const LEAST_PX = 3 // a millimetre counts at least so much, if it is seen from its end

export class Handles<Value> {
  onGrab: (key: string) => void = () => {} // also by the keyboard
  isLeft: (point_mm: Vector) => boolean = () => true // by a cut
  readonly element = h('div', { class: viewerStyle.handles, 'data-part': 'handles' })
  private readonly told = new Readout('dragged')
  private grips: Grip<Value>[] = []
  private readonly buttons = new Map<string, HTMLElement>()
  private stepping = false // an arrow key is held
  private held: { key: string; from: [number, number]; value: Value | null } | null = null

  constructor(
    private readonly stage: Stage,
    private readonly around: (event: PointerEvent) => number,
    private readonly leaflet: (event: PointerEvent) => LeafletPoint | null,
  ) {
    this.element.append(this.told.element)
    stage.onFrame.push(() => this.place())
  }

  /// Those that stay keep the focus, and the pointer that holds them.
  set(grips: Grip<Value>[]): void {
    this.grips = grips
    const keys = new Set(grips.map(({ handle }) => handle.key))
    for (const [key, button] of this.buttons) {
      if (keys.has(key)) continue
      button.remove()
      this.buttons.delete(key)
      if (this.held?.key === key) this.letGo()
    }
    for (const { handle, present } of grips) {
      const button = this.buttons.get(handle.key) ?? this.make(handle.key)
      const { min, max } = handle.range
      for (const [name, value] of Object.entries({
        label: handle.name,
        valuemin: min,
        valuemax: max,
        valuenow: handle.value,
        valuetext: handle.words(present),
      }))
        button.setAttribute(`aria-${name}`, String(value))
      button.title = `${handle.name}: drag, or arrow keys`
    }
    this.place()
  }

  /// The first that begins so; empty if none does.
  keyOf(start: string): string {
    return this.grips.find(({ handle }) => handle.key.startsWith(start))?.handle.key ?? ''
  }

  boxes(): Box[] {
    const shown = this.grips.filter(({ handle }) => this.isLeft(handle.at_mm))
    return shown.map(({ handle }) => {
      const { x, y } = this.stage.place(handle.at_mm)
      return { left: x - HALF_PX, top: y - HALF_PX, right: x + HALF_PX, bottom: y + HALF_PX }
    })
  }

  private make(key: string): HTMLElement {
    const button = h('button', {
      type: 'button',
      role: 'slider',
      'data-part': 'handle',
      onpointerdown: (event: PointerEvent) => this.grab(key, event),
      onpointermove: (event: PointerEvent) => this.drag(event),
      onpointerup: () => this.drop(),
      onpointercancel: () => this.letGo(),
      onfocus: () => this.onGrab(key),
      onkeydown: (event: KeyboardEvent) => this.step(key, event),
      onkeyup: () => this.stepped(key),
      onblur: () => this.stepped(key),
    })
    this.buttons.set(key, button)
    this.element.append(button)
    return button
  }

  private grip(key: string): Grip<Value> | undefined {
    return this.grips.find(({ handle }) => handle.key === key)
  }

  private place(): void {
    for (const { handle } of this.grips) {
      const button = this.buttons.get(handle.key)
      if (!button || this.held?.key === handle.key) continue
      const { x, y, depth } = this.stage.place(handle.at_mm)
      button.hidden = depth > 1 || !this.isLeft(handle.at_mm)
      button.style.transform = `translate(${x.toFixed(1)}px, ${y.toFixed(1)}px)`
    }
  }

  private grab(key: string, event: PointerEvent): void {
    const button = this.buttons.get(key)
    if (!button || event.button !== 0) return
    event.preventDefault()
    button.focus()
    button.setPointerCapture(event.pointerId)
    this.held = { key, from: [event.clientX, event.clientY], value: null }
  }

  private drag(event: PointerEvent): void {
    const { held } = this
    const grip = held && this.grip(held.key)
    if (!held || !grip) return
    const moved: [number, number] = [event.clientX - held.from[0], event.clientY - held.from[1]]
    held.value = grip.handle.dragged({
      mmAlong: (from_mm, way) => this.mmAlong(from_mm, way, moved),
      around: () => this.around(event),
      leaflet: () => this.leaflet(event),
    })
    const box = this.stage.canvas.getBoundingClientRect()
    const place = { x: event.clientX - box.left, y: event.clientY - box.top }
    const button = this.buttons.get(held.key)
    if (button) button.style.transform = `translate(${place.x}px, ${place.y}px)`
    this.told.show(held.value === null ? 'not on a leaflet' : grip.handle.words(held.value), place, box)
  }

  private mmAlong(from_mm: Vector, way: Vector, [across, down]: [number, number]): number {
    const from = this.stage.place(from_mm)
    const to = this.stage.place([from_mm[0] + way[0], from_mm[1] + way[1], from_mm[2] + way[2]])
    const [dx, dy] = [to.x - from.x, to.y - from.y]
    const pixels = Math.hypot(dx, dy)
    if (pixels === 0) return down / LEAST_PX
    return (across * dx + down * dy) / pixels / Math.max(pixels, LEAST_PX)
  }

  private drop(): void {
    const value = this.held?.value ?? null
    const grip = this.held && this.grip(this.held.key)
    this.letGo()
    if (grip && value !== null) grip.apply(value, false)
  }

  private letGo(): void {
    this.held = null
    this.told.hide()
    this.place()
  }

  private step(key: string, event: KeyboardEvent): void {
    const ways: Record<string, [number, number]> = {
      ArrowLeft: [-1, 0],
      ArrowRight: [1, 0],
      ArrowUp: [0, 1],
      ArrowDown: [0, -1],
    }
    if (event.key === 'Escape' && this.held) this.letGo()
    const way = ways[event.key]
    const grip = this.grip(key)
    if (!way || !grip) return
    event.preventDefault()
    this.stepping = true
    grip.apply(grip.handle.stepped(...way), true)
  }

  private stepped(key: string): void {
    const grip = this.grip(key)
    if (grip && this.stepping) grip.apply(grip.present, false)
    this.stepping = false
  }
}
