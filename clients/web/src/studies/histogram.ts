// How often values fall where.

import { roundUp } from '../charts/rounds'

export interface Histogram {
  edges: number[] // of the bins, one more than there are bins
  counts: number[][] // by sample, then bin
}

/// About `bins` bins of a round width from the least to the largest value, the same for all samples.
export function histogram(samples: (number | null)[][], bins: number): Histogram {
  const known = samples.map((sample) => sample.filter((value): value is number => value !== null))
  const all = known.flat()
  if (all.length === 0) return { edges: [0, 1], counts: known.map(() => [0]) }
  const least = Math.min(...all)
  const most = Math.max(...all)
  const width = most > least ? roundUp((most - least) / bins) : 1
  const from = Math.floor(least / width) * width
  const count = Math.max(1, Math.floor((most - from) / width) + 1)
  const edges = Array.from({ length: count + 1 }, (_, i) => Number((from + i * width).toPrecision(12)))
  const counts = known.map((sample) => {
    const of = new Array<number>(count).fill(0)
    for (const value of sample) {
      const bin = Math.min(count - 1, Math.floor((value - from) / width))
      of[bin] = (of[bin] ?? 0) + 1
    }
    return of
  })
  return { edges, counts }
}
