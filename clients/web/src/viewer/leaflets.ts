// The leaflets as a lit, thick surface: corners are not shared between faces, so that each segment has its own colour.
import { BufferAttribute, BufferGeometry, DoubleSide, Mesh, MeshLambertMaterial, type Plane } from 'three'
import type { Scene } from '../api/types'
import { vertexCount } from './geometry'
import { type ThickSheet, thickSheet, vertexNormals } from './thick_sheet'

export class Leaflets {
  readonly mesh: Mesh<BufferGeometry, MeshLambertMaterial>
  private readonly sheet: ThickSheet
  private readonly points: Float32Array
  private readonly normals: Float32Array

  /// `material`: leafletMaterial(), the same for all closures of a view.
  constructor(
    private readonly scene: Scene,
    material: MeshLambertMaterial,
  ) {
    this.sheet = thickSheet(scene)
    const size = 3 * this.sheet.source.length
    this.points = new Float32Array(size)
    this.normals = new Float32Array(size)
    const geometry = new BufferGeometry()
    geometry.setAttribute('position', new BufferAttribute(this.points, 3))
    geometry.setAttribute('normal', new BufferAttribute(this.normals, 3))
    geometry.setAttribute('color', new BufferAttribute(new Float32Array(size).fill(0.8), 3))
    this.mesh = new Mesh(geometry, material)
  }

  /// Of Scene.faces, that the drawn triangle belongs to.
  faceOf(triangle: number): number {
    return Math.floor((this.sheet.source[3 * triangle] as number) / 3)
  }

  /// Lights and places the surface.
  move(nodes: Float32Array): void {
    const { faces, thickness_mm } = this.scene
    const { source, sides, rim } = this.sheet
    const upwards = vertexNormals(faces, nodes, vertexCount(this.scene))
    for (let corner = 0; corner < source.length; ++corner) {
      const vertex = 3 * (faces[source[corner] as number] as number)
      const side = sides[corner] as number
      for (let axis = 0; axis < 3; ++axis) {
        const normal = side * (upwards[vertex + axis] as number)
        this.points[3 * corner + axis] = (nodes[vertex + axis] as number) + 0.5 * thickness_mm * normal
        this.normals[3 * corner + axis] = normal
      }
    }
    for (let corner = rim; corner < source.length; corner += 3) this.lightFlat(corner)
    const { attributes } = this.mesh.geometry
    for (const name of ['position', 'normal']) (attributes[name] as BufferAttribute).needsUpdate = true
    this.mesh.geometry.computeBoundingSphere()
  }

  /// `colours`: of the corners of Scene.faces, three numbers each.
  paint(colours: Float32Array): void {
    const attribute = this.mesh.geometry.getAttribute('color') as BufferAttribute
    const linear = colours.map(toLinear) // the shader works with linear light
    for (const [corner, from] of this.sheet.source.entries())
      attribute.setXYZ(
        corner,
        linear[3 * from] as number,
        linear[3 * from + 1] as number,
        linear[3 * from + 2] as number,
      )
    attribute.needsUpdate = true
  }

  cut(planes: Plane[]): void {
    this.mesh.material.clippingPlanes = planes
  }

  dispose(): void {
    this.mesh.geometry.dispose()
  }

  /// The triangle that begins at `corner`, by its own plane.
  private lightFlat(corner: number): void {
    const [ax, ay, az, bx, by, bz, cx, cy, cz] = this.points.subarray(3 * corner, 3 * corner + 9) as unknown as [
      ...Nine,
    ]
    const [ux, uy, uz, vx, vy, vz] = [bx - ax, by - ay, bz - az, cx - ax, cy - ay, cz - az]
    const normal = [uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx]
    const size = Math.hypot(...normal) || 1
    for (let k = 0; k < 3; ++k)
      this.normals.set(
        normal.map((part) => part / size),
        3 * (corner + k),
      )
  }
}

type Nine = [number, number, number, number, number, number, number, number, number]

/// Drawn a little behind lines that lie on it.
export function leafletMaterial(): MeshLambertMaterial {
  const offset = { polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 1 }
  return new MeshLambertMaterial({ vertexColors: true, side: DoubleSide, ...offset })
}

function toLinear(part: number): number {
  return part <= 0.04045 ? part / 12.92 : ((part + 0.055) / 1.055) ** 2.4
}
