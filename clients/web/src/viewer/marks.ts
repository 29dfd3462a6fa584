// What is named on a valve: landmarks of the annulus, segments of the leaflets, tips.
import type { Scene, Segment } from '../api/types'
import { at, blend, minus, vertexCount } from './geometry'
import type { Label } from './labels'

const LANDMARKS: Record<string, string> = {
  saddle_peak: 'saddle peak',
  mid_posterior: 'mid-posterior',
  anterolateral_trigone: 'AL trigone',
  posteromedial_trigone: 'PM trigone',
  anterolateral_commissure: 'AL commissure',
  posteromedial_commissure: 'PM commissure',
}
const OUTSIDE = 1.14 // of the way from the middle of the annulus: beside it

/// Landmarks, segments (at the middle of their faces) and heads of the papillary muscles.
export function namesOf(scene: Scene, nodes: ArrayLike<number>): Label[] {
  const labels: Label[] = []
  for (const [name, vertex] of Object.entries(scene.landmarks)) {
    const place = at(nodes, vertex)
    labels.push({ point_mm: blend(scene.plane.origin_mm, place, OUTSIDE), text: LANDMARKS[name] ?? name, kind: 'landmark' })
  }
  for (const [segment, point_mm] of segmentMiddles(scene, nodes)) labels.push({ point_mm, text: segment, kind: 'segment' })
  const first = nodes.length / 3 - scene.heads.length
  scene.heads.forEach((head, i) => labels.push({ point_mm: at(nodes, first + i), text: head.id, kind: 'tip' }))
  return labels
}

function segmentMiddles(scene: Scene, nodes: ArrayLike<number>): Map<Segment, [number, number, number]> {
  const sums = new Map<Segment, { sum: number[]; count: number }>()
  scene.segments.forEach((segment, face) => {
    const of = sums.get(segment) ?? { sum: [0, 0, 0], count: 0 }
    for (let k = 0; k < 3; ++k) {
      const corner = at(nodes, scene.faces[3 * face + k] as number)
      of.sum = of.sum.map((part, axis) => part + (corner[axis] as number))
      ++of.count
    }
    sums.set(segment, of)
  })
  return new Map([...sums].map(([segment, { sum, count }]) => [segment, sum.map((part) => part / count) as [number, number, number]]))
}

/// The ball that holds the leaflets and the tips, from above the annulus.
export function ballAround(scene: Scene): { centre_mm: number[]; radius_mm: number } {
  const points = [...Array.from({ length: vertexCount(scene) }, (_, i) => at(scene.rest_mm, i)), ...scene.heads.map((head) => head.tip_mm)]
  const low = [0, 1, 2].map((k) => Math.min(...points.map((point) => point[k] as number)))
  const high = [0, 1, 2].map((k) => Math.max(...points.map((point) => point[k] as number)))
  const centre = low.map((from, k) => (from + (high[k] as number)) / 2) as [number, number, number]
  return { centre_mm: centre, radius_mm: Math.max(...points.map((point) => Math.hypot(...minus(point, centre)))) }
}
