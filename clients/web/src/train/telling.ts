// Which segment tells two closed valves of one mesh apart: the one whose free edge lies at the most different height.
import type { ValveShape } from '../api/types'
import { at, dot, minus } from '../viewer/geometry'
import { SEGMENTS, type SegmentName } from './types'

const FREE_EDGE = 0.8 // of the way from annulus to free edge, from where tissue counts

export interface Telling {
  segment: SegmentName
  higher_mm: number // in the first valve than in the second, mean over the segment's free edge
}

/// `first_mm`, `second_mm`: vertices in the order of the scene's.
export function telling(scene: ValveShape, first_mm: readonly number[], second_mm: readonly number[]): Telling {
  const { faces, segments, plane, leaflet_coordinates } = scene
  const heights = SEGMENTS.map((segment) => {
    const corners = segments.flatMap((name, face) => (name === segment ? faces.slice(3 * face, 3 * face + 3) : []))
    const edge = [...new Set(corners)].filter((vertex) => (leaflet_coordinates.height[vertex] ?? 0) >= FREE_EDGE)
    const higher = edge.map((vertex) => dot(minus(at(first_mm, vertex), at(second_mm, vertex)), plane.normal))
    const higher_mm = higher.length > 0 ? higher.reduce((sum, one) => sum + one) / higher.length : 0
    return { segment, higher_mm }
  })
  return heights.reduce((most, one) => (Math.abs(one.higher_mm) > Math.abs(most.higher_mm) ? one : most))
}
