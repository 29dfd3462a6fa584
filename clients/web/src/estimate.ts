// A number with what is known of how far it may be off, apart by cause, and what is said of it by the widest part: the rules and
// words of core/metrics/estimate.h and estimate_text.h.
import type { Estimate, Leak } from './api/types'
import { knownTenths, number, withError } from './format'

export type Interval = NonNullable<Estimate['tissue']> // from 5 to 95 %
type Cause = 'numerical' | 'tissue' | 'execution'

const WORDS: Readonly<Record<Cause, string>> = {
  numerical: 'numerical error',
  tissue: 'tissue error',
  execution: 'errors of execution',
}

/// As it is measured of a closure, or stated of a plan; `tissue` of draws made since. Results of earlier releases state no interval, or the
/// area alone.
export function leakEstimate(
  { leak_mm2, leak }: { leak_mm2: number | null; leak?: Partial<Leak> },
  tissue: Interval | null = null,
): Estimate {
  const value = leak?.area_mm2 ?? leak_mm2
  return {
    value,
    numerical: leak?.numerical ?? areaInterval(value, leak?.error_mm2),
    tissue: tissue ?? leak?.tissue ?? null,
    execution: leak?.execution ?? null,
  }
}

function areaInterval(area: number | null, error: number | null | undefined): Interval | null {
  return area === null || error === null || error === undefined ? null : [Math.max(0, area - error), area + error]
}

/// The tissue's interval and that of the computation (or the value) have no value in common: observations contradict the tissue of the file.
export function tissueExcludesValue({ value, numerical, tissue }: Estimate): boolean {
  if (!tissue || value === null) return false
  const [low, high] = numerical ?? [value, value]
  return high < tissue[0] || low > tissue[1]
}

/// The cause of the widest known interval, the first of equal ones, but the tissue where it excludes the value.
export function widest(estimate: Estimate): Cause | null {
  if (tissueExcludesValue(estimate)) return 'tissue'
  let cause: Cause | null = null
  let width = -1
  for (const of of ['numerical', 'tissue', 'execution'] as const) {
    const part = estimate[of]
    if (!part || part[1] - part[0] <= width) continue
    width = part[1] - part[0]
    cause = of
  }
  return cause
}

export interface EstimateWords {
  value: string
  interval: string // empty where `value` says all
  cause: string
}

/// "46", "16 to 78" and "with tissue error (5 to 95 %)"; of the computation's error "45.7 ± 2.1", no interval and "± numerical error".
/// Where the tissue's interval excludes the value it takes its place: "21 to 37", "58" and "with the tissue of its file".
export function estimateWords(estimate: Estimate): EstimateWords {
  const { value } = estimate
  const cause = widest(estimate)
  const wide = cause && estimate[cause]
  if (!cause || !wide || value === null) return { value: number(value), interval: '', cause: '' }
  const [low, high] = wide
  if (cause === 'numerical' && low <= value && value <= high)
    return { value: withError(value, high - value), interval: '', cause: '± numerical error' }
  const known = knownTenths(value, 0.5 * (high - low))
  const interval = intervalWords(wide)
  if (cause === 'tissue' && tissueExcludesValue(estimate))
    return { value: interval, interval: known, cause: 'with the tissue of its file' }
  return { value: known, interval, cause: `with ${WORDS[cause]} (5 to 95 %)` }
}

/// "0.1 to 3.5", "16 to 78": to a tenth, or to fewer digits where half its width leaves no more.
export function intervalWords([low, high]: Interval): string {
  const half = 0.5 * (high - low)
  return `${knownTenths(low, half)} to ${knownTenths(high, half)}`
}

/// As the command line prints a leak: "46 mm²; 16 to 78 mm² with tissue error (5 to 95 %)".
export function leakInFull(estimate: Estimate): string {
  const { value, interval, cause } = estimateWords(estimate)
  if (estimate.value === null) return value
  if (interval) return `${value} mm²; ${interval} mm² ${cause}`
  const isTissueMissing = estimate.numerical && !estimate.tissue
  return `${value} mm²${isTissueMissing ? ' (numerical error; tissue error not known)' : ''}`
}

/// In large type: "58 ± 6 mm²", "58 mm² (33 to 95)"; the interval alone where it excludes the value.
export function leakInShort(estimate: Estimate): string {
  const { value, interval } = estimateWords(estimate)
  const isAlone = interval === '' || tissueExcludesValue(estimate)
  return estimate.value === null ? value : `${value} mm²${isAlone ? '' : ` (${interval})`}`
}
