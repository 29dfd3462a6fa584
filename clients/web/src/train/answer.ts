// What a learner answers with: how sure, and each segment's mobility.
import { field, h } from '../dom'
import { percent } from '../format'
import parts from '../style/parts.module.css'
import { panel } from './frame'
import trainStyle from './train.module.css'
import { MOBILITIES, type Mobility, type SegmentName, SEGMENTS } from './types'

/// From a guess to certainty, in hundredths.
export class Confidence {
  readonly element: HTMLElement
  private readonly words = h('output', {})
  private readonly slider: HTMLInputElement

  constructor(private readonly chance: number) {
    const least = Math.round(100 * chance)
    this.slider = h('input', {
      type: 'range',
      min: least,
      max: 100,
      step: 1,
      value: least,
      oninput: () => this.tell(),
    })
    this.element = h(
      'div',
      { 'data-part': 'confidence' },
      field('How sure?', this.slider),
      h('p', { class: parts.hint }, this.words),
    )
    this.tell()
  }

  get share(): number {
    return Math.max(Number(this.slider.value) / 100, this.chance)
  }

  private tell(): void {
    const { share, chance } = this
    const extreme = share <= chance + 0.005 ? ': a guess' : share === 1 ? ': certain' : ''
    const words = `${percent(share)} likely to be right${extreme}`
    this.words.textContent = words
    this.slider.setAttribute('aria-valuetext', words)
  }
}

/// Eight segments, three kinds.
export class SegmentTable {
  readonly element: HTMLElement
  onChange: () => void = () => {}
  private readonly chosen = new Map<SegmentName, Mobility>()

  /// `heading`: of a segment's row.
  constructor(heading: (segment: SegmentName) => HTMLElement) {
    const radio = (segment: SegmentName, mobility: Mobility): HTMLElement =>
      h('input', {
        type: 'radio',
        name: `mobility-${segment}`,
        'aria-label': `${segment} ${mobility}`,
        onchange: () => {
          this.chosen.set(segment, mobility)
          this.onChange()
        },
      })
    this.element = panel(
      'Segments',
      h(
        'table',
        { class: trainStyle.judged, 'data-part': 'segments' },
        h('tr', {}, h('td', {}), ...MOBILITIES.map((mobility) => h('th', { scope: 'col' }, mobility))),
        ...SEGMENTS.map((segment) =>
          h(
            'tr',
            {},
            h('th', { scope: 'row', 'aria-label': segment }, heading(segment)),
            ...MOBILITIES.map((mobility) => h('td', {}, h('label', {}, radio(segment, mobility)))),
          ),
        ),
      ),
    )
  }

  /// In the order of SEGMENTS; null while one is missing.
  get answer(): Mobility[] | null {
    const all = SEGMENTS.flatMap((segment) => this.chosen.get(segment) ?? [])
    return all.length === SEGMENTS.length ? all : null
  }
}
