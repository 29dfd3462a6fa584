// What a person says against what an import decided: a control beside each decision that can be changed.
import type { ImportResult, LabelTaken } from '../api/types'
import { button, field, filePicker, h, select } from '../dom'
import { TINTS } from '../viewer/colours'
import { ACCEPTED } from './formats'
import { AXES, type FormValues, STATES, THICKNESSES, TISSUES, UNITS } from './import_form'
import { type LabelPart, type Role, ROLES } from './parts'
import valveStyle from './valve.module.css'

const PARTS: readonly (readonly [LabelPart, string])[] = [
  ['anterior', 'anterior leaflet (A1 to A3)'],
  ['posterior', 'posterior leaflet (P1 to P3)'],
  ['annulus', 'annulus'],
]

// What of a decision's words tells which field of a request changes it, where its subject does not.
const PHASE = /^phase (\d+) of (\d+)/
const MASKS = /masks taken as one label each/
const MIRROR = /mirror/
const TISSUE = /stress-free|unpressurised heart/
const HIDDEN = /hidden in coaptation/
const DRAWN = /synthesised/
const ANTERIOR_FILE = /^file (\d+) is the anterior leaflet/

export interface DecisionControl {
  subject: string
  about?: RegExp // of the decision's words
  element: HTMLElement
}

/// What the controls do; each makes the valve anew.
export interface Corrections {
  values: FormValues // as asked for now
  files: readonly { name: string; role: Role }[] // that the service sorted, in its order
  set(subject: string, values: Partial<FormValues>): void
  take(labels: LabelTaken[]): void
  role(file: number, role: Role): void // of `files`
  exchange: (() => void) | null // the two files of leaflets that a person named; null: there are none
  contour(file: File): void // in place of the annulus
  pick(): void // landmarks
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

/// Of files that the service sorted: the one that it took for the anterior leaflet, from 0; -1: none is named.
export function anteriorFile({ decisions }: Pick<ImportResult, 'decisions'>): number {
  for (const { subject, value } of decisions) {
    const found = subject === 'leaflets' && ANTERIOR_FILE.exec(value)
    if (found) return Number(found[1]) - 1
  }
  return -1
}

/// In the order in which they look for a decision of theirs.
export function decisionControls(result: ImportResult, change: Corrections): DecisionControl[] {
  const { values } = change
  const controls: DecisionControl[] = []
  const add = (subject: string, element: HTMLElement, about?: RegExp): void => {
    controls.push(about ? { subject, element, about } : { subject, element })
  }
  const choice = (
    subject: string,
    label: string,
    key: keyof FormValues,
    options: readonly (readonly [string, string])[],
    value = String(values[key]),
  ): HTMLElement =>
    field(
      label,
      select(options, value, (chosen) => change.set(subject, { [key]: chosen })),
    )
  const number = (subject: string, label: string, key: keyof FormValues, limits: Record<string, string | number>) => {
    const input = h('input', { type: 'number', value: String(values[key]), ...limits })
    input.addEventListener('change', () => input.checkValidity() && change.set(subject, { [key]: input.value }))
    return field(label, input)
  }

  for (const [i, { name, role }] of change.files.entries()) {
    const roles = select(ROLES, role, (chosen) => change.role(i, chosen as Role))
    roles.setAttribute('aria-label', `What ${name} is`)
    add('files', roles, new RegExp(`^file ${i + 1} of `))
  }
  for (const { subject, value } of result.decisions) {
    const phase = subject === 'labels' && PHASE.exec(value)
    if (phase)
      add('labels', number('labels', 'Phase', 'phase', { min: 1, max: phase[2] ?? '', value: phase[1] ?? '' }), PHASE)
    else if (subject === 'labels' && MASKS.test(value))
      add('labels', number('labels', 'They are phases; use phase', 'phase', { min: 1, max: 1000 }), MASKS)
  }
  add('axes', choice('axes', 'Axes', 'axes', AXES))
  for (const subject of ['units', 'size']) add(subject, choice(subject, 'Lengths are in', 'units', UNITS, result.unit))
  const isMirrored = values.mirrored === true
  add(
    'frame',
    button(isMirrored ? 'The files are not a mirror image' : 'The files are a mirror image', () =>
      change.set('frame', { mirrored: !isMirrored }),
    ),
    MIRROR,
  )
  const isFlipped = values.flips === true
  add(
    'atrium',
    button(isFlipped ? 'Back to the detected side' : 'The atrium is on the other side', () =>
      change.set('atrium', { flips: !isFlipped }),
    ),
  )
  const anterior = anteriorFile(result)
  if (result.labels.length > 0) add('leaflets', labelChoice(result.labels, 'not used', change.take))
  else if (change.exchange) add('leaflets', button('Exchange the leaflets', change.exchange))
  else if (change.files[anterior])
    add(
      'leaflets',
      button('Exchange the leaflets', () => change.role(anterior, 'posterior')),
    )
  for (const subject of ['annulus', 'contour'])
    add(
      subject,
      filePicker(`Contour of the annulus, ${subject}`, 'Use another contour', {
        accept: ACCEPTED,
        use: ([file]) => file && change.contour(file),
      }),
    )
  add('state', choice('state', 'Leaflets in the files are', 'tissue', TISSUES), TISSUE)
  add(
    'state',
    number('state', 'Height hidden by coaptation, mm', 'hidden_mm', { min: 0, max: 15, step: 'any' }),
    HIDDEN,
  )
  add('state', choice('state', 'Leaflets were imaged', 'closed', STATES, result.closed ? 'closed' : 'open'))
  add('mesh', number('mesh', 'Triangles', 'triangles', { min: 100, max: 100000 }))
  for (const subject of ['landmarks', 'commissures']) add(subject, button('Pick landmarks', change.pick))
  add('thickness', choice('thickness', 'Tissue thickness', 'thickness', THICKNESSES))
  if (values.draws === true) add('chordae', number('chordae', 'Seed', 'seed', { min: 0, max: 2147483647 }), DRAWN)
  return controls
}

/// The first that changes what a decision says; it is taken out of those that are left.
export function takeControl(
  { subject, value }: { subject: string; value: string },
  left: DecisionControl[],
): DecisionControl | undefined {
  const at = left.findIndex((control) => control.subject === subject && (control.about?.test(value) ?? true))
  return at < 0 ? undefined : left.splice(at, 1)[0]
}
