// The controls of how a valve is shown: colour, names, the leak, the cut, its motion.
import type { Scene } from '../api/types'
import { field, h, select } from '../dom'
import { number, withUnit } from '../format'
import { labelledButton } from '../icons'
import { COLOUR_MODES, type ColourMode } from '../viewer/colours'
import type { Command } from '../view'
import type { ViewName } from '../viewer/stage'
import type { Look } from '../viewer/viewer'
import { Motion } from './motion'
import { ScaleRange } from './scale_range'
import parts from '../style/parts.module.css'
import valveStyle from './valve.module.css'

const VIEWS: readonly (readonly [ViewName, short: string, label: string])[] = [
  ['atrial', 'Atrium', 'From the atrium'],
  ['oblique', 'Oblique', 'Oblique'],
  ['anterior', 'Anterior', 'From anterior'],
  ['lateral', 'Lateral', 'From lateral'],
  ['ventricular', 'Ventricle', 'From the ventricle'],
]

export function viewButtons(onView: (view: ViewName) => void): HTMLElement {
  return h(
    'div',
    { class: valveStyle.views, role: 'group', 'aria-label': 'Direction of view' },
    ...VIEWS.map(([name, short, label]) =>
      labelledButton(name, short, label, () => onView(name), { class: parts.quiet }),
    ),
  )
}

export class Looks {
  readonly element: HTMLElement
  readonly views: HTMLElement
  onChange: () => void = () => {}
  onView: (view: ViewName) => void = () => {}
  private readonly colours: HTMLSelectElement
  private readonly names = h('input', { type: 'checkbox', checked: true, onchange: () => this.onChange() })
  private readonly hours = h('input', { type: 'checkbox', onchange: () => this.onChange() })
  private readonly leak = h('input', { type: 'checkbox', checked: true, onchange: () => this.onChange() })
  private readonly cutting = h('input', { type: 'checkbox', onchange: () => this.onChange() })
  private readonly cut = h('input', { type: 'range', min: 0, max: 36, value: 18, oninput: () => this.cutMoved() })
  private readonly cutText = h('output', {})
  readonly motion: Motion | null
  private readonly range = new ScaleRange()

  constructor(withMotion: boolean) {
    this.motion = withMotion ? new Motion() : null
    this.colours = select(COLOUR_MODES, 'leaflets', () => this.onChange())
    this.element = h(
      'fieldset',
      { class: `${parts.panel} ${valveStyle.looks}`, 'data-part': 'looks' },
      h('legend', {}, 'Show'),
      field('Colours', this.colours),
      this.range.element,
      field('Names', this.names),
      field('Clock', this.hours),
      field('Leak', this.leak),
      field('Cut', this.cutting),
      field('Position of the cut', this.cut),
      h('p', { class: parts.hint }, this.cutText),
      this.motion?.element,
    )
    this.range.onChange = () => this.onChange()
    if (this.motion) this.motion.onChange = () => this.onChange()
    this.views = viewButtons((view) => this.onView(view))
  }

  /// For these scenes, which share one scale of colours.
  look(scenes: Scene[]): Look {
    const mode = this.colours.value as ColourMode
    const cut = this.cutting.checked ? Number(this.cut.value) : null
    this.tellCut(scenes, cut)
    this.motion?.tell()
    return {
      mode,
      scale: this.range.scale(mode, scenes),
      share: this.motion?.share ?? 1,
      leak: this.leak.checked,
      names: this.names.checked,
      hours: this.hours.checked,
      cut,
    }
  }

  /// For who finds them by their names.
  settings(): Command[] {
    const setting = (name: string, run: () => void): Command => ({ group: 'Setting', name, run })
    const set = (change: () => void) => () => {
      change()
      this.onChange()
    }
    const switches = [
      ['names', this.names],
      ['the clock', this.hours],
      ['the leak', this.leak],
      ['the cut', this.cutting],
    ] as const
    return [
      ...VIEWS.map(([view, , label]) => setting(`View: ${label}`, () => this.onView(view))),
      ...COLOUR_MODES.map(([mode, label]) =>
        setting(
          `Colours: ${label}`,
          set(() => (this.colours.value = mode)),
        ),
      ),
      ...switches.map(([name, input]) =>
        setting(
          `${input.checked ? 'Hide' : 'Show'} ${name}`,
          set(() => (input.checked = !input.checked)),
        ),
      ),
    ]
  }

  /// What somebody else than the controls asks for.
  ask({ colours = 'leaflets', cut = false }: { colours?: ColourMode; cut?: boolean }): void {
    this.colours.value = colours
    this.cutting.checked = cut
    this.onChange()
  }

  private cutMoved(): void {
    this.cutting.checked = true
    this.onChange()
  }

  private tellCut(scenes: Scene[], cut: number | null): void {
    if (cut === null) {
      this.cutText.textContent = 'Move the slider to cut the valve across the line of coaptation.'
      return
    }
    const texts = scenes.map((scene) => {
      const section = scene.sections[cut]
      if (!section) return 'the closure has no sections'
      return section.contact
        ? `coaptation height ${withUnit(section.height_mm, 'mm')}`
        : `no contact, leaflets ${withUnit(section.distance_mm, 'mm')} apart`
    })
    const along = scenes[0]?.sections[cut]?.along
    this.cutText.textContent = `${number(along === undefined ? null : 100 * along, 0)} % of the way from the anterolateral commissure: ${texts.join('; repaired: ')}`
  }
}
