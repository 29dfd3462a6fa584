// The leaflets as a lit, thick surface: corners are not shared between faces, so that each segment has its own colour.
import { BufferAttribute, BufferGeometry, Mesh, type Plane } from 'three'
import type { ValveShape } from '../api/types'
import { toLinear } from './colours'
import { boundaryEdges, vertexCount } from './geometry'
import { outwards, type ThickSheet, thickSheet, vertexNormals } from './thick_sheet'
import type { TissueMaterial } from './tissue_material'

export class Leaflets {
  readonly mesh: Mesh<BufferGeometry, TissueMaterial>
  private readonly sheet: ThickSheet
  private readonly edges: [number, number][]
  private readonly points: Float32Array
  private readonly normals: Float32Array
  private painted: Float32Array = new Float32Array()

  /// `material`: the same for all closures of a view, else its program is compiled again.
  constructor(
    private readonly scene: ValveShape,
    material: TissueMaterial,
  ) {
    this.sheet = thickSheet(scene)
    this.edges = boundaryEdges(scene.faces)
    const size = 3 * this.sheet.source.length
    this.points = new Float32Array(size)
    this.normals = new Float32Array(size)
    const geometry = new BufferGeometry()
    geometry.setAttribute('position', new BufferAttribute(this.points, 3))
    geometry.setAttribute('normal', new BufferAttribute(this.normals, 3))
    geometry.setAttribute(
      'atrial',
      new BufferAttribute(
        this.sheet.ups.map((up) => Math.max(up, 0)),
        1,
      ),
    )
    geometry.setAttribute('color', new BufferAttribute(new Float32Array(size).fill(0.8), 3))
    this.mesh = new Mesh(geometry, material)
    material.set(scene)
  }

  /// Of Scene.faces, that the drawn triangle belongs to.
  faceOf(triangle: number): number {
    return Math.floor((this.sheet.source[3 * triangle] as number) / 3)
  }

  /// Lights and places the surface.
  move(nodes: Float32Array): void {
    const { faces, thickness_mm } = this.scene
    const { source, ups, outs } = this.sheet
    const upwards = vertexNormals(faces, nodes, vertexCount(this.scene))
    const sideways = outwards(this.edges, nodes, upwards)
    for (let corner = 0; corner < source.length; ++corner) {
      const vertex = 3 * (faces[source[corner] as number] as number)
      for (let axis = 0; axis < 3; ++axis) {
        const way =
          (ups[corner] as number) * (upwards[vertex + axis] as number) +
          (outs[corner] as number) * (sideways[vertex + axis] as number)
        this.points[3 * corner + axis] = (nodes[vertex + axis] as number) + 0.5 * thickness_mm * way
        this.normals[3 * corner + axis] = way
      }
    }
    const { attributes } = this.mesh.geometry
    for (const name of ['position', 'normal']) (attributes[name] as BufferAttribute).needsUpdate = true
    this.mesh.geometry.computeBoundingSphere()
  }

  /// `colours`: of the corners of Scene.faces, three numbers each. Those of a valve that moves are mostly the same: not sent again.
  paint(colours: Float32Array): void {
    if (colours.length === this.painted.length && colours.every((value, i) => value === this.painted[i])) return
    this.painted = colours
    const attribute = this.mesh.geometry.getAttribute('color') as BufferAttribute
    const linear = colours.map(toLinear)
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
}
