// Orifices as the view from the atrium shows them: blue areas on the annular plane, in front of everything.
import { DoubleSide, Group, Mesh, MeshBasicMaterial, Path, Shape, ShapeGeometry, Vector3, Matrix4, type Plane } from 'three'
import type { Scene, Vector } from '../api/types'
import { at, blend, dot, minus } from './geometry'

const COLOUR = 0x1668d6
const LEAST_NAMED_MM2 = 0.5 // smaller ones are drawn without a label

export interface OrificeLabel {
  point_mm: Vector
  text: string
}

export class Orifices {
  readonly group = new Group()
  readonly labels: OrificeLabel[] = []

  /// `material`: orificeMaterial(), the same for all closures of a view.
  constructor(
    scene: Scene,
    private readonly material: MeshBasicMaterial,
  ) {
    const { origin_mm, x, y, normal } = scene.plane
    const onPlane = (contour: number[]): [number, number][] =>
      Array.from({ length: contour.length / 3 }, (_, i) => {
        const offset = minus(at(contour, i), origin_mm)
        return [dot(offset, x), dot(offset, y)]
      })
    const upright = new Matrix4().makeBasis(new Vector3(...x), new Vector3(...y), new Vector3(...normal))
    upright.setPosition(new Vector3(...origin_mm))
    for (const { area_mm2, contours_mm } of scene.orifices) {
      const [outer, ...islands] = contours_mm
      if (outer === undefined || outer.length < 9) continue
      const shape = new Shape()
      trace(shape, onPlane(outer))
      for (const island of islands) {
        const hole = new Path()
        trace(hole, onPlane(island))
        shape.holes.push(hole)
      }
      const mesh = new Mesh(new ShapeGeometry(shape), this.material)
      mesh.applyMatrix4(upright)
      mesh.renderOrder = 2
      this.group.add(mesh)
      if (area_mm2 >= LEAST_NAMED_MM2) this.labels.push({ point_mm: middle(outer), text: `${area_mm2.toFixed(1)} mm²` })
    }
  }

  cut(planes: Plane[]): void {
    this.material.clippingPlanes = planes
  }

  dispose(): void {
    for (const child of this.group.children) if (child instanceof Mesh) (child.geometry as ShapeGeometry).dispose()
  }
}

/// In front of everything.
export function orificeMaterial(): MeshBasicMaterial {
  return new MeshBasicMaterial({ color: COLOUR, side: DoubleSide, depthTest: false, transparent: true, opacity: 0.85 })
}

function trace(path: Path, points: [number, number][]): void {
  points.forEach(([x, y], i) => (i === 0 ? path.moveTo(x, y) : path.lineTo(x, y)))
  path.closePath()
}

function middle(contour: number[]): Vector {
  const count = contour.length / 3
  let mean: Vector = [0, 0, 0]
  for (let i = 0; i < count; ++i) mean = blend(mean, at(contour, i), 1 / (i + 1))
  return mean
}
