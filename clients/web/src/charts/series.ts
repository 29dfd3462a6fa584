// Lines of a chart, and what they have in common: one list of places along x.
import type { Hue } from './colours'

export interface Series {
  label: string
  hue: Hue
  x: number[] // ascending
  y: (number | null)[]
  look?: 'line' | 'dashed' | 'dots' | 'steps'
  low?: (number | null)[] // of a range around each y
  high?: (number | null)[]
}

/// All places of all series, ascending, and what each series has there; null where it has nothing.
export function aligned(series: Series[]): { x: number[]; y: (number | null)[][] } {
  const x = [...new Set(series.flatMap((one) => one.x))].sort((a, b) => a - b)
  const y = series.map((one) => {
    const at = new Map(one.x.map((place, i) => [place, one.y[i] ?? null]))
    return x.map((place) => at.get(place) ?? null)
  })
  return { x, y }
}

/// The place whose value is read for a line at `index`: the nearest that has one; of steps the one before; of dots none
/// but its own.
export function readAt(look: Series['look'], values: ArrayLike<number | null | undefined>, index: number): number {
  if (look === 'dots') return index
  for (let way = 0; way < values.length; ++way)
    for (const place of look === 'steps' ? [index - way] : [index - way, index + way]) {
      const value = values[place]
      if (value !== null && value !== undefined) return place
    }
  return index
}
