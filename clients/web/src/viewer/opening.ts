// Where the closed valve is open, in three dimensions: a membrane across each orifice of the atrial view, and one between
// the leaflets where that view hides that they are apart. Solid where nothing is before it, faint through tissue.
import {
  BufferAttribute,
  BufferGeometry,
  DoubleSide,
  Group,
  Mesh,
  MeshBasicMaterial,
  type Plane,
  ShapeUtils,
  Vector2,
} from 'three'
import type { Scene, Vector } from '../api/types'
import { at, blend, dot, minus } from './geometry'

const COLOUR = 0x1668d6
const LEAST_NAMED_MM2 = 0.5 // smaller ones are drawn without a label

export interface OpeningLabel {
  point_mm: Vector
  text: string
}

export interface Membrane {
  points: number[] // flat, millimetres
  triangles: number[]
  label: OpeningLabel | null
}

type Seen = [number, number] // in the annular plane

function seen(scene: Scene, point: Vector): Seen {
  const offset = minus(point, scene.plane.origin_mm)
  return [dot(offset, scene.plane.x), dot(offset, scene.plane.y)]
}

/// Across the orifices of the atrial view, as high as the tissue around them.
export function orificeMembranes(scene: Scene): Membrane[] {
  return scene.orifices.flatMap(({ area_mm2, contours_mm }) => {
    const [outer, ...islands] = contours_mm.map((contour) => {
      const points = Array.from({ length: contour.length / 3 }, (_, i) => at(contour, i))
      return points.map((point) => new Vector2(...seen(scene, point)))
    })
    if (outer === undefined || outer.length < 3) return []
    const label = { point_mm: middle(contours_mm[0] as number[]), text: `${area_mm2.toFixed(1)} mm²` }
    return {
      points: contours_mm.flat(),
      triangles: ShapeUtils.triangulateShape(outer, islands).flat(),
      label: area_mm2 >= LEAST_NAMED_MM2 ? label : null,
    }
  })
}

/// Between the leaflets in neighbouring sections without contact, but where the atrial view shows the orifice itself.
export function hiddenMembranes(scene: Scene): Membrane[] {
  const runs: [Vector, Vector][][] = [[]]
  for (const { contact, nearest_mm } of scene.sections) {
    const pair = nearest_mm as [Vector, Vector] | null
    if (!contact && pair !== null && !isInOrifice(scene, blend(...pair, 0.5))) runs.at(-1)?.push(pair)
    else runs.push([])
  }
  return runs.filter((pairs) => pairs.length > 1).map(between)
}

function between(pairs: [Vector, Vector][]): Membrane {
  const triangles = pairs.slice(1).flatMap((_, i) => [2 * i, 2 * i + 1, 2 * i + 2, 2 * i + 1, 2 * i + 3, 2 * i + 2])
  return { points: pairs.flat(2), triangles, label: null }
}

function isInOrifice(scene: Scene, point: Vector): boolean {
  const [x, y] = seen(scene, point)
  return scene.orifices.some(({ contours_mm: [outer = []] }) => {
    let isInside = false
    const corners = Array.from({ length: outer.length / 3 }, (_, i) => seen(scene, at(outer, i)))
    corners.forEach(([ax, ay], i) => {
      const [bx, by] = corners[(i + 1) % corners.length] as Seen
      if (ay > y !== by > y && x < ax + ((y - ay) / (by - ay)) * (bx - ax)) isInside = !isInside
    })
    return isInside
  })
}

function middle(contour: number[]): Vector {
  let mean: Vector = [0, 0, 0]
  for (let i = 0; 3 * i < contour.length; ++i) mean = blend(mean, at(contour, i), 1 / (i + 1))
  return mean
}

export class Opening {
  readonly group = new Group()
  readonly labels: OpeningLabel[]

  /// `materials`: openingMaterials(), the same for all closures of a view.
  constructor(
    scene: Scene,
    private readonly materials: MeshBasicMaterial[],
  ) {
    const hidden = hiddenMembranes(scene)
    const membranes = [...orificeMembranes(scene), ...hidden]
    this.labels = membranes.flatMap(({ label }) => label ?? [])
    const gap_mm2 = scene.closure.coaptation?.gap_area_mm2 ?? 0
    const widest = hidden.sort((a, b) => b.points.length - a.points.length)[0]
    if (widest && gap_mm2 >= LEAST_NAMED_MM2)
      this.labels.push({ point_mm: middle(widest.points), text: `gap ${gap_mm2.toFixed(1)} mm²` })
    for (const { points, triangles } of membranes) {
      const geometry = new BufferGeometry()
      geometry.setAttribute('position', new BufferAttribute(Float32Array.from(points), 3))
      geometry.setIndex(triangles)
      for (const material of materials) {
        const mesh = new Mesh(geometry, material)
        mesh.renderOrder = 2
        this.group.add(mesh)
      }
    }
  }

  cut(planes: Plane[]): void {
    for (const material of this.materials) material.clippingPlanes = planes
  }

  dispose(): void {
    for (const child of this.group.children) if (child instanceof Mesh) (child.geometry as BufferGeometry).dispose()
  }
}

export function openingMaterials(): MeshBasicMaterial[] {
  return [
    new MeshBasicMaterial({ color: COLOUR, side: DoubleSide }),
    new MeshBasicMaterial({ color: COLOUR, side: DoubleSide, depthTest: false, transparent: true, opacity: 0.35 }),
  ]
}
