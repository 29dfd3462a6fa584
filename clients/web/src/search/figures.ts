// The figures of a ranked plan that matter, and which of two plans has the better one.
import type { Estimate, LeakMap, RankedPlan } from '../api/types'
import { intervalWords, leakEstimate, leakInFull, type Interval } from '../estimate'
import { counted, number, withUnit } from '../format'
import { rankedCost } from './price'

// One closure of one plan is not known better than this (docs/researcher/accuracy.md, "Other equilibria").
const CLOSURE_MM2 = 0.5
const FARTHEST = { suture_length_mm: 1, angle_deg: 5 } // borders of the region of interest
export const FURTHEST_DISEASE_MM = 12 // of the courses that durability is of

export interface Figure {
  label: string
  unit: string
  digits: number
  value(plan: RankedPlan): number | null
  better: 'lower' | 'higher'
  border?: number // a value there may be larger
  /// Differences up to this say nothing; `why` tells what it is.
  blur?: { of(a: RankedPlan, b: RankedPlan): number; why: string }
}

const oneClosure = { of: () => CLOSURE_MM2, why: `below the ${CLOSURE_MM2} mm² accuracy of one closure` }
const spread = {
  of: (a: RankedPlan, b: RankedPlan) => Math.max(a.leak_mm2.sd ?? 0, b.leak_mm2.sd ?? 0),
  why: 'within the spread due to errors of execution',
}

export const FIGURES: Figure[] = [
  {
    label: 'Leak with errors of execution, mean',
    unit: 'mm²',
    digits: 2,
    value: (p) => p.leak_mm2.mean,
    better: 'lower',
    blur: spread,
  },
  {
    label: 'Leak with errors of execution, 95th percentile',
    unit: 'mm²',
    digits: 1,
    value: (p) => leakOf(p).execution?.[1] ?? null,
    better: 'lower',
    blur: oneClosure,
  },
  {
    label: 'Leak with errors of execution, worst',
    unit: 'mm²',
    digits: 1,
    value: (p) => p.leak_mm2.worst,
    better: 'lower',
    blur: oneClosure,
  },
  {
    label: 'Leak as planned',
    unit: 'mm²',
    digits: 1,
    value: (p) => p.measure.leak_mm2,
    better: 'lower',
    blur: oneClosure,
  },
  {
    label: 'Margin to leak, length',
    unit: 'mm',
    digits: 2,
    value: (p) => p.margin_to_leak.suture_length_mm,
    better: 'higher',
    border: FARTHEST.suture_length_mm,
  },
  {
    label: 'Margin to leak, angle',
    unit: '°',
    digits: 1,
    value: (p) => p.margin_to_leak.angle_deg,
    better: 'higher',
    border: FARTHEST.angle_deg,
  },
  {
    label: 'Coaptation height, mean',
    unit: 'mm',
    digits: 1,
    value: (p) => p.measure.coaptation.height_mean_mm,
    better: 'higher',
  },
  {
    label: 'Coaptation height, minimum',
    unit: 'mm',
    digits: 1,
    value: (p) => p.measure.coaptation.height_min_mm,
    better: 'higher',
  },
  { label: 'Highest chordal tension', unit: 'N', digits: 2, value: (p) => p.measure.tension_max_n, better: 'lower' },
  {
    label: 'Largest papillary relocation',
    unit: 'mm',
    digits: 1,
    value: (p) => Math.max(p.anterolateral_movement_mm, p.posteromedial_movement_mm),
    better: 'lower',
  },
  {
    label: 'Opening in diastole',
    unit: 'cm²',
    digits: 1,
    value: (p) => {
      const opening = openingMm2(p)
      return opening === null ? null : opening / 100
    },
    better: 'higher',
  },
  { label: 'Mean gradient at rest', unit: 'mmHg', digits: 1, value: (p) => p.gradient_mmhg ?? null, better: 'lower' },
  {
    label: 'Reserve against progression',
    unit: 'mm',
    digits: 1,
    value: (p) => p.durability_mm ?? null,
    better: 'higher',
    border: FURTHEST_DISEASE_MM,
  },
  { label: 'Ring sizes below the true size', unit: '', digits: 1, value: (p) => p.ring_sizes_below, better: 'lower' },
  { label: 'Steps', unit: '', digits: 0, value: (p) => p.plan.steps.length, better: 'lower' },
  { label: 'Cost', unit: 'mm²', digits: 2, value: rankedCost, better: 'lower' },
]

export function shownFigure(figure: Figure, plan: RankedPlan): string {
  const value = figure.value(plan)
  const open = value !== null && figure.border !== undefined && value >= figure.border
  return `${open ? '≥ ' : ''}${withDegrees(value, figure.unit, figure.digits).trim()}`
}

/// A degree stands at its number.
function withDegrees(value: number | null, unit: string, digits: number): string {
  return withUnit(value, unit, digits).replace(' °', '°')
}

export type Verdict = 'first' | 'second' | 'same' | 'within' | 'unknown'

