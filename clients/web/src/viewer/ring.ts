// A ring that is sutured to the annulus: a tube on its atrial side, upon the tissue that bulges there.
import { CatmullRomCurve3, Mesh, MeshLambertMaterial, type Plane, TubeGeometry, Vector3 } from 'three'
import type { ValveShape } from '../api/types'
import { TINTS } from './colours'
import { at, dot, length, minus, plus, times, vertexCount } from './geometry'

const RADIUS_MM = 1.1
const REACH_MM = 2.5 // of tissue that lifts it
const AROUND = 12 // corners of its cross-section
const PIECES = 4 // between two vertices of the annulus

export class Ring {
  readonly mesh = new Mesh(undefined, new MeshLambertMaterial({ color: TINTS.ring }))

  /// `nodes`: of the leaflets, which it lies upon.
  set(scene: ValveShape | null, nodes: ArrayLike<number> = []): void {
    this.mesh.visible = scene !== null
    if (!scene) return
    this.mesh.geometry.dispose()
    const { normal } = scene.plane
    const base = 0.5 * scene.thickness_mm + RADIUS_MM
    const points = tissueHeights(scene, nodes).map(
      (height, i) => new Vector3(...plus(at(scene.annulus_mm, i), times(base + height, normal))),
    )
    const line = new CatmullRomCurve3(points, true)
    this.mesh.geometry = new TubeGeometry(line, PIECES * points.length, RADIUS_MM, AROUND, true)
  }

  cut(planes: Plane[]): void {
    this.mesh.material.clippingPlanes = planes
  }
}

/// Of the tissue beside each vertex of the annulus, above it; smooth along the ring.
function tissueHeights(scene: ValveShape, nodes: ArrayLike<number>): number[] {
  const { normal } = scene.plane
  const tissue = Array.from({ length: nodes.length > 0 ? vertexCount(scene) : 0 }, (_, i) => at(nodes, i))
  const highest = scene.annulus.map((_, i) => {
    const beside = tissue.map((point) => minus(point, at(scene.annulus_mm, i))).filter((way) => length(way) < REACH_MM)
    return Math.max(0, ...beside.map((way) => dot(way, normal)))
  })
  const around = (i: number): number[] => [-2, -1, 0, 1, 2].map((k) => highest.at((i + k) % highest.length) ?? 0)
  const widest = highest.map((_, i) => Math.max(...around(i)))
  return widest.map((height, i) => (height + (widest.at(i - 1) ?? 0) + (widest[(i + 1) % widest.length] ?? 0)) / 3)
}
