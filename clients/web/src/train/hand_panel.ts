// Beside a flaccid valve that is pulled: the force of each hook, and buttons for those who have no wheel or no pointer.
import type { Vector } from '../api/types'
import { button, h } from '../dom'
import { withUnit } from '../format'
import { HOOKS, type Picture } from '../engine/picture'
import type { LiveCanvas } from '../live/canvas'
import { plus, times } from '../viewer/geometry'
import parts from '../style/parts.module.css'
import { panel } from './frame'
import trainStyle from './train.module.css'
import { type SegmentName, SEGMENTS } from './types'

const FULL_N = 1 // a whole bar; valve analysis pulls with some tenths of a newton
const LIFT_MM = 1

export class HandPanel {
  readonly element: HTMLElement
  readonly grid: HTMLElement // of buttons that grab a segment's free edge
  up: Vector = [0, 0, 1] // towards the atrium
  private readonly rows = Array.from({ length: HOOKS }, () => ({
    bar: h('meter', { min: 0, max: FULL_N, value: 0, 'aria-hidden': 'true' }),
    force: h('td', { class: parts.number }),
  }))

  constructor(private readonly canvas: LiveCanvas) {
    const pins = h('input', { type: 'checkbox', onchange: () => (canvas.hooks.pins = pins.checked) })
    this.grid = h(
      'div',
      { class: trainStyle.segments, role: 'group', 'aria-label': 'Grab the middle of a free edge' },
      ...SEGMENTS.map((segment) => this.grabber(segment)),
    )
    this.element = panel(
      'Hooks',
      h(
        'table',
        { class: trainStyle.forces, 'data-part': 'forces' },
        ...this.rows.map(({ bar, force }, hook) =>
          h('tr', {}, h('th', { scope: 'row' }, `Hook ${hook + 1}`), h('td', {}, bar), force),
        ),
      ),
      this.grid,
      h(
        'p',
        { class: parts.row },
        button('Lift', () => this.lift(LIFT_MM), { title: `What is held, ${LIFT_MM} mm towards the atrium` }),
        button('Lower', () => this.lift(-LIFT_MM), { title: `What is held, ${LIFT_MM} mm towards the ventricle` }),
        button('Let go', () => canvas.hooks.releaseAll()),
      ),
      h('label', { class: parts.check }, pins, 'Pin hooks where they are let go'),
      h(
        'details',
        { class: parts.more },
        h('summary', {}, 'How to pull'),
        h(
          'ul',
          { class: parts.hint },
          h('li', {}, 'Press a leaflet and drag; the wheel moves the hook along the view.'),
          h('li', {}, 'Or grab the middle of a free edge by its segment’s button, then lift it.'),
          h('li', {}, 'Two hooks: two fingers, or pin the first and press again.'),
          h('li', {}, 'Keys: Enter grabs, arrows and Page Up or Down move the hook, Escape lets go.'),
        ),
      ),
    )
    this.tell(null)
  }

  tell(picture: Picture | null): void {
    for (const [hook, { bar, force }] of this.rows.entries()) {
      const state = picture?.hooks[hook]
      bar.value = state?.force_n ?? 0
      force.textContent = state ? withUnit(state.force_n, 'N', 2) : '–'
    }
  }

  /// A button with the name of a segment.
  grabber(segment: SegmentName): HTMLButtonElement {
    return button(segment, () => this.grab(segment), { title: `Grab the free edge of ${segment}` })
  }

  private grab(segment: string): void {
    this.canvas.hooks.releaseAll()
    this.canvas.grabEdge(segment)
  }

  private lift(by_mm: number): void {
    const { hooks, picture } = this.canvas
    for (const [hook, state] of (picture?.hooks ?? []).entries())
      if (state) hooks.moveTo(hook, plus(state.hand_mm, times(by_mm, this.up)))
    hooks.place()
  }
}
