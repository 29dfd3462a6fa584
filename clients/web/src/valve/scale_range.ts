// From which value to which the colours run: over the valves that are shown, or the same for all valves.
import type { Scene } from '../api/types'
import { h } from '../dom'
import { store, stored } from '../state/stored'
import { scaleOf, type ColourMode, type Scale } from '../viewer/colours'
import parts from '../style/parts.module.css'
import valveStyle from './valve.module.css'

type Ranges = Partial<Record<ColourMode, [from: number, to: number]>>

const RANGES = 'coapt-colour-ranges'

export class ScaleRange {
  readonly element: HTMLElement
  onChange: () => void = () => {}
  private readonly from = this.bound('Colours from')
  private readonly to = this.bound('Colours to')
  private readonly unit = h('span', { class: parts.unit })
  private readonly same = h('input', { type: 'checkbox', onchange: () => this.fix(this.same.checked) })
  private mode: ColourMode = 'leaflets'

  constructor() {
    this.element = h(
      'div',
      { hidden: true },
      h(
        'div',
        { class: valveStyle.range, role: 'group', 'aria-label': 'Range of the colours' },
        h('span', {}, 'Range'),
        this.from,
        h('span', {}, 'to'),
        this.to,
        this.unit,
      ),
      h('label', { class: parts.check }, this.same, 'Same scale for all valves'),
    )
  }

  /// Null: the mode needs none.
  scale(mode: ColourMode, scenes: Scene[]): Scale | null {
    this.mode = mode
    const own = scaleOf(mode, scenes)
    this.element.hidden = own === null
    if (!own) return null
    const fixed = ranges()[mode]
    const scale = fixed ? { ...own, from: fixed[0], to: fixed[1] } : own
    this.same.checked = fixed !== undefined
    this.unit.textContent = scale.unit
    for (const [input, value] of [
      [this.from, scale.from],
      [this.to, scale.to],
    ] as const)
      if (document.activeElement !== input) input.value = String(Number(value.toPrecision(3)))
    return scale
  }

  /// A number that is typed holds for all valves; a range that runs backwards is not taken.
  private bound(label: string): HTMLInputElement {
    return h('input', { type: 'number', step: 'any', 'aria-label': label, onchange: () => this.fix(true) })
  }

  private fix(isFixed: boolean): void {
    const [from, to] = [this.from.valueAsNumber, this.to.valueAsNumber]
    const { [this.mode]: before, ...others } = ranges()
    const mine = from < to ? ([from, to] as const) : before
    store(RANGES, isFixed && mine ? { ...others, [this.mode]: mine } : others)
    this.onChange()
  }
}

function ranges(): Ranges {
  return stored<Ranges>(RANGES, {})
}
