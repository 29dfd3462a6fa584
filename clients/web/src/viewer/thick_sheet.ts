// The leaflets with their thickness: the mid-surface moved by half of it to either side along its normals, and round
// edges along annulus and free edge, which reach out as far as the leak counts tissue. Without drawing.
import type { ValveShape, Vector } from '../api/types'
import { at, blend, boundaryEdges, cross, length, minus, plus, times, unit } from './geometry'

const EDGE_DEG = [90, 45, 0, -45, -90] // of a round edge, from its atrial side to its ventricular one

export interface ThickSheet {
  source: Uint32Array // of each drawn corner, three a triangle: the corner of Scene.faces that it belongs to
  ups: Float32Array // of each drawn corner: how far along the normal, in half thicknesses
  outs: Float32Array // and how far out over the edge
}

export function thickSheet(scene: ValveShape): ThickSheet {
  const source: number[] = []
  const ups: number[] = []
  const outs: number[] = []
  const put = (corner: number, degrees: number): void => {
    source.push(corner)
    ups.push(Math.sin((degrees * Math.PI) / 180))
    outs.push(Math.cos((degrees * Math.PI) / 180))
  }
  for (let corner = 0; corner < scene.faces.length; corner += 3) for (const k of [0, 1, 2]) put(corner + k, 90)
  for (let corner = 0; corner < scene.faces.length; corner += 3) for (const k of [0, 2, 1]) put(corner + k, -90)
  for (const [a, b] of boundaryCorners(scene.faces))
    EDGE_DEG.slice(1).forEach((low, i) => {
      const high = EDGE_DEG[i] as number
      for (const [corner, degrees] of [
        [a, low],
        [b, low],
        [b, high],
        [a, low],
        [b, high],
        [a, high],
      ] as const)
        put(corner, degrees)
    })
  return { source: Uint32Array.from(source), ups: Float32Array.from(ups), outs: Float32Array.from(outs) }
}

/// Corners of the faces at the two ends of each boundary edge.
function boundaryCorners(faces: readonly number[]): [number, number][] {
  const boundary = new Set(boundaryEdges(faces).map(([a, b]) => `${a} ${b}`))
  const found: [number, number][] = []
  for (let i = 0; i < faces.length; i += 3)
    for (let k = 0; k < 3; ++k) {
      const next = i + ((k + 1) % 3)
      if (boundary.has(`${faces[i + k]} ${faces[next]}`)) found.push([i + k, next])
    }
  return found
}

/// Of the vertices, from the faces around them, as long as 1.
export function vertexNormals(faces: readonly number[], nodes: ArrayLike<number>, vertices: number): Float32Array {
  const normals = new Float32Array(3 * vertices)
  for (let i = 0; i < faces.length; i += 3) {
    const [a, b, c] = [0, 1, 2].map((k) => at(nodes, faces[i + k] as number)) as [Vector, Vector, Vector]
    const normal = cross(minus(b, a), minus(c, a))
    for (let k = 0; k < 3; ++k) add(normals, faces[i + k] as number, normal)
  }
  for (let vertex = 0; vertex < vertices; ++vertex) normals.set(unit(at(normals, vertex)), 3 * vertex)
  return normals
}

const SHARPEST = 2 // a corner reaches out at most so many times as far as an edge

/// Of the vertices of `edges` (boundaryEdges()): along the surface, away from it, as long as it takes to move the edges
/// beside them by 1. Of the others: nothing.
export function outwards(
  edges: readonly (readonly [number, number])[],
  nodes: ArrayLike<number>,
  normals: Float32Array,
): Float32Array {
  const away = new Float32Array(normals.length)
  for (const [a, b] of edges) {
    const normal = blend(at(normals, a), at(normals, b), 0.5)
    const way = unit(cross(minus(at(nodes, b), at(nodes, a)), normal))
    for (const vertex of [a, b]) add(away, vertex, way)
  }
  for (const vertex of new Set(edges.flat())) {
    const sum = at(away, vertex) // of two as long as 1
    if (length(sum) > 0) away.set(times(Math.min(2 / length(sum), SHARPEST), unit(sum)), 3 * vertex)
  }
  return away
}

function add(vectors: Float32Array, i: number, vector: Vector): void {
  vectors.set(plus(at(vectors, i), vector), 3 * i)
}
