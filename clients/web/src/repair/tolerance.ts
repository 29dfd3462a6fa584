// How far a step may miss: the valve closed with it in other places, near ones on the axes first, then farther ones and those between.
import type { Closure, Step } from '../api/types'
import { withError, withUnit } from '../format'
import type { ToleranceWords } from '../state/readings'
import type { Misses } from './errors'

export const TRACE_MM2 = 1 // a leak below it is none or a trace, as in reports (kTraceLeak_mm2)

export interface Sample {
  errors: number[] // mm, one a way
  leak_mm2: number | null // null: not closed, or not to be trusted
  error_mm2: number | null // of the computation
}

export interface Tolerance {
  samples: Sample[] // the first is the plan as planned
  isDone: boolean
}

const REACH = [1, 3, 2] // units, in this order: near, far, between
const SKEW = Math.SQRT1_2
const NEAR = 1e-6

/// Errors to try, by stages.
export function errorsToTry({ ways, unit }: Misses): number[][] {
  const only = (way: number, mm: number): number[] => ways.map((_, i) => (i === way ? mm : 0))
  const axes = REACH.flatMap((units) =>
    ways.flatMap((_, way) => [only(way, -units * unit.mm), only(way, units * unit.mm)]),
  )
  if (ways.length < 2) return axes
  const skew = [...REACH].sort().flatMap((units) =>
    [
      [1, 1],
      [1, -1],
      [-1, 1],
      [-1, -1],
    ].map(([a = 0, b = 0]) => ways.map((_, i) => (i > 1 ? 0 : SKEW * units * unit.mm * (i === 0 ? a : b)))),
  )
  return [...axes, ...skew]
}

/// `close` with the step in place of the planned one; `atOnce` closures at a time. `tell` is called with what is known after each.
export async function varied(
  misses: Misses,
  planned: Sample,
  close: (step: Step) => Promise<Closure>,
  tell: (known: Tolerance) => void,
  { atOnce, signal }: { atOnce: number; signal: AbortSignal },
): Promise<void> {
  const samples = [planned]
  const left = errorsToTry(misses)
  const work = async (): Promise<void> => {
    for (let errors = left.shift(); errors && !signal.aborted; errors = left.shift()) {
      const step = misses.stepAt(errors)
      if (!step) continue
      const closure = await close(step).catch(() => null)
      if (signal.aborted) return
      samples.push(sampleOf(errors, closure))
      tell({ samples, isDone: false })
    }
  }
  tell({ samples, isDone: false })
  await Promise.all(Array.from({ length: atOnce }, work))
  if (!signal.aborted) tell({ samples, isDone: true })
}

export function sampleOf(errors: number[], closure: Closure | null): Sample {
  const isTrusted = closure !== null && closure.status === 'converged' && !closure.crossing
  return {
    errors,
    leak_mm2: isTrusted ? closure.leak_mm2 : null,
    error_mm2: isTrusted ? closure.leak.error_mm2 : null,
  }
}

const size = (errors: readonly number[]): number => Math.hypot(...errors)

/// In millimetres: where the leak first exceeds `limit_mm2` in any direction that was tried, between two closures by their difference.
/// `isMore`: it holds as far as was tried. Null: it leaks as planned, or nothing else is known.
export function marginOf(samples: Sample[], limit_mm2: number): { mm: number; isMore: boolean } | null {
  const [planned, ...others] = samples
  if (!planned || planned.leak_mm2 === null || planned.leak_mm2 > limit_mm2 || others.length === 0) return null
  const rays = new Map<string, Sample[]>()
  for (const sample of others) {
    const key = sample.errors.map((part) => (part / size(sample.errors)).toFixed(3)).join(' ')
    rays.set(key, [...(rays.get(key) ?? []), sample])
  }
  let least = Infinity
  let tried = Infinity
  for (const ray of rays.values()) {
    let last: Sample = planned
    for (const sample of ray.sort((one, other) => size(one.errors) - size(other.errors))) {
      if (sample.leak_mm2 === null) break
      if (sample.leak_mm2 > limit_mm2) {
        const from = size(last.errors)
        const share = (limit_mm2 - (last.leak_mm2 ?? 0)) / (sample.leak_mm2 - (last.leak_mm2 ?? 0))
        least = Math.min(least, from + share * (size(sample.errors) - from))
        break
      }
      last = sample
    }
    tried = Math.min(tried, size(last.errors))
  }
  return least < Infinity ? { mm: least, isMore: false } : { mm: tried, isMore: true }
}

export function wordsOf({ samples }: Tolerance, misses: Misses, limit_mm2: number): ToleranceWords | null {
  const margin = marginOf(samples, limit_mm2)
  const near = samples.filter(({ errors }) => Math.abs(size(errors) - misses.unit.mm) < NEAR)
  const worst = near.reduce<Sample | null>(
    (most, sample) => ((sample.leak_mm2 ?? -1) > (most?.leak_mm2 ?? -1) ? sample : most),
    null,
  )
  if (!worst) return null
  return {
    handle: misses.name,
    margin: margin && `${margin.isMore ? 'at least ' : ''}${withUnit(margin.mm, 'mm')}`,
    leak_off: withError(worst.leak_mm2, worst.error_mm2, 'mm²'),
  }
}

/// The leak at errors between those that were tried: the nearer the more it counts. Null: nothing is known.
export function leakAt(samples: Sample[], errors: readonly number[]): number | null {
  let sum = 0
  let weights = 0
  for (const { errors: tried, leak_mm2 } of samples) {
    if (leak_mm2 === null || tried.slice(errors.length).some((part) => part !== 0)) continue
    const away = errors.reduce((square, part, i) => square + (part - (tried[i] ?? 0)) ** 2, 0)
    if (away < NEAR) return leak_mm2
    const weight = 1 / away ** 2
    sum += weight * leak_mm2
    weights += weight
  }
  return weights === 0 ? null : sum / weights
}
