// Orifices over displaced papillary muscles: a grid along three axes.
import { median, numberIn, type Row } from './csv'

export const DIRECTIONS = [
  ['transverse_mm', 'transverse (outwards)'],
  ['posterior_mm', 'posterior'],
  ['apical_mm', 'apical'],
] as const
export type Direction = (typeof DIRECTIONS)[number][0]

/// The places along one axis of the grid, ascending.
export function places(rows: Row[], axis: Direction): number[] {
  return [...new Set(rows.map((row) => numberIn(row, axis) ?? 0))].sort((a, b) => a - b)
}

/// Rows with no displacement but along `axis`, in its order.
export function alone(rows: Row[], axis: Direction): Row[] {
  return rows
    .filter((row) => DIRECTIONS.every(([other]) => other === axis || numberIn(row, other) === 0))
    .sort((a, b) => (numberIn(a, axis) ?? 0) - (numberIn(b, axis) ?? 0))
}

/// `column` over posterior (rows, the largest first) and transverse displacement at one apical place.
export function slice(rows: Row[], apical: number, column: string): (number | null)[][] {
  const level = rows.filter((row) => numberIn(row, 'apical_mm') === apical)
  const at = (transverse: number, posterior: number) =>
    level.find((row) => numberIn(row, 'transverse_mm') === transverse && numberIn(row, 'posterior_mm') === posterior)
  const across = places(rows, 'transverse_mm')
  return places(rows, 'posterior_mm')
    .reverse()
    .map((posterior) => across.map((transverse) => numberIn(at(transverse, posterior) ?? {}, column)))
}

/// The largest of a column where only these axes are displaced; table 4.1's columns, in their order.
export function largestByAxes(rows: Row[]): (number | null)[] {
  const sets: Direction[][] = [
    ['transverse_mm'],
    ['posterior_mm'],
    ['apical_mm'],
    ['transverse_mm', 'posterior_mm'],
    ['transverse_mm', 'apical_mm'],
    ['posterior_mm', 'apical_mm'],
    ['transverse_mm', 'posterior_mm', 'apical_mm'],
  ]
  return sets.map((axes) => {
    const of = rows.filter((row) =>
      DIRECTIONS.every(([axis]) => axes.includes(axis) === (numberIn(row, axis) ?? 0) > 0),
    )
    const areas = of.map((row) => numberIn(row, 'orifice_mm2')).filter((area) => area !== null)
    return areas.length > 0 ? Math.max(...areas) : null
  })
}

export interface Spread {
  median: number | null
  low: number | null
  high: number | null
}

/// Of a list without its unknowns.
export function spread(values: (number | null)[]): Spread {
  const known = values.filter((value): value is number => value !== null)
  if (known.length === 0) return { median: null, low: null, high: null }
  return { median: median(known), low: Math.min(...known), high: Math.max(...known) }
}
