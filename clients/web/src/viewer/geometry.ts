// Geometry of a scene, without drawing. Points are flat arrays in millimetres. A state of the valve is its nodes in the
// order of Scene.motion_mm: vertices, branch points of chordae, heads.
import type { Leaflet, LeafletPoint, OpeningScene, ValveShape, Vector } from '../api/types'

export function at(points: ArrayLike<number>, i: number): Vector {
  return [points[3 * i] ?? NaN, points[3 * i + 1] ?? NaN, points[3 * i + 2] ?? NaN]
}

export const plus = (a: Vector, b: Vector): Vector => [a[0] + b[0], a[1] + b[1], a[2] + b[2]]
export const minus = (a: Vector, b: Vector): Vector => [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
export const times = (share: number, a: Vector): Vector => [share * a[0], share * a[1], share * a[2]]
export const dot = (a: Vector, b: Vector): number => a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
export function cross(a: Vector, b: Vector): Vector {
  return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}
export const length = (a: Vector): number => Math.sqrt(dot(a, a))
/// As long as 1; nothing stays nothing.
export const unit = (a: Vector): Vector => times(1 / (length(a) || 1), a)
export const distance = (a: Vector, b: Vector): number => length(minus(a, b))
export function blend(a: Vector, b: Vector, share: number): Vector {
  return [a[0] + share * (b[0] - a[0]), a[1] + share * (b[1] - a[1]), a[2] + share * (b[2] - a[2])]
}

export function vertexCount(scene: ValveShape): number {
  return scene.rest_mm.length / 3
}

/// The closed state; the open one if the closure flew apart.
export function closedNodes(scene: ValveShape): Float32Array {
  const nodes = [...(scene.closed_mm ?? scene.rest_mm)]
  for (const chorda of scene.chordae)
    for (const segment of chorda.segments) if (segment.face === undefined) nodes.push(...segment.end_mm)
  for (const head of scene.heads) nodes.push(...head.tip_mm)
  return Float32Array.from(nodes)
}

/// The state at `share` of a beat: -1 open in diastole, 0 unstressed, 1 closed; the closed one if there is no motion.
export function nodesAt(scene: ValveShape, share: number, opening: OpeningScene | null = null): Float32Array {
  if (share < 0 && opening && opening.motion_mm.length > 1) return stateAt(opening.motion_mm, -share)
  return scene.motion_mm.length < 2 ? closedNodes(scene) : stateAt(scene.motion_mm, share)
}

/// At `share` of the way from the first state to the last.
function stateAt(states: number[][], share: number): Float32Array {
  const place = Math.min(Math.max(share, 0), 1) * (states.length - 1)
  const first = Math.min(Math.floor(place), states.length - 2)
  const a = states[first] as number[]
  const b = states[first + 1] as number[]
  return Float32Array.from(a, (value, i) => value + (place - first) * ((b[i] as number) - value))
}

/// Papillary tips, in the order of heads.
export function tipsOf({ heads }: ValveShape, nodes: ArrayLike<number>): Vector[] {
  return heads.map((_, i) => at(nodes, nodes.length / 3 - heads.length + i))
}

/// Six numbers a chorda segment, its two ends, in the order of chordae and segments.
export function chordaLines(scene: ValveShape, nodes: ArrayLike<number>): number[] {
  const lines: number[] = []
  let branch = vertexCount(scene)
  let heads = branch
  for (const chorda of scene.chordae) for (const segment of chorda.segments) if (segment.face === undefined) ++heads
  for (const chorda of scene.chordae) {
    const ends: Vector[] = []
    for (const segment of chorda.segments) {
      const start = segment.parent < 0 ? at(nodes, heads + chorda.head) : (ends[segment.parent] as Vector)
      const end =
        segment.face === undefined
          ? at(nodes, branch++)
          : onFace(scene, nodes, segment.face, segment.weights ?? [1, 0, 0])
      ends.push(end)
      lines.push(...start, ...end)
    }
  }
  return lines
}

/// Six numbers a tie of an edge-to-edge repair, its two ends.
export function tieLines(scene: ValveShape, nodes: ArrayLike<number>): number[] {
  return scene.ties.flatMap(({ anterior, posterior }) => [
    ...onFace(scene, nodes, anterior.face, anterior.weights),
    ...onFace(scene, nodes, posterior.face, posterior.weights),
  ])
}

/// Six numbers a piece of a resection's seam.
export function seamLines(scene: ValveShape, nodes: ArrayLike<number>): number[] {
  return scene.seams.flatMap((seam) => {
    const points = seam.map(({ face, weights }) => onFace(scene, nodes, face, weights))
    return points.slice(1).flatMap((point, i) => [...(points[i] as Vector), ...point])
  })
}

export function onFace(scene: ValveShape, nodes: ArrayLike<number>, face: number, weights: Vector): Vector {
  const point: Vector = [0, 0, 0]
  for (let k = 0; k < 3; ++k) {
    const corner = at(nodes, scene.faces[3 * face + k] as number)
    for (let axis = 0; axis < 3; ++axis) (point[axis] as number) += (weights[k] as number) * (corner[axis] as number)
  }
  return point
}

/// Edges that one face alone has: annulus and free edge. Pairs of vertices.
export function boundaryEdges(faces: readonly number[]): [number, number][] {
  const seen = new Map<string, [number, number]>()
  for (let i = 0; i < faces.length; i += 3)
    for (let k = 0; k < 3; ++k) {
      const a = faces[i + k] as number
      const b = faces[i + ((k + 1) % 3)] as number
      const key = a < b ? `${a} ${b}` : `${b} ${a}`
      if (!seen.delete(key)) seen.set(key, [a, b])
    }
  return [...seen.values()]
}

export interface SectionPiece {
  from: Vector
  to: Vector
  face: number
}

/// Where a plane cuts the leaflets. A vertex on the plane counts as being in front of it.
export function section(scene: ValveShape, nodes: ArrayLike<number>, point: Vector, normal: Vector): SectionPiece[] {
  const pieces: SectionPiece[] = []
  for (let face = 0; 3 * face < scene.faces.length; ++face) {
    const corners = [0, 1, 2].map((k) => at(nodes, scene.faces[3 * face + k] as number)) as [Vector, Vector, Vector]
    const sides = corners.map((corner) => dot(minus(corner, point), normal)) as Vector
    const ends: Vector[] = []
    for (let k = 0; k < 3; ++k) {
      const a = sides[k] as number
      const b = sides[(k + 1) % 3] as number
      if (a >= 0 !== b >= 0) ends.push(blend(corners[k] as Vector, corners[(k + 1) % 3] as Vector, a / (a - b)))
    }
    if (ends.length === 2) pieces.push({ from: ends[0] as Vector, to: ends[1] as Vector, face })
  }
  return pieces
}

/// From `around` (see Scene.leaflet_coordinates) to the leaflet and the place along it.
export function leafletPlace(around: number): { leaflet: Leaflet; along: number } {
  const turn = ((around % 1) + 1) % 1
  return turn < 0.5 ? { leaflet: 'anterior', along: 1 - 2 * turn } : { leaflet: 'posterior', along: 2 * turn - 1 }
}

export function leafletPointAt(scene: ValveShape, face: number, weights: Vector): LeafletPoint {
  const { around, height } = scene.leaflet_coordinates
  const corners = [0, 1, 2].map((k) => scene.faces[3 * face + k] as number)
  const first = around[corners[0] as number] as number
  let turn = 0
  let up = 0
  corners.forEach((vertex, k) => {
    const value = around[vertex] as number
    turn += (weights[k] as number) * (value - Math.round(value - first)) // across the jump from 1 to 0
    up += (weights[k] as number) * (height[vertex] as number)
  })
  return { ...leafletPlace(turn), height: Math.min(Math.max(up, 0), 1) }
}

/// The point of the annulus under pressure at `around`.
export function annulusPoint(scene: ValveShape, around: number): Vector {
  const count = scene.annulus.length
  for (let i = 0; i < count; ++i) {
    const from = scene.leaflet_coordinates.around[scene.annulus[i] as number] as number
    const to = scene.leaflet_coordinates.around[scene.annulus[(i + 1) % count] as number] as number
    const way = to - Math.round(to - from) - from
    const share = (around - Math.round(around - from) - from) / way
    if (share >= 0 && share <= 1) return blend(at(scene.annulus_mm, i), at(scene.annulus_mm, (i + 1) % count), share)
  }
  return at(scene.annulus_mm, 0)
}

/// Mean position under pressure of the heads of a side.
export function papillaryTip(scene: ValveShape, side: string): Vector {
  const heads = scene.heads.filter((head) => head.side === side)
  const sum: Vector = [0, 0, 0]
  for (const head of heads) for (let k = 0; k < 3; ++k) (sum[k] as number) += (head.tip_mm[k] as number) / heads.length
  return sum
}

/// Six numbers a piece, the last one back to the first point.
export function closedLine(points: Vector[]): number[] {
  return points.flatMap((point, i) => [...point, ...(points[(i + 1) % points.length] as Vector)])
}
