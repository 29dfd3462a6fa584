// What a person says against what an import decided: a control beside each decision that can be changed.
import type { ImportResult, LabelTaken } from '../api/types'
import { button, field, h, select } from '../dom'
import { TINTS } from '../viewer/colours'
import type { LabelPart, Unit } from './parts'
import valveStyle from './valve.module.css'

export const UNITS: readonly (readonly [Unit, string])[] = [
  ['mm', 'mm'],
  ['cm', 'cm'],
  ['in', 'in'],
  ['m', 'm'],
]
const PARTS: readonly (readonly [LabelPart, string])[] = [
  ['anterior', 'anterior leaflet (A1 to A3)'],
  ['posterior', 'posterior leaflet (P1 to P3)'],
  ['annulus', 'annulus'],
]

/// What the controls do; each makes the valve anew.
export interface Corrections {
  take(labels: LabelTaken[]): void
  exchange: (() => void) | null // the two files of leaflets; null: there are not two
  units(unit: Unit): void
  closed(closed: boolean): void
  flip(): void
  mirror(): void
  flipped: boolean // as asked for now
  mirrored: boolean
}

/// A control for each label. `none`: what a label without a part is called.
export function labelChoice(labels: LabelTaken[], none: string, take: (labels: LabelTaken[]) => void): HTMLElement {
  return h(
    'div',
    { 'data-part': 'labels-taken' },
    ...labels.map(({ number, part }) => {
      const swatch = h('span', { class: valveStyle.swatch, 'aria-hidden': 'true' })
      if (part === 'anterior' || part === 'posterior') swatch.style.background = TINTS[part]
      const choice = select([['', none], ...PARTS], part ?? '', (value) =>
        take(given(labels, number, value === '' ? null : (value as LabelPart))),
      )
      choice.setAttribute('aria-label', `What label ${number} is`)
      return h('p', { class: valveStyle.label }, swatch, h('span', {}, `label ${number}`), choice)
    }),
  )
}

/// The labels with `number` as `part`; the one label that was that takes its part in exchange.
export function given(labels: LabelTaken[], number: number, part: LabelPart | null): LabelTaken[] {
  const before = labels.find((label) => label.number === number)?.part ?? null
  const holders = labels.filter((label) => label.part === part)
  return labels.map((label) => {
    if (label.number === number) return { number, part }
    const exchanged = part !== null && before !== null && holders.length === 1 && label === holders[0]
    return exchanged ? { number: label.number, part: before } : label
  })
}

/// By the subject of the decision that each changes.
export function decisionControls(result: ImportResult, change: Corrections): Map<string, HTMLElement> {
  const controls = new Map<string, HTMLElement>()
  if (result.labels.length > 0) controls.set('leaflets', labelChoice(result.labels, 'not used', change.take))
  else if (change.exchange) controls.set('leaflets', button('Exchange the leaflets', change.exchange))
  controls.set(
    'units',
    field(
      'Lengths are',
      select(UNITS, result.unit, (unit) => change.units(unit as Unit)),
    ),
  )
  controls.set(
    'atrium',
    button(change.flipped ? 'Back to the detected side' : 'The atrium is on the other side', change.flip),
  )
  controls.set(
    'frame',
    button(change.mirrored ? 'The files are not a mirror image' : 'The files are a mirror image', change.mirror),
  )
  const states = [
    ['open', 'open'],
    ['closed', 'closed'],
  ] as const
  const state = select(states, result.closed ? 'closed' : 'open', (value) => change.closed(value === 'closed'))
  controls.set('state', field('Leaflets were imaged', state))
  return controls
}
