// How the eye meets a cut through a valve.
import { Plane, Vector3 } from 'three'
import type { ValveShape, Vector } from '../api/types'
import { dot, minus, plus, times, unit } from './geometry'
import { wholeValve } from './marks'
import type { Stage } from './stage'

export interface CutPlane {
  point_mm: Vector
  normal: Vector
}

const TURNED_TO = 0.5 // sine between sight and cut, from where on the cut is seen well
const LEAST_SLANT = 0.1 // sine between sight and cut, from where on the hidden side changes

/// Sine between sight and cut, above 0 from where the normal points to.
function slantOf(stage: Stage, { point_mm, normal }: CutPlane): number {
  return dot(unit(minus(stage.camera.position.toArray(), point_mm)), normal)
}

/// A new cut that is seen from its edge shows nothing: the camera turns to it, the atrium stays above.
export function turnToCut(stage: Stage, scene: ValveShape, nodes: ArrayLike<number> | undefined, cut: CutPlane): void {
  if (Math.abs(slantOf(stage, cut)) > TURNED_TO) return
  const { normal } = scene.plane
  stage.look(plus(times(-Math.sign(cut.normal[0]), cut.normal), times(0.3, normal)), wholeValve(scene, nodes))
}

/// Which side of the cut the eye is on, 1 or -1; as before if it is nearly in it.
export function nearSide(stage: Stage, cut: CutPlane, before: number): number {
  const slant = slantOf(stage, cut)
  return Math.abs(slant) < LEAST_SLANT ? before : Math.sign(slant)
}

/// What hides that side of the leaflets; nothing without a cut.
export function clippingPlanes(cut: CutPlane | null, side: number): Plane[] {
  if (!cut) return []
  const kept = new Vector3(...times(-side, cut.normal))
  return [new Plane().setFromNormalAndCoplanarPoint(kept, new Vector3(...cut.point_mm))]
}

/// Whether a point is on the side that is drawn.
export function isLeft(cut: CutPlane | null, side: number, point_mm: Vector): boolean {
  return !cut || side * dot(minus(point_mm, cut.point_mm), cut.normal) <= 0
}
