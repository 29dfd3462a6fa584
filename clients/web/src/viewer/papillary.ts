// Papillary muscles below their tips, so that chordae are seen to fan out of them. They are a sign, as large in every valve:
// tips are all that a valve holds of a muscle.
import { BufferAttribute, BufferGeometry, DoubleSide, Mesh, MeshPhongMaterial, type Plane } from 'three'
import type { ValveShape, Vector } from '../api/types'
import { TINTS } from './colours'
import { cross, distance, minus, plus, times, tipsOf, unit } from './geometry'
import type { Stage } from './stage'
import { WET } from './tissue_material'

const LENGTH_MM = 8 // from the middle of a muscle's tips to its end
const RADIUS_MM = 2.8
const TAPER = 0.5 // of the radius at the tip, less than at the end
const ALONG = 12 // pieces of a head
const AROUND = 16
const MOVED_MM = 0.05 // from where they are drawn anew

export class PapillaryMuscles {
  readonly mesh = new Mesh(
    new BufferGeometry(),
    new MeshPhongMaterial({ color: TINTS.papillary, side: DoubleSide, ...WET }), // a cut shows the inner side
  )
  private drawn: Vector[] = []

  constructor() {
    this.mesh.visible = false
  }

  /// From above nothing of them is seen but what stands out beside the annulus, where the wall of the ventricle hides it.
  seenFrom(stage: Stage): void {
    this.mesh.visible = !stage.isFromAbove
  }

  /// `nodes`: of the state that is drawn; tips move in a beat alone.
  set(scene: ValveShape, nodes: ArrayLike<number>): void {
    const tips = tipsOf(scene, nodes)
    if (tips.length === this.drawn.length && tips.every((tip, i) => distance(tip, this.drawn[i] as Vector) < MOVED_MM))
      return
    this.drawn = tips
    const ends = muscleEnds(scene, tips)
    const points = tips.flatMap((tip, i) => headPoints(tip, ends[i] as Vector))
    const faces = tips.flatMap((_, i) => headFaces(i * HEAD_POINTS))
    this.mesh.geometry.dispose()
    this.mesh.geometry = new BufferGeometry()
    this.mesh.geometry.setAttribute('position', new BufferAttribute(Float32Array.from(points), 3))
    this.mesh.geometry.setIndex(faces)
    this.mesh.geometry.computeVertexNormals()
  }

  cut(planes: Plane[]): void {
    this.mesh.material.clippingPlanes = planes
  }
}

/// Of each tip the end of its muscle, where all heads of a side meet: from the middle of their tips away from the annulus.
export function muscleEnds({ heads, plane }: ValveShape, tips: readonly Vector[]): Vector[] {
  const ends = new Map<string, Vector>()
  for (const side of new Set(heads.map((head) => head.side))) {
    const own = tips.filter((_, i) => heads[i]?.side === side)
    const middle = times(1 / own.length, own.reduce(plus))
    const way = unit(minus(unit(minus(middle, plane.origin_mm)), plane.normal))
    ends.set(side, plus(middle, times(LENGTH_MM, way)))
  }
  return heads.map(({ side }) => ends.get(side) as Vector)
}

const HEAD_POINTS = (ALONG - 1) * AROUND + 2

/// An egg from tip to end: the tip, rings, the end.
function headPoints(tip: Vector, end: Vector): number[] {
  const axis = minus(end, tip)
  const across = unit(cross(axis, Math.abs(axis[0]) < Math.abs(axis[1]) ? [1, 0, 0] : [0, 1, 0]))
  const other = unit(cross(axis, across))
  const points = [...tip]
  for (let ring = 1; ring < ALONG; ++ring) {
    const share = 0.5 * (1 - Math.cos((Math.PI * ring) / ALONG)) // of the way
    const radius = RADIUS_MM * Math.sin((Math.PI * ring) / ALONG) * (1 - TAPER * (1 - share))
    const middle = plus(tip, times(share, axis))
    for (let i = 0; i < AROUND; ++i) {
      const turn = (2 * Math.PI * i) / AROUND
      const out = plus(times(Math.cos(turn), across), times(Math.sin(turn), other))
      points.push(...plus(middle, times(radius, out)))
    }
  }
  return [...points, ...end]
}

/// Three corners each, seen from outside counterclockwise.
function headFaces(first: number): number[] {
  const faces: number[] = []
  const on = (ring: number, i: number): number => first + 1 + (ring - 1) * AROUND + (i % AROUND)
  const last = first + HEAD_POINTS - 1
  for (let i = 0; i < AROUND; ++i) {
    faces.push(first, on(1, i + 1), on(1, i), last, on(ALONG - 1, i), on(ALONG - 1, i + 1))
    for (let ring = 1; ring + 1 < ALONG; ++ring)
      faces.push(on(ring, i), on(ring, i + 1), on(ring + 1, i), on(ring, i + 1), on(ring + 1, i + 1), on(ring + 1, i))
  }
  return faces
}
