// The controls of how a valve is shown: colour, names, orifices, the cut, the closing.
import type { Scene } from '../api/types'
import { button, field, h, select } from '../dom'
import { number, withUnit } from '../format'
import { COLOUR_MODES, scaleOf, type ColourMode } from '../viewer/colours'
import type { ViewName } from '../viewer/stage'
import type { Look } from '../viewer/viewer'

const VIEWS: readonly (readonly [ViewName, string])[] = [
  ['atrial', 'From the atrium'],
  ['oblique', 'Oblique'],
  ['anterior', 'From anterior'],
  ['lateral', 'From lateral'],
  ['ventricular', 'From the ventricle'],
]
const CLOSING_MS = 1800

export class Looks {
  readonly element: HTMLElement
  readonly views: HTMLElement
  onChange: () => void = () => {}
  onView: (view: ViewName) => void = () => {}
  private mode: ColourMode = 'leaflets'
  private readonly names = h('input', { type: 'checkbox', checked: true, onchange: () => this.onChange() })
  private readonly orifices = h('input', { type: 'checkbox', checked: true, onchange: () => this.onChange() })
  private readonly cutting = h('input', { type: 'checkbox', onchange: () => this.onChange() })
  private readonly cut = h('input', { type: 'range', min: 0, max: 36, value: 18, oninput: () => this.cutMoved() })
  private readonly cutText = h('output', {})
  private readonly closing = h('input', { type: 'range', min: 0, max: 1, step: 0.005, value: 1, oninput: () => this.onChange() })
  private readonly play: HTMLButtonElement
  private started = 0 // of the closing that plays; 0: none

  constructor(withMotion: boolean) {
    this.play = button('Play the closing', () => this.playOrStop())
    const mode = select(COLOUR_MODES, 'leaflets', (value) => {
      this.mode = value as ColourMode
      this.onChange()
    })
    this.element = h(
      'fieldset',
      { class: 'panel looks' },
      h('legend', {}, 'Show'),
      field('Colours', mode),
      field('Names', this.names),
      field('Orifices', this.orifices),
      field('Cut', this.cutting),
      field('Place of the cut', this.cut),
      h('p', { class: 'hint cut' }, this.cutText),
      withMotion && field('Open to closed', this.closing),
      withMotion && h('p', { class: 'row' }, this.play, h('span', { class: 'hint' }, 'its way, not its time')),
    )
    this.views = h('div', { class: 'row views', role: 'group', 'aria-label': 'Direction of view' })
    for (const [name, label] of VIEWS) this.views.append(button(label, () => this.onView(name), { class: 'quiet' }))
  }

  /// For these scenes, which share one scale of colours.
  look(scenes: Scene[]): Look {
    const cut = this.cutting.checked ? Number(this.cut.value) : null
    this.tellCut(scenes, cut)
    return {
      mode: this.mode,
      scale: scaleOf(this.mode, scenes),
      share: Number(this.closing.value),
      orifices: this.orifices.checked,
      names: this.names.checked,
      cut,
    }
  }

  private cutMoved(): void {
    this.cutting.checked = true
    this.onChange()
  }

  private tellCut(scenes: Scene[], cut: number | null): void {
    if (cut === null) {
      this.cutText.textContent = 'Move it to cut the valve across the line of coaptation.'
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

  private playOrStop(): void {
    if (this.started !== 0) return this.stop()
    this.started = performance.now()
    this.play.textContent = 'Stop'
    const step = (now: number): void => {
      if (this.started === 0) return
      const share = Math.min((now - this.started) / CLOSING_MS, 1)
      this.closing.value = String(share)
      this.onChange()
      if (share < 1) requestAnimationFrame(step)
      else this.stop()
    }
    requestAnimationFrame(step)
  }

  private stop(): void {
    this.started = 0
    this.play.textContent = 'Play the closing'
  }
}
