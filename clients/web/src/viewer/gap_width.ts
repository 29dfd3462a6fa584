// How wide an opening is at each point of its surface: the largest ball around a point of it that reaches no further than the rim, of those
// that hold the point. On a slit it is the distance between its lips, the same across the slit.
import type { LeakSurfaces, Vector } from '../api/types'
import { at, boundaryEdges, distance } from './geometry'

const SLACK = 1.05 // points of the rim are on the border of their ball

/// Millimetres, one a point.
export function gapWidths({ points_mm, faces }: LeakSurfaces[number]): number[] {
  const points = Array.from({ length: points_mm.length / 3 }, (_, i) => at(points_mm, i))
  const rim = [...new Set(boundaryEdges(faces).flat())].map((i) => points[i] as Vector)
  const radii = points.map((point) => rim.reduce((least, other) => Math.min(least, distance(point, other)), Infinity))
  return points.map((point) =>
    points.reduce((widest, middle, i) => {
      const radius = radii[i] as number
      return 2 * radius > widest && distance(point, middle) <= SLACK * radius ? 2 * radius : widest
    }, 0),
  )
}
