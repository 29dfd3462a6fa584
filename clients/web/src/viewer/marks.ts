// What is named on a valve: landmarks of the annulus, segments of the leaflets, tips.
import type { Segment, ValveShape, Vector } from '../api/types'
import { at, blend, closedLine, distance, dot, minus, onFace, plus, times, tipsOf, unit, vertexCount } from './geometry'
import type { Label } from './labels'
import { muscleEnds } from './papillary'
import type { ViewName } from './stage'

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
const AORTA = { radius_mm: 11, off_mm: 1.5, seen_mm: 4.5 } // off: from the annulus; the picture ends within it
const APPENDAGE = { across_mm: 5, along_mm: 7, off_mm: 4 }
const AROUND = 48 // points of an outline
const HOURS_MM = 2 // within the annulus
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
  for (const [i, point_mm] of tipsOf(scene, nodes).entries())
    labels.push({ point_mm, text: scene.heads[i]?.id ?? '', kind: 'tip' })
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

/// Leaflets, unloaded and as `nodes` has them, and papillary muscles.
export function wholeValve(scene: ValveShape, nodes: ArrayLike<number> = scene.rest_mm): Vector[] {
  return [
    ...[scene.rest_mm, nodes].flatMap((places) => Array.from({ length: vertexCount(scene) }, (_, i) => at(places, i))),
    ...papillary(scene),
  ]
}

function papillary(scene: ValveShape): Vector[] {
  const tips = scene.heads.map((head) => head.tip_mm)
  return [...tips, ...muscleEnds(scene, tips)]
}

/// What the camera holds in a view: from above the annulus alone, with its names; from below no unloaded leaflets, which hang so near to the
/// eye that they would take the room.
export function heldIn(view: ViewName, scene: ValveShape, nodes?: ArrayLike<number>): Vector[] {
  if (view === 'atrial') return namedAnnulus(scene)
  if (view !== 'ventricular' || !nodes) return wholeValve(scene, nodes)
  return [
    ...Array.from({ length: vertexCount(scene) }, (_, i) => at(nodes, i)),
    ...annulusPoints(scene).map((point) => blend(scene.plane.origin_mm, point, OUTSIDE)),
    ...papillary(scene),
  ]
}

/// The annulus, the names of its landmarks around it and some of the aorta.
function namedAnnulus(scene: ValveShape): Vector[] {
  const points = annulusPoints(scene)
  const aorta = atClock(scene, 12, AORTA.seen_mm)
  return [...points, ...points.map((point) => blend(scene.plane.origin_mm, point, OUTSIDE)), aorta]
}

function annulusPoints({ annulus_mm }: ValveShape): Vector[] {
  return Array.from({ length: annulus_mm.length / 3 }, (_, i) => at(annulus_mm, i))
}

/// So far outside the annulus at an hour of the surgeon's view, which is that of 3D echo: 12 anterior, 9 anterolateral.
function atClock(scene: ValveShape, hour: number, outside_mm: number): Vector {
  const { origin_mm, x, y } = scene.plane
  const turn = (hour / 6) * Math.PI
  const way = plus(times(Math.sin(turn), x), times(Math.cos(turn), y))
  const reach = Math.max(...annulusPoints(scene).map((point) => dot(minus(point, origin_mm), way)))
  return plus(origin_mm, times(reach + outside_mm, way))
}

/// What orients the surgeon's view: the aortic root at 12 o'clock and the left atrial appendage at 9, where they lie in most hearts
/// and about as large; nothing of them is measured. `outline`: six numbers a line.
export function neighbours(scene: ValveShape): { outline: number[]; label: Label }[] {
  const { x, y } = scene.plane
  const outline = (middle: Vector, across_mm: number, along_mm: number, lobes: number): number[] =>
    closedLine(
      Array.from({ length: AROUND }, (_, i) => {
        const turn = (2 * Math.PI * i) / AROUND
        const share = 1 + 0.1 * Math.sin(lobes * turn)
        const way = plus(times(across_mm * Math.cos(turn), x), times(along_mm * Math.sin(turn), y))
        return plus(middle, times(share, way))
      }),
    )
  const aorta = atClock(scene, 12, AORTA.off_mm + AORTA.radius_mm)
  const appendage = atClock(scene, 9, APPENDAGE.off_mm + APPENDAGE.across_mm)
  return [
    {
      outline: outline(aorta, AORTA.radius_mm, AORTA.radius_mm, 0),
      label: { point_mm: atClock(scene, 12, AORTA.seen_mm), text: 'aortic root', kind: 'neighbour' },
    },
    {
      outline: outline(appendage, APPENDAGE.across_mm, APPENDAGE.along_mm, 5),
      label: { point_mm: appendage, text: 'appendage', kind: 'neighbour' },
    },
  ]
}

/// The hours, on the tissue beside the annulus.
export function hours(scene: ValveShape): Label[] {
  return Array.from({ length: 12 }, (_, i) => ({
    point_mm: atClock(scene, i + 1, -HOURS_MM),
    text: String(i + 1),
    kind: 'hour',
  }))
}
