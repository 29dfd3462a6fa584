// Which segment of a valve a hook holds.
import type { ValveShape } from '../api/types'
import type { LiveValve } from '../live/client'
import type { Grip } from '../live/hooks'
import { SEGMENTS, type SegmentName } from './types'

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
