// The leaflets as a lit surface: corners are not shared between faces, so that each face can have its own colour.
import { BufferAttribute, BufferGeometry, DoubleSide, Mesh, MeshLambertMaterial, type Plane } from 'three'
import type { Scene } from '../api/types'

export class Leaflets {
  readonly mesh: Mesh<BufferGeometry, MeshLambertMaterial>
  private readonly points: Float32Array
  private readonly normals: Float32Array

  /// `material`: leafletMaterial(), the same for all closures of a view.
  constructor(
    private readonly scene: Scene,
    material: MeshLambertMaterial,
  ) {
    this.points = new Float32Array(3 * scene.faces.length)
    this.normals = new Float32Array(3 * scene.faces.length)
    const geometry = new BufferGeometry()
    geometry.setAttribute('position', new BufferAttribute(this.points, 3))
    geometry.setAttribute('normal', new BufferAttribute(this.normals, 3))
    geometry.setAttribute('color', new BufferAttribute(new Float32Array(this.points.length).fill(0.8), 3))
    this.mesh = new Mesh(geometry, material)
  }

  /// Lights and places the surface; normals are those of vertices, from the faces around them.
  move(nodes: Float32Array): void {
    const { faces, rest_mm } = this.scene
    const { points } = this
    const sums = new Float32Array(rest_mm.length)
    for (let corner = 0; corner < faces.length; ++corner) {
      const vertex = 3 * (faces[corner] as number)
      for (let k = 0; k < 3; ++k) points[3 * corner + k] = nodes[vertex + k] as number
    }
    for (let i = 0; i < points.length; i += 9) {
      const [ax, ay, az, bx, by, bz, cx, cy, cz] = points.subarray(i, i + 9) as unknown as number[] as [
        number, number, number, number, number, number, number, number, number,
      ]
      const [ux, uy, uz, vx, vy, vz] = [bx - ax, by - ay, bz - az, cx - ax, cy - ay, cz - az]
      const normal = [uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx]
      for (let k = 0; k < 3; ++k) {
        const vertex = 3 * (faces[i / 3 + k] as number)
        for (let axis = 0; axis < 3; ++axis) (sums[vertex + axis] as number) += normal[axis] as number
      }
    }
    for (let corner = 0; corner < faces.length; ++corner) {
      const vertex = 3 * (faces[corner] as number)
      const [x, y, z] = [sums[vertex] as number, sums[vertex + 1] as number, sums[vertex + 2] as number]
      const size = Math.hypot(x, y, z) || 1
      this.normals.set([x / size, y / size, z / size], 3 * corner)
    }
    const { attributes } = this.mesh.geometry
    for (const name of ['position', 'normal']) (attributes[name] as BufferAttribute).needsUpdate = true
    this.mesh.geometry.computeBoundingSphere()
  }

  paint(colours: Float32Array): void {
    const attribute = this.mesh.geometry.getAttribute('color') as BufferAttribute
    // The shader works with linear light.
    attribute.copyArray(colours.map(toLinear))
    attribute.needsUpdate = true
  }

  cut(planes: Plane[]): void {
    this.mesh.material.clippingPlanes = planes
  }

  dispose(): void {
    this.mesh.geometry.dispose()
  }
}

/// Drawn a little behind lines that lie on it.
export function leafletMaterial(): MeshLambertMaterial {
  const offset = { polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 1 }
  return new MeshLambertMaterial({ vertexColors: true, side: DoubleSide, ...offset })
}

function toLinear(part: number): number {
  return part <= 0.04045 ? part / 12.92 : ((part + 0.055) / 1.055) ** 2.4
}
