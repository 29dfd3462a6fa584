// What is named on a valve: landmarks of the annulus, segments of the leaflets, tips.
import type { Segment, ValveShape, Vector } from '../api/types'
import { at, blend, distance, dot, minus, onFace, plus, times, unit, vertexCount } from './geometry'
import type { Label } from './labels'

const LANDMARKS: Record<string, string> = {
  saddle_peak: 'saddle peak',
  mid_posterior: 'mid-posterior',
  anterolateral_trigone: 'AL trigone',
  posteromedial_trigone: 'PM trigone',
  anterolateral_commissure: 'AL commissure',
  posteromedial_commissure: 'PM commissure',
}
export const SEGMENTS = ['A1', 'A2', 'A3', 'P1', 'P2', 'P3', 'AC', 'PC'] as const satisfies readonly Segment[]
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

/// Beside the annulus, which does not move; `words` of a segment, or none.
export function namesAround(scene: ValveShape, words: (segment: Segment) => string | null): Label[] {
  const { origin_mm } = scene.plane
  return SEGMENTS.flatMap((segment) => {
    const text = words(segment)
    const ways = [...annulusOf(scene, segment)].map((i) => minus(at(scene.annulus_mm, i), origin_mm))
    if (text === null || ways.length === 0) return []
    const middle = unit(ways.reduce(plus))
    const reach = Math.max(...ways.map((way) => dot(way, middle)))
    return [{ point_mm: plus(origin_mm, times(OUTSIDE * reach, middle)), text, kind: 'segment' as const }]
  })
}

/// Places in Scene.annulus, those between two segments of both.
function annulusOf({ annulus, faces, segments }: ValveShape, segment: Segment): Set<number> {
  const corners = segments.flatMap((name, face) => (name === segment ? faces.slice(3 * face, 3 * face + 3) : []))
  return new Set(corners.map((vertex) => annulus.indexOf(vertex)).filter((i) => i >= 0))
}

/// Leaflets, unloaded and as `nodes` has them, and papillary tips.
export function wholeValve(scene: ValveShape, nodes: ArrayLike<number> = scene.rest_mm): Vector[] {
  return [
    ...[scene.rest_mm, nodes].flatMap((places) => Array.from({ length: vertexCount(scene) }, (_, i) => at(places, i))),
    ...scene.heads.map((head) => head.tip_mm),
  ]
}

/// The annulus and the names of its landmarks around it.
export function namedAnnulus(scene: ValveShape): Vector[] {
  const points = Array.from({ length: scene.annulus_mm.length / 3 }, (_, i) => at(scene.annulus_mm, i))
  return [...points, ...points.map((point) => blend(scene.plane.origin_mm, point, OUTSIDE))]
}
