// What is named on a valve: landmarks of the annulus, segments of the leaflets, tips.
import type { Scene, Segment, Vector } from '../api/types'
import { at, blend, vertexCount } from './geometry'
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
    labels.push({
      point_mm: blend(scene.plane.origin_mm, place, OUTSIDE),
      text: LANDMARKS[name] ?? name,
      kind: 'landmark',
    })
  }
  for (const [segment, point_mm] of segmentMiddles(scene, nodes))
    labels.push({ point_mm, text: segment, kind: 'segment' })
  const first = nodes.length / 3 - scene.heads.length
  for (const [i, head] of scene.heads.entries())
    labels.push({ point_mm: at(nodes, first + i), text: head.id, kind: 'tip' })
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
  return new Map(
    [...sums].map(([segment, { sum, count }]) => [
      segment,
      sum.map((part) => part / count) as [number, number, number],
    ]),
  )
}

/// Leaflets and papillary tips, unloaded.
export function wholeValve(scene: Scene): Vector[] {
  return [
    ...Array.from({ length: vertexCount(scene) }, (_, i) => at(scene.rest_mm, i)),
    ...scene.heads.map((head) => head.tip_mm),
  ]
}

/// The annulus and the names of its landmarks around it.
export function namedAnnulus(scene: Scene): Vector[] {
  const points = Array.from({ length: scene.annulus_mm.length / 3 }, (_, i) => at(scene.annulus_mm, i))
  return [...points, ...points.map((point) => blend(scene.plane.origin_mm, point, OUTSIDE))]
}
