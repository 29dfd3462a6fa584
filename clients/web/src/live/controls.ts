// The controls beside a valve that is pulled: pressure, hooks, what is shown.
import { button, field, h } from '../dom'
import { number, withUnit } from '../format'
import { HOOKS, type Picture } from '../engine/picture'
import type { Segment } from '../api/types'
import { dot, minus } from '../viewer/geometry'
import { SEGMENTS } from '../viewer/marks'
import type { LiveCanvas } from './canvas'
import type { LiveValve } from './client'
import type { LiveLook } from './drawing'
import parts from '../style/parts.module.css'
import liveStyle from './live.module.css'

const LIFT_MM = 1

/// A slider from flaccid to systole.
export class Pressure {
  readonly element: HTMLElement
  private systole_mmhg = 120
  private readonly text = h('output', {})
  private readonly slider = h('input', {
    type: 'range',
    min: 0,
    max: 120,
    step: 1,
    value: 120,
    'aria-label': 'Pressure, mmHg',
    oninput: () => this.set(Number(this.slider.value)),
  })

  constructor(private readonly apply: (mmhg: number) => void) {
    this.element = h(
      'div',
      {},
      field('Pressure', this.slider),
      h(
        'p',
        { class: parts.row },
        button('Flaccid', () => this.set(0), { title: 'No pressure; the valve hangs open' }),
        button('Systole', () => this.set(this.systole_mmhg), { title: 'Systolic pressure, which closes the valve' }),
        this.text,
      ),
    )
  }

  begin({ systole_mmhg }: LiveValve): void {
    this.systole_mmhg = Math.round(systole_mmhg)
    this.slider.max = String(this.systole_mmhg)
    this.tell(this.systole_mmhg)
  }

  set(mmhg: number): void {
    this.apply(mmhg)
    this.tell(mmhg)
  }

  private tell(mmhg: number): void {
    this.slider.value = String(mmhg)
    this.text.textContent = withUnit(mmhg, 'mmHg', 0)
  }
}

/// What each hook pulls with, and how high its spot is above the annular plane.
export class HookPanel {
  readonly element: HTMLElement
  private readonly cells = Array.from({ length: HOOKS }, () => ({ force: h('td', {}), height: h('td', {}) }))

  constructor(canvas: LiveCanvas) {
    const pins = h('input', { type: 'checkbox', onchange: () => (canvas.hooks.pins = pins.checked) })
    const rows = this.cells.map(({ force, height }, hook) =>
      h(
        'tr',
        {},
        h('th', { scope: 'row' }, `Hook ${hook + 1}`),
        force,
        height,
        h(
          'td',
          {},
          button('Let go', () => canvas.hooks.release(hook), { 'aria-label': `Let go of hook ${hook + 1}` }),
        ),
      ),
    )
    this.element = h(
      'div',
      {},
      h(
        'table',
        { class: liveStyle.force, 'data-part': 'forces' },
        h(
          'tr',
          {},
          h('td', {}),
          h('th', { scope: 'col' }, 'Force'),
          h('th', { scope: 'col', title: 'of the grasped tissue above the annular plane' }, 'Height'),
          h('td', {}),
        ),
        ...rows,
      ),
      h('label', { class: parts.check }, pins, 'Keep hooks in place after release'),
      grabbers(canvas),
      lifts(canvas),
      h(
        'details',
        { class: parts.more },
        h('summary', {}, 'How to pull'),
        h(
          'ul',
          { class: parts.hint },
          h('li', {}, 'Press a leaflet or a chorda and drag; the wheel moves the hook along the viewing direction.'),
          h('li', {}, 'Or grab the middle of a free edge with the button of its segment, then lift it.'),
          h(
            'li',
            {},
            'Two hooks: use two fingers, or keep the first in place (P while dragging, Shift on release) and press again.',
          ),
          h(
            'li',
            {},
            'Keys: Enter grabs the centre of the picture, arrow keys move the hook, Page Up lifts it, Page Down lowers it, Escape releases it.',
          ),
          h('li', {}, 'The arrow shows the force on the tissue, at four millimetres per newton.'),
          h(
            'li',
            {},
            'After release under pressure, the valve beats once: it opens and closes again, as it would without a hook.',
          ),
        ),
      ),
    )
  }

  tell({ hooks }: Picture, { scene: { plane } }: LiveValve): void {
    for (const [hook, { force, height }] of this.cells.entries()) {
      const state = hooks[hook]
      force.textContent = state ? withUnit(state.force_n, 'N', 2) : '–'
      height.textContent = state ? `${number(dot(minus(state.spot_mm, plane.origin_mm), plane.normal))} mm` : '–'
    }
  }
}

/// A button for the free edge of each segment.
export function grabbers(canvas: LiveCanvas): HTMLElement {
  return h(
    'div',
    { class: liveStyle.segments, role: 'group', 'aria-label': 'Grab the middle of a free edge' },
    ...SEGMENTS.map((segment) => grabber(canvas, segment)),
  )
}

export function grabber(canvas: LiveCanvas, segment: Segment): HTMLButtonElement {
  const grab = (): void => {
    canvas.hooks.releaseAll()
    canvas.grabEdge(segment)
  }
  return button(segment, grab, { title: `Grab the free edge of ${segment}` })
}

/// For those who have no wheel or no pointer.
export function lifts({ hooks }: LiveCanvas): HTMLElement {
  return h(
    'p',
    { class: parts.row },
    button('Lift', () => hooks.lift(LIFT_MM), { title: `Move the grasped tissue ${LIFT_MM} mm towards the atrium` }),
    button('Lower', () => hooks.lift(-LIFT_MM), {
      title: `Move the grasped tissue ${LIFT_MM} mm towards the ventricle`,
    }),
    button('Let go', () => hooks.releaseAll()),
  )
}

/// What is drawn; `onChange` after each change.
export function lookControls(look: LiveLook, onChange: () => void): HTMLElement {
  const box = (label: string, key: 'strain' | 'prolapse' | 'plane'): HTMLElement => {
    const input = h('input', {
      type: 'checkbox',
      checked: look[key],
      onchange: () => {
        look[key] = input.checked
        onChange()
      },
    })
    return h('label', { class: parts.check }, input, label)
  }
  const cutting = h('input', { type: 'checkbox', onchange: () => cut() })
  const place = h('input', { type: 'range', min: -1, max: 1, step: 0.05, value: 0, oninput: () => cut(true) })
  const cut = (isMoved = false): void => {
    cutting.checked ||= isMoved
    look.cut = cutting.checked ? Number(place.value) : null
    onChange()
  }
  return h(
    'fieldset',
    { class: parts.panel, 'data-part': 'looks' },
    h('legend', {}, 'Show'),
    box('Strain of chordae in colour', 'strain'),
    box('Prolapse in colour', 'prolapse'),
    box('Annular plane', 'plane'),
    h('label', { class: parts.check }, cutting, 'Cut'),
    field('Position of the cut', place),
  )
}
