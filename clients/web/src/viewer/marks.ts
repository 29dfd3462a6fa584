// What is named on a valve: landmarks of the annulus, segments of the leaflets, tips.
import type { Segment, ValveShape, Vector } from '../api/types'
import { at, blend, distance, onFace, plus, times, vertexCount } from './geometry'
import type { Label } from './labels'

const LANDMARKS: Record<string, string> = {
  saddle_peak: 'saddle peak',
  mid_posterior: 'mid-posterior',
  anterolateral_trigone: 'AL trigone',
  posteromedial_trigone: 'PM trigone',
  anterolateral_commissure: 'AL commissure',
  posteromedial_commissure: 'PM commissure',
}
const BELLY = { from: 0.1, to: 0.6 } // of the way from annulus to free edge
const OUTSIDE = 1.14 // of the way from the middle of the annulus: beside it

/// Landmarks, segments (at their middle face) and heads of the papillary muscles.
export function namesOf(scene: ValveShape, nodes: ArrayLike<number>): Label[] {
  const labels: Label[] = []
  for (const [name, vertex] of Object.entries(scene.landmarks)) {
    const place = at(nodes, vertex)
    labels.push({
      point_mm: blend(scene.plane.origin_mm, place, OUTSIDE),
      names_mm: place,
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

/// The middle face of a segment's belly: a point of tissue, which the other leaflet seldom hides.
function segmentMiddles(scene: ValveShape, nodes: ArrayLike<number>): Map<Segment, Vector> {
  const bellies = new Map<Segment, Vector[]>()
  const alls = new Map<Segment, Vector[]>()
  scene.segments.forEach((segment, face) => {
    const middle = onFace(scene, nodes, face, [1 / 3, 1 / 3, 1 / 3])
    const heights = [0, 1, 2].map((k) => scene.leaflet_coordinates.height[scene.faces[3 * face + k] as number] ?? 0)
    const isBelly = heights.every((height) => height >= BELLY.from && height <= BELLY.to)
    for (const points of isBelly ? [alls, bellies] : [alls]) {
      const listed = points.get(segment)
      if (listed) listed.push(middle)
      else points.set(segment, [middle])
    }
  })
  return new Map(
    [...alls].map(([segment, all]) => {
      const points = bellies.get(segment) ?? all
      return [segment, nearestTo(mean(points), points)]
    }),
  )
}

function mean(points: Vector[]): Vector {
  return times(1 / points.length, points.reduce(plus))
}

function nearestTo(place: Vector, points: Vector[]): Vector {
  return points.reduce((best, point) => (distance(point, place) < distance(best, place) ? point : best))
}

/// Leaflets and papillary tips, unloaded.
export function wholeValve(scene: ValveShape): Vector[] {
  return [
    ...Array.from({ length: vertexCount(scene) }, (_, i) => at(scene.rest_mm, i)),
    ...scene.heads.map((head) => head.tip_mm),
  ]
}

/// The annulus and the names of its landmarks around it.
export function namedAnnulus(scene: ValveShape): Vector[] {
  const points = Array.from({ length: scene.annulus_mm.length / 3 }, (_, i) => at(scene.annulus_mm, i))
  return [...points, ...points.map((point) => blend(scene.plane.origin_mm, point, OUTSIDE))]
}
