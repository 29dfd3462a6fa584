// A ring that is sutured to the annulus: a tube on its atrial side.
import { CatmullRomCurve3, Mesh, MeshLambertMaterial, type Plane, TubeGeometry, Vector3 } from 'three'
import type { ValveShape } from '../api/types'
import { at, plus, times } from './geometry'

const RADIUS_MM = 1.1
const AROUND = 12 // corners of its cross-section
const PIECES = 4 // between two vertices of the annulus

export class Ring {
  readonly mesh = new Mesh(undefined, new MeshLambertMaterial({ color: '#e4e7ec' }))

  set(scene: ValveShape | null): void {
    this.mesh.visible = scene !== null
    if (!scene) return
    this.mesh.geometry.dispose()
    const up = times(0.5 * scene.thickness_mm + RADIUS_MM, scene.plane.normal)
    const points = scene.annulus.map((_, i) => new Vector3(...plus(at(scene.annulus_mm, i), up)))
    const line = new CatmullRomCurve3(points, true)
    this.mesh.geometry = new TubeGeometry(line, PIECES * points.length, RADIUS_MM, AROUND, true)
  }

  cut(planes: Plane[]): void {
    this.mesh.material.clippingPlanes = planes
  }
}
