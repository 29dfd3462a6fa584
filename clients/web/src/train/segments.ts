// Segments of a valve: which one a hook holds, and where their names stand.
import type { ValveShape } from '../api/types'
import type { LiveValve } from '../live/client'
import type { Grip } from '../live/hooks'
import { at, dot, minus, plus, times, unit } from '../viewer/geometry'
import type { Label } from '../viewer/labels'
import { SEGMENTS, type SegmentName } from './types'

const OUTSIDE = 1.14 // of the way from the middle of the annulus: beside it

/// Of the tissue that is held; of a chorda's cable that of the leaflet that it leads to.
export function segmentOf({ scene, cables }: Pick<LiveValve, 'scene' | 'cables'>, grip: Grip): SegmentName | null {
  if ('vertex' in grip) return ofVertex(scene, grip.vertex)
  const [chorda, segment] = cables[grip.cable] ?? [-1, -1]
  const face = insertion(scene.chordae[chorda]?.segments ?? [], segment)
  return face === null ? null : (scene.segments[face] ?? null)
}

/// The segment of most of the faces around a vertex, of equal ones the first.
export function ofVertex({ faces, segments }: ValveShape, vertex: number): SegmentName | null {
  const counts = new Map<SegmentName, number>()
  for (const [corner, other] of faces.entries()) {
    const segment = segments[Math.floor(corner / 3)]
    if (other === vertex && segment) counts.set(segment, (counts.get(segment) ?? 0) + 1)
  }
  const [best] = [...counts].sort(([a, x], [b, y]) => y - x || SEGMENTS.indexOf(a) - SEGMENTS.indexOf(b))
  return best?.[0] ?? null
}

/// Where the first branch of a chorda's segment ends in a leaflet.
function insertion(segments: ValveShape['chordae'][number]['segments'], from: number): number | null {
  for (let i = from; i >= 0 && i < segments.length; ) {
    const face = segments[i]?.face
    if (face !== undefined) return face
    i = segments.findIndex(({ parent }) => parent === i)
  }
  return null
}

/// Beside the annulus, which does not move; `words` of a segment, or none.
export function namesAround(scene: ValveShape, words: (segment: SegmentName) => string | null): Label[] {
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
function annulusOf({ annulus, faces, segments }: ValveShape, segment: SegmentName): Set<number> {
  const corners = segments.flatMap((name, face) => (name === segment ? faces.slice(3 * face, 3 * face + 3) : []))
  return new Set(corners.map((vertex) => annulus.indexOf(vertex)).filter((i) => i >= 0))
}
