// The narrowest passage of an open valve: its outline, and its area as a label in its middle.
import type { Opening } from '../api/types'
import { cm2 } from '../format'
import { at, plus, times } from './geometry'
import type { Label } from './labels'

/// `line`: six numbers a piece. Nothing where it was not measured.
export function passageOf({ scene, opening_area_mm2 }: Opening): { line: number[]; labels: Label[] } | null {
  const { passage_mm } = scene
  const count = passage_mm.length / 3
  if (count === 0) return null
  const points = Array.from({ length: count }, (_, i) => at(passage_mm, i))
  const line = points.flatMap((point, i) => [...point, ...at(passage_mm, (i + 1) % count)])
  const point_mm = times(1 / count, points.reduce(plus))
  return { line, labels: [{ point_mm, text: cm2(opening_area_mm2), kind: 'orifice' }] }
}
