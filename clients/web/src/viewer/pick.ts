// What lies under the pointer, in terms of a repair plan.
import { Raycaster, Triangle, Vector3, type Intersection, type Material } from 'three'
import type { LeafletPoint, ValveShape, Vector } from '../api/types'
import { annulusPoint, at, chordaLines, leafletPointAt, tipsOf } from './geometry'
import type { Leaflets } from './leaflets'
import type { Stage } from './stage'

export type Pick =
  | { kind: 'leaflet'; point: LeafletPoint; point_mm: Vector; face: number; weights: Vector }
  | { kind: 'annulus'; around: number; point_mm: Vector }
  | { kind: 'head'; id: string; point_mm: Vector }
  | { kind: 'chorda'; id: string; point_mm: Vector }

export type PickKind = Pick['kind']

const REACH_PX = 14 // of points and lines

/// The nearest of the kinds that are asked for, or null.
export function pickAt(
  event: MouseEvent,
  stage: Stage,
  scene: ValveShape,
  nodes: Float32Array,
  leaflets: Leaflets,
  kinds: PickKind[],
): Pick | null {
  const box = stage.canvas.getBoundingClientRect()
  const x = event.clientX - box.left
  const y = event.clientY - box.top
  const away = (point: Vector): number => {
    const seen = stage.place(point)
    return Math.hypot(seen.x - x, seen.y - y)
  }
  const hit = kinds.includes('leaflet') ? leafletHit(event, stage, leaflets) : null
  if (kinds.includes('head')) {
    const found = nearest(
      tipsOf(scene, nodes).map((point, i) => ({ id: scene.heads[i]?.id ?? '', point })),
      (c) => away(c.point),
    )
    const isHidden = hit && found && hit.distance < stage.camera.position.distanceTo(new Vector3(...found.point))
    if (found && !isHidden) return { kind: 'head', id: found.id, point_mm: found.point }
  }
  if (kinds.includes('chorda')) {
    const found = nearest(chordaPoints(scene, nodes), (c) => away(c.point))
    if (found) return { kind: 'chorda', id: found.id, point_mm: found.point }
  }
  if (kinds.includes('annulus')) {
    const points = scene.annulus.map((vertex) => ({ vertex, point: at(nodes, vertex) }))
    const found = nearest(points, (c) => away(c.point))
    if (found)
      return { kind: 'annulus', around: scene.leaflet_coordinates.around[found.vertex] ?? 0, point_mm: found.point }
  }
  if (!hit || hit.faceIndex === undefined || hit.faceIndex === null) return null
  const face = leaflets.faceOf(hit.faceIndex)
  const corners = [0, 1, 2].map((k) => new Vector3(...at(nodes, scene.faces[3 * face + k] as number))) as [
    Vector3,
    Vector3,
    Vector3,
  ]
  const weights = (Triangle.getBarycoord(hit.point, ...corners, new Vector3()) ?? new Vector3(1, 0, 0)).toArray()
  return {
    kind: 'leaflet',
    point: leafletPointAt(scene, face, weights),
    point_mm: hit.point.toArray(),
    face,
    weights,
  }
}

/// The place of the annulus, 0 to 1, that is seen nearest to the pointer.
export function nearestAround(event: MouseEvent, stage: Stage, scene: ValveShape): number {
  const box = stage.canvas.getBoundingClientRect()
  const away = (around: number): number => {
    const { x, y } = stage.place(annulusPoint(scene, around))
    return Math.hypot(x - event.clientX + box.left, y - event.clientY + box.top)
  }
  const places = Array.from({ length: 180 }, (_, i) => i / 180)
  return places.reduce((best, place) => (away(place) < away(best) ? place : best))
}

const SEEN_MM = 2 // behind tissue is what lies so far behind it

export function isBehind(point_mm: Vector, stage: Stage, leaflets: Leaflets): boolean {
  const eye = stage.camera.position
  const way = new Vector3(...point_mm).sub(eye)
  const hit = firstHit(new Raycaster(eye, way.clone().normalize()), leaflets)
  return hit !== null && hit.distance < way.length() - SEEN_MM
}

function leafletHit(event: MouseEvent, stage: Stage, leaflets: Leaflets): Intersection | null {
  const ray = new Raycaster()
  ray.setFromCamera(stage.pointer(event), stage.camera)
  return firstHit(ray, leaflets)
}

/// Of the leaflets as they are shown: what is cut away is not hit.
function firstHit(ray: Raycaster, { mesh }: Leaflets): Intersection | null {
  const planes = (mesh.material as Material).clippingPlanes ?? []
  const isShown = ({ point }: Intersection): boolean => planes.every((plane) => plane.distanceToPoint(point) >= 0)
  return ray.intersectObject(mesh).find(isShown) ?? null
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
function chordaPoints(scene: ValveShape, nodes: Float32Array): { id: string; point: Vector }[] {
  const lines = chordaLines(scene, nodes)
  const points: { id: string; point: Vector }[] = []
  let i = 0
  for (const chorda of scene.chordae)
    for (let s = 0; s < chorda.segments.length; ++s, i += 6)
      for (let share = 0.1; share < 1; share += 0.1)
        points.push({
          id: chorda.id,
          point: [0, 1, 2].map(
            (k) => (lines[i + k] as number) + share * ((lines[i + 3 + k] as number) - (lines[i + k] as number)),
          ) as Vector,
        })
  return points
}