/// Equal as shown is the same.
export function judge(figure: Figure, a: RankedPlan, b: RankedPlan): Verdict {
  const [first, second] = [figure.value(a), figure.value(b)]
  if (first === null || second === null || !Number.isFinite(first) || !Number.isFinite(second)) return 'unknown'
  if (number(first, figure.digits) === number(second, figure.digits)) return 'same'
  if (figure.blur && Math.abs(first - second) <= figure.blur.of(a, b)) return 'within'
  return first < second === (figure.better === 'lower') ? 'first' : 'second'
}

/// The leak as planned, then from 5 to 95 % by each cause.
export function leakFigures(plan: RankedPlan): [label: string, value: string][] {
  const leak = leakOf(plan)
  const range = (interval: Interval | null): string => (interval ? `${intervalWords(interval)} mm²` : number(null))
  return [
    ['Leak as planned', leakInFull(leak)],
    [LEAK_BY_EXECUTION, range(leak.execution)],
    ['Leak with tissue error, 5 to 95\u00a0%', range(leak.tissue)],
    ['Leak with numerical error, 5 to 95\u00a0%', range(leak.numerical)],
  ]
}
export const LEAK_BY_EXECUTION = 'Leak with errors of execution, 5 to 95\u00a0%'

/// What is known of the leak as planned.
export function leakOf({ leak, measure }: RankedPlan): Estimate {
  return leakEstimate({ leak_mm2: measure.leak_mm2, leak: leak ?? measure.leak })
}

/// "suture more than 1.00 mm, angle more than 5.0°".
export function marginWords(plan: RankedPlan): string {
  const { suture_length_mm, angle_deg, why_unknown } = plan.margin_to_leak
  const part = (value: number | null, farthest: number, unit: string, digits: number) =>
    `${value !== null && value >= farthest ? 'more than ' : ''}${withDegrees(value, unit, digits)}`
  if (suture_length_mm === null && angle_deg === null) return `unknown (${why_unknown ?? 'too few region points'})`
  const why = why_unknown ? ` (${why_unknown})` : ''
  return `${lengthName(plan)} ${part(suture_length_mm, FARTHEST.suture_length_mm, 'mm', 2)}, angle ${part(angle_deg, FARTHEST.angle_deg, '°', 1)}${why}`
}

/// What the errors of length are of: of a suture, or where there is none of the distance that holds the muscle.
export function lengthName(plan: RankedPlan, muscle: LeakMap['muscle'] = 'both'): string {
  const sutured = plan.plan.steps.flatMap((step) => (step.step === 'papillary_approximation' ? [step.side] : []))
  if (muscle !== 'both') return sutured.includes(muscle) ? 'suture' : TIP_TO_TRIGONE
  const muscles = new Set(sutured).size
  return muscles === 0 ? TIP_TO_TRIGONE : muscles === 1 ? `suture or ${TIP_TO_TRIGONE}` : 'suture'
}
const TIP_TO_TRIGONE = 'tip to trigone distance'

export type Opened = Partial<Pick<RankedPlan, 'opening_area_mm2'>>

/// In diastole; null: it was not opened, or did not come to rest.
export function openingMm2({ opening_area_mm2 }: Opened): number | null {
  return opening_area_mm2 ?? null
}

/// Leaves at most a mild leak, as likely as it must, and breaks no rule.
export const isAcceptable = (plan: RankedPlan): boolean => plan.closes_robustly

/// "annuloplasty: generic-classic ring, size 30 mm; ..."
export function inWords(plan: { description: string[] }): string {
  return plan.description.length > 0 ? plan.description.join('; ') : 'no repair'
}

/// What is not to be relied on.
export function doubts(plan: RankedPlan): string[] {
  const found: string[] = []
  if (plan.status !== 'converged') found.push(`The closure did not converge (${plan.status.replace('_', ' ')}).`)
  if (plan.crossing) found.push('The leaflets cross.')
  if (plan.region_failures > 0)
    found.push(
      `${plan.region_failures} of ${counted(plan.region_closures, 'closure')} with errors of execution failed and ${plan.region_failures === 1 ? 'is' : 'are'} excluded.`,
    )
  if (plan.region_closures < 2)
    found.push('The plan was not closed with errors of execution, so mean, sd and margin are unknown.')
  return found
}

/// What `a`, ranked first, and `b` are to each other; null: nothing is said of the two.
export function tieWords(a: RankedPlan, b: RankedPlan, all: RankedPlan[]): string | null {
  const between = all.filter((plan) => plan.rank >= a.rank && plan.rank < b.rank)
  if (between.length === 0) return null
  if (between.every((plan) => plan.tie_with_next)) return `Plans ${a.rank} and ${b.rank} are equivalent.`
  const ahead = between.length === 1 ? a.probability_outranks_next : null
  return ahead === null
    ? null
    : `Plan ${a.rank} is better than plan ${b.rank} with a probability of ${number(100 * ahead, 0)} %.`
}
