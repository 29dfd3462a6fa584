// The leaflets with their thickness: the mid-surface moved by half of it to either side along its normals, and a rim
// along annulus and free edge. Without drawing.
import type { Scene } from '../api/types'
import { at, boundaryEdges, dot, minus } from './geometry'

export interface ThickSheet {
  source: Uint32Array // of each drawn corner, three a triangle: the corner of Scene.faces that it belongs to
  sides: Int8Array // of each drawn corner: 1 above the mid-surface, -1 below
  rim: number // the first corner of the rim; those before have the normals of the mid-surface
}

export function thickSheet(scene: Scene): ThickSheet {
  const corners = scene.faces.length
  const source: number[] = []
  const sides: number[] = []
  for (const side of [1, -1])
    for (let corner = 0; corner < corners; corner += 3)
      for (const k of side > 0 ? [0, 1, 2] : [0, 2, 1]) {
        source.push(corner + k)
        sides.push(side)
      }
  for (const [a, b] of boundaryCorners(scene.faces)) {
    source.push(a, b, b, a, b, a)
    sides.push(-1, -1, 1, -1, 1, 1)
  }
  return { source: Uint32Array.from(source), sides: Int8Array.from(sides), rim: 2 * corners }
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
    const corners = [0, 1, 2].map((k) => faces[i + k] as number)
    const [a, b, c] = corners.map((vertex) => at(nodes, vertex)) as [
      [number, number, number],
      [number, number, number],
      [number, number, number],
    ]
    const [ux, uy, uz] = minus(b, a)
    const [vx, vy, vz] = minus(c, a)
    const normal = [uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx]
    for (const vertex of corners)
      for (let axis = 0; axis < 3; ++axis) (normals[3 * vertex + axis] as number) += normal[axis] as number
  }
  for (let vertex = 0; vertex < vertices; ++vertex) {
    const normal = at(normals, vertex)
    const size = Math.sqrt(dot(normal, normal)) || 1
    normals.set(
      normal.map((part) => part / size),
      3 * vertex,
    )
  }
  return normals
}
