// What a search may be told, by where it stands in the request (io/schema/search.schema.json), and the request made of it.
import type { Plan, Problem } from '../api/types'

export interface NumberOption {
  pointer: string // into the search
  label: string
  unit?: string
  least: number
  most: number
  step: number // 1: an integer
  fallback: number | null // null: no limit, which is an empty field
  hint?: string
}

const INTEGER = 1

export const ANSWER: NumberOption[] = [
  {
    pointer: '/seconds',
    label: 'Time limit',
    unit: 's',
    least: 0,
    most: 1_000_000,
    step: 0.1,
    fallback: null,
    hint: '60 % of the time is used for searching and 40 % for checking the plans found.',
  },
  { pointer: '/plans', label: 'Plans to show', least: 1, most: 50, step: INTEGER, fallback: 5 },
]

export const NEOCHORDAE: NumberOption = {
  pointer: '/rules/most_neochordae',
  label: 'Maximum number of neochordae',
  least: 0,
  most: 4,
  step: INTEGER,
  fallback: 4,
}

export const LIMITS: NumberOption[] = [
  {
    pointer: '/rules/most_movement_mm',
    label: 'Maximum papillary relocation',
    unit: 'mm',
    least: 3,
    most: 15,
    step: 0.5,
    fallback: 10,
    hint: 'More than 10 mm is unusual.',
  },
  {
    pointer: '/rules/suture_lattice_mm',
    label: 'Suture lengths in steps of',
    unit: 'mm',
    least: 0.1,
    most: 5,
    step: 0.1,
    fallback: 0.5,
  },
  {
    pointer: '/rules/neochorda_lattice_mm',
    label: 'Neochorda lengths in steps of',
    unit: 'mm',
    least: 0.5,
    most: 5,
    step: 0.1,
    fallback: 2,
  },
]

export const OPTIMISER: NumberOption[] = [
  {
    pointer: '/evaluations',
    label: 'Closures',
    least: 1,
    most: 1_000_000,
    step: INTEGER,
    fallback: 2000,
    hint: 'For the search itself; ranking needs more.',
  },
  {
    pointer: '/region_points',
    label: 'Region points',
    least: 1,
    most: 1089,
    step: INTEGER,
    fallback: 1089,
    hint: 'Errors of execution, of 1,089, with which the first plan is closed; others: at most 65.',
  },
  {
    pointer: '/fine_levels',
    label: 'Mesh refined',
    unit: 'times',
    least: 0,
    most: 2,
    step: INTEGER,
    fallback: 1,
    hint: 'For the final check, each ranked plan is closed once more, as planned, on a finer mesh.',
  },
  {
    pointer: '/model_draws',
    label: 'Tissue variants',
    least: 0,
    most: 200,
    step: INTEGER,
    fallback: 8,
    hint: 'Tissue and chordae vary within the ranges of their sources; they enter the probability that a plan leaks less than 5 mm².',
  },
  {
    pointer: '/seed',
    label: 'Seed',
    least: 0,
    most: Number.MAX_SAFE_INTEGER,
    step: INTEGER,
    fallback: 1,
    hint: 'The same seed gives the same plans.',
  },
  {
    pointer: '/no_improvement',
    label: 'No better plan for',
    unit: 'closures',
    least: 0,
    most: 1_000_000,
    step: INTEGER,
    fallback: null,
    hint: 'The search then stops early.',
  },
  {
    pointer: '/target_mm2',
    label: 'Good enough at',
    unit: 'mm²',
    least: 0,
    most: 1_000_000,
    step: 0.1,
    fallback: null,
    hint: 'The search stops once a plan has this leak (mean + sd) or less.',
  },
]

const MOST_WEIGHT = 1_000_000
const weight = (name: string, label: string, fallback: number): NumberOption => ({
  pointer: `/weights/${name}`,
  label,
  least: 0,
  most: MOST_WEIGHT,
  step: 0.1,
  fallback,
})

