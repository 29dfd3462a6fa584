// Beside a flaccid valve that is pulled: the force of each hook, and what grabs and lifts.
import { h } from '../dom'
import { withUnit } from '../format'
import { HOOKS, type Picture } from '../engine/picture'
import type { LiveCanvas } from '../live/canvas'
import { grabbers, lifts } from '../live/controls'
import parts from '../style/parts.module.css'
import { panel } from './frame'
import trainStyle from './train.module.css'

const FULL_N = 1 // a whole bar; valve analysis pulls with some tenths of a newton

export class HandPanel {
  readonly element: HTMLElement
  readonly grid: HTMLElement // of buttons that grab a segment's free edge
  private readonly rows = Array.from({ length: HOOKS }, () => ({
    bar: h('meter', { min: 0, max: FULL_N, value: 0, 'aria-hidden': 'true' }),
    force: h('td', { class: parts.number }),
  }))

  constructor(canvas: LiveCanvas) {
    const pins = h('input', { type: 'checkbox', onchange: () => (canvas.hooks.pins = pins.checked) })
    this.grid = grabbers(canvas)
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
      lifts(canvas),
      h('label', { class: parts.check }, pins, 'Keep hooks in place after release'),
      h(
        'details',
        { class: parts.more },
        h('summary', {}, 'How to pull'),
        h(
          'ul',
          { class: parts.hint },
          h('li', {}, 'Press a leaflet and drag; the wheel moves the hook along the viewing direction.'),
          h('li', {}, 'Or grab the middle of a free edge with the button of its segment, then lift it.'),
          h('li', {}, 'Two hooks: use two fingers, or keep the first in place and press again.'),
          h(
            'li',
            {},
            'Keys: Enter grabs, arrow keys move the hook, Page Up lifts it, Page Down lowers it, Escape releases it.',
          ),
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
}
