// What lies under the pointer, in terms of a repair plan.
import { Raycaster, Triangle, Vector3, type Mesh } from 'three'
import type { LeafletPoint, Scene, Vector } from '../api/types'
import { annulusAround, at, chordaLines, leafletPointAt } from './geometry'
import type { Stage } from './stage'

export type Pick =
  | { kind: 'leaflet'; point: LeafletPoint; point_mm: Vector }
  | { kind: 'annulus'; around: number; point_mm: Vector }
  | { kind: 'head'; id: string; point_mm: Vector }
  | { kind: 'chorda'; id: string; point_mm: Vector }

export type PickKind = Pick['kind']

const REACH_PX = 14 // of points and lines

/// The nearest of the kinds that are asked for, or null.
export function pickAt(event: MouseEvent, stage: Stage, scene: Scene, nodes: Float32Array, mesh: Mesh, kinds: PickKind[]): Pick | null {
  const box = stage.canvas.getBoundingClientRect()
  const x = event.clientX - box.left
  const y = event.clientY - box.top
  const away = (point: Vector): number => {
    const seen = stage.place(point)
    return Math.hypot(seen.x - x, seen.y - y)
  }
  if (kinds.includes('head')) {
    const found = nearest(scene.heads.map((head, i) => ({ id: head.id, point: at(nodes, nodes.length / 3 - scene.heads.length + i) })), (c) => away(c.point))
    if (found) return { kind: 'head', id: found.id, point_mm: found.point }
  }
  if (kinds.includes('chorda')) {
    const found = nearest(chordaPoints(scene, nodes), (c) => away(c.point))
    if (found) return { kind: 'chorda', id: found.id, point_mm: found.point }
  }
  if (kinds.includes('annulus')) {
    const points = Array.from({ length: scene.annulus_mm.length / 3 }, (_, i) => at(scene.annulus_mm, i))
    const found = nearest(points, away)
    if (found) return { kind: 'annulus', around: annulusAround(scene, found), point_mm: found }
  }
  if (!kinds.includes('leaflet')) return null
  const ray = new Raycaster()
  ray.setFromCamera(stage.pointer(event), stage.camera)
  const hit = ray.intersectObject(mesh)[0]
  if (!hit || hit.faceIndex === undefined || hit.faceIndex === null) return null
  const face = hit.faceIndex
  const corners = [0, 1, 2].map((k) => new Vector3(...at(nodes, scene.faces[3 * face + k] as number))) as [Vector3, Vector3, Vector3]
  const weights = Triangle.getBarycoord(hit.point, ...corners, new Vector3()) ?? new Vector3(1, 0, 0)
  return {
    kind: 'leaflet',
    point: leafletPointAt(scene, face, [weights.x, weights.y, weights.z]),
    point_mm: [hit.point.x, hit.point.y, hit.point.z],
  }
}

function nearest<T>(candidates: T[], away: (candidate: T) => number): T | null {
  let found: T | null = null
  let least = REACH_PX
  for (const candidate of candidates) {
    const distance = away(candidate)
    if (distance >= least) continue
    least = distance
    found = candidate
  }
  return found
}

/// Points along all chordae.
function chordaPoints(scene: Scene, nodes: Float32Array): { id: string; point: Vector }[] {
  const lines = chordaLines(scene, nodes)
  const points: { id: string; point: Vector }[] = []
  let i = 0
  for (const chorda of scene.chordae)
    for (let s = 0; s < chorda.segments.length; ++s, i += 6)
      for (let share = 0.1; share < 1; share += 0.1)
        points.push({
          id: chorda.id,
          point: [0, 1, 2].map((k) => (lines[i + k] as number) + share * ((lines[i + 3 + k] as number) - (lines[i + k] as number))) as Vector,
        })
  return points
}