export const WEIGHTS: NumberOption[] = [
  weight('leak', 'Leak, per mm² of mean + weighted sd', 1),
  weight('sd_share', 'Weight of the sd in that sum', 1),
  weight('incompetence', 'Leak above 1 mm², extra per mm²', 5),
  weight('margin', 'No margin to leak', 1),
  weight('coaptation', 'Coaptation below 8 mm, per mm', 0.5),
  weight('gap', 'Distance between leaflets, per mm', 2),
  weight('movement', 'Papillary relocation, per mm', 0.2),
  weight('movement_above_10', 'Relocation above 10 mm, extra per mm', 1),
  weight('undersizing', 'Undersizing, per ring size', 0.5),
  weight('undersizing_above_4', 'Above 4 sizes, extra per size', 2),
  weight('gradient_above_3', 'Mean gradient above 3 mmHg, per mmHg', 2),
  weight('gradient_above_5', 'Above 5 mmHg, extra per mmHg', 10),
  weight('durability', 'Reserve against progression below 12 mm, per mm', 0.25),
  weight('step', 'Each step of the operation', 1),
  weight('tension', 'Increase of chordal tension, per N', 1),
  weight('untrusted', 'Fraction of failed closures', 10_000),
]

export interface Switch {
  pointer: string
  label: string
  fallback: boolean
  hint?: string
}

export const EVIDENCE: Switch = {
  pointer: '/evidence',
  label: 'Evidence',
  fallback: true,
  hint: 'Also close ranked plans with errors of single sutures and with further remodelling.',
}

export const STEPS_ON_REQUEST: Switch[] = [
  { pointer: '/rules/own_ring', label: 'Rings in the shape of the annulus', fallback: false },
  { pointer: '/rules/chordal_length_change', label: 'Shorten chordae', fallback: false },
  { pointer: '/rules/chordal_excision', label: 'Cut strut chordae', fallback: false },
  { pointer: '/rules/chordal_transfer', label: 'Transfer chordae', fallback: false },
  { pointer: '/rules/leaflet_resection', label: 'Resect the posterior leaflet', fallback: false },
  { pointer: '/rules/edge_to_edge', label: 'Edge-to-edge repair', fallback: false },
]

const SUTURE = 'papillary_approximation'

/// Which muscles may be sutured, each with what the rules forbid for it.
export const SUTURES = [
  { name: 'both', label: 'both muscles', forbidden: [] },
  { name: 'anterolateral', label: 'anterolateral muscle only', forbidden: [`${SUTURE}:posteromedial`] },
  { name: 'posteromedial', label: 'posteromedial muscle only', forbidden: [`${SUTURE}:anterolateral`] },
  { name: 'none', label: 'none', forbidden: [SUTURE] },
] as const

/// What can be forbidden: a word of the rules and what it means.
export interface Kind {
  word: string
  label: string
  hint?: string
  title?: string
}

export function ringKinds(rings: { name: string; note: string }[]): Kind[] {
  return [
    { word: 'annuloplasty:own', label: 'the shape of the annulus' },
    ...rings.map(({ name, note }) => ({
      word: `annuloplasty:${name}`,
      label: name,
      hint: note.split(/;|, as /)[0] ?? '',
      title: note,
    })),
  ]
}

export const ANCHORS: Kind[] = [
  { word: `${SUTURE}:ipsilateral_trigone`, label: 'trigone' },
  { word: `${SUTURE}:saddle_peak`, label: 'saddle peak' },
  { word: `${SUTURE}:annulus_point`, label: 'any point of the annulus' },
]

export const LEAFLETS: Kind[] = [
  { word: 'neochorda:anterior', label: 'anterior leaflet' },
  { word: 'neochorda:posterior', label: 'posterior leaflet' },
]

export interface Choices {
  numbers: Map<NumberOption, number | null> // null: left empty
  switches: Map<Switch, boolean>
  forbidden: string[]
  fixed: Plan | null
}

/// What differs from the defaults, as POST /v1/plans takes it.
export function searchOf(choices: Choices): Record<string, unknown> {
  const search: Record<string, unknown> = {}
  for (const [option, value] of choices.numbers)
    if (value !== null && value !== option.fallback) put(search, option.pointer, value)
  for (const [option, value] of choices.switches) if (value !== option.fallback) put(search, option.pointer, value)
  if (choices.forbidden.length > 0) put(search, '/rules/forbidden', choices.forbidden)
  if (choices.fixed) put(search, '/rules/fixed', choices.fixed)
  return search
}

function put(search: Record<string, unknown>, pointer: string, value: unknown): void {
  const names = pointer.slice(1).split('/')
  const last = names.pop() as string
  let place = search
  for (const name of names) {
    place[name] ??= {}
    place = place[name] as Record<string, unknown>
  }
  place[last] = value
}

/// The problem's option among these pointers into the search; null: the search as a whole.
export function placeOf(problem: Problem, pointers: string[]): string | null {
  return pointers.find((pointer) => `${problem.path}/`.startsWith(`/search${pointer}/`)) ?? null
}
