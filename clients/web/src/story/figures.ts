// Figures that a story's text may name, each from what is measured of the closure at hand.
import type { Closure, Plan, Scene } from '../api/types'
import { cm2, joined, percent, typeset, withError, withUnit } from '../format'
import { describe } from '../repair/steps'
import type { Readings } from '../state/readings'

/// What is shown while a text is read.
export interface Shown {
  valve: string // its name
  before: Scene
  after: Scene | null // of the plan
  plan: Plan
  readings: Readings
}

interface Figure {
  about: string // for who writes a story
  words(shown: Shown): string | null // null: not known yet
}

export const NOT_YET = '…' // a figure that is on its way

const last = ({ before, after }: Shown): Closure => (after ?? before).closure
const of =
  (words: (closure: Closure) => string | null): Figure['words'] =>
  (shown) =>
    words(last(shown))
const before =
  (words: (closure: Closure) => string | null): Figure['words'] =>
  (shown) =>
    words(shown.before.closure)
const leak = ({ leak: { area_mm2, error_mm2 } }: Closure): string => withError(area_mm2, error_mm2, 'mm²')
const why = ({ diagnosis }: Closure): string | null => (diagnosis ? typeset(diagnosis.sentence) : null)
const plain = (plan: Plan): string => joined(plan.steps.map((step) => lowered(describe(step))))
/// Within a sentence; names of devices and segments keep their capitals.
const lowered = (text: string): string => text.replace(/^[A-Z](?=[a-z])/, (letter) => letter.toLowerCase())
const read =
  (words: (readings: Readings) => string | null): Figure['words'] =>
  ({ readings }) =>
    words(readings)
const mm = (value: number | null): string | null => (value === null ? null : withUnit(value, 'mm'))

const FIGURES: Readonly<Record<string, Figure>> = {
  valve: { about: 'the name of the valve', words: ({ valve }) => valve },
  plan: { about: 'the steps of the plan', words: ({ plan }) => plain(plan) },
  leak: { about: 'the leak, with its numerical error', words: of(leak) },
  leak_before: { about: 'the leak before the repair', words: before(leak) },
  place: {
    about: 'the segments around the largest opening',
    words: of(({ leak: { openings } }) => joined((openings[0]?.segments ?? []).slice(0, 2)) || null),
  },
  width: {
    about: 'the width of the largest opening',
    words: of(({ leak: { openings } }) => mm(openings[0]?.width_mm ?? 0)),
  },
  why: { about: 'the diagnosis, as a sentence', words: of(why) },
  why_before: { about: 'the diagnosis before the repair', words: before(why) },
  prolapse: {
    about: 'how far the most prolapsed edge overrides the opposite one',
    words: before(({ diagnosis }) =>
      diagnosis ? withUnit(Math.max(...diagnosis.segments.map(({ override_mm }) => override_mm)), 'mm') : null,
    ),
  },
  tethering: {
    about: 'the probability that the leaflets are tethered',
    words: before(({ diagnosis }) => (diagnosis ? percent(diagnosis.tethering) : null)),
  },
  tenting_height: { about: 'the tenting height', words: of((c) => withUnit(c.tenting_height_mm, 'mm')) },
  tenting_area: { about: 'the tenting area', words: of((c) => withUnit(c.tenting_area_mm2, 'mm²', 0)) },
  coaptation: { about: 'the mean coaptation height', words: of((c) => withUnit(c.coaptation.height_mean_mm, 'mm')) },
  coaptation_before: {
    about: 'the mean coaptation height before the repair',
    words: before((c) => withUnit(c.coaptation.height_mean_mm, 'mm')),
  },
  annulus_ap: {
    about: 'the anteroposterior diameter of the annulus',
    words: of((c) => withUnit(c.annulus.ap_mm, 'mm')),
  },
  annulus_ap_before: {
    about: 'the anteroposterior diameter before the repair',
    words: before((c) => withUnit(c.annulus.ap_mm, 'mm')),
  },
  tension: { about: 'the highest chordal tension', words: of((c) => withUnit(c.tension_max_n, 'N', 2)) },
  opening: { about: 'the opening in diastole', words: read(({ opening }) => opening && cm2(opening.opening_area_mm2)) },
  gradient: {
    about: 'the mean gradient across the open valve',
    words: read(({ opening }) => opening && withUnit(opening.gradient_mmhg, 'mmHg')),
  },
  force: {
    about: 'the force at the hook (Live)',
    words: read(({ force_n }) => (force_n === null ? null : withUnit(force_n, 'N', 2))),
  },
  height: {
    about: 'the height of the grasped tissue above the annular plane (Live)',
    words: read(({ height_mm }) => mm(height_mm)),
  },
  margin: {
    about: 'the margin of the varied step (Repair)',
    words: read(({ tolerance }) => tolerance && (tolerance.margin ?? 'none')),
  },
  leak_off: {
    about: 'the largest leak with an error of 1 mm in the varied step (Repair)',
    words: read(({ tolerance }) => tolerance?.leak_off ?? null),
  },
}

/// Each with what it is, for who writes a story.
export const FIGURE_LIST = Object.entries(FIGURES).map(([name, { about }]) => [name, about] as const)
export const FIGURE_NAMES: readonly string[] = Object.keys(FIGURES)

/// Whether the text needs the valve in diastole.
export const isOpened = (text: string): boolean => /\{(opening|gradient)\}/.test(text)

/// The text with its figures; null: none is known yet.
export function told(text: string, shown: Shown | null): string {
  return text.replaceAll(/\{(\w+)\}/g, (_, name: string) => (shown && FIGURES[name]?.words(shown)) ?? NOT_YET)
}
