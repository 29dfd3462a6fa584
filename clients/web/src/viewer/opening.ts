// Where the closed valve is open, in three dimensions: a membrane across each orifice of the atrial view, and one between
// the leaflets where that view hides that they are apart. Solid where nothing is before it, seen through tissue with its
// outline drawn over everything.
import { knownDigits } from '../format'
import {
  BufferAttribute,
  BufferGeometry,
  DoubleSide,
  GreaterDepth,
  Group,
  Mesh,
  MeshBasicMaterial,
  type Plane,
  ShapeUtils,
  Vector2,
} from 'three'
import type { Scene, Vector } from '../api/types'
import { TINTS } from './colours'
import { at, blend, boundaryEdges, distance, dot, minus, plus, times } from './geometry'
import { Lines } from './lines'
import { outwards } from './thick_sheet'

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
    const label = {
      point_mm: middle(contours_mm[0] as number[]),
      text: `${knownDigits(area_mm2, scene.closure.orifice_area_mm2_error)} mm²`,
    }
    return {
      points: levelled(scene, contours_mm.flat()),
      triangles: ShapeUtils.triangulateShape(outer, islands).flat(),
      label: area_mm2 >= LEAST_NAMED_MM2 ? label : null,
    }
  })
}

/// At the mean height of what is nearer than about the tissue's thickness: folds of a free edge lie above each other.
function levelled({ plane, thickness_mm }: Scene, points: number[]): number[] {
  const all = vectors(points)
  const heights = all.map((point) => dot(minus(point, plane.origin_mm), plane.normal))
  return all.flatMap((point, i) => {
    const own = heights[i] as number
    let [sum, weight] = [0, 0]
    for (const [j, other] of all.entries()) {
      const height = heights[j] as number
      const apart2 = distance(point, other) ** 2 - (height - own) ** 2 // in the plane
      const counts = Math.exp(-apart2 / (2 * thickness_mm ** 2))
      sum += counts * height
      weight += counts
    }
    return plus(point, times(sum / weight - own, plane.normal))
  })
}

/// Between the leaflets along the line on which they are nearest, but where they touch and where the atrial view shows
/// the orifice itself.
export function hiddenMembranes(scene: Scene): Membrane[] {
  const runs: [Vector, Vector][][] = [[]]
  for (const { anterior_mm, posterior_mm, width_mm } of scene.gap) {
    const pair: [Vector, Vector] = [anterior_mm as Vector, posterior_mm as Vector]
    if (width_mm > 0 && !isInOrifice(scene, blend(...pair, 0.5))) runs.at(-1)?.push(pair)
    else runs.push([])
  }
  return runs.filter((pairs) => pairs.length > 1).map(between)
}

function between(pairs: [Vector, Vector][]): Membrane {
  const triangles = pairs.slice(1).flatMap((_, i) => [2 * i, 2 * i + 1, 2 * i + 2, 2 * i + 1, 2 * i + 3, 2 * i + 2])
  return { points: pairs.flat(2), triangles, label: null }
}

function middleOfPairs({ points }: Membrane): Vector {
  const pair = Math.floor(points.length / 6 / 2)
  return blend(at(points, 2 * pair), at(points, 2 * pair + 1), 0.5)
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

/// From the outline of a membrane into the tissue beside it, so that no slit of light stands between them.
export function skirt(scene: Scene, { points, triangles }: Membrane): Membrane {
  const edges = boundaryEdges(triangles)
  const upwards = Float32Array.from({ length: points.length }, (_, i) => scene.plane.normal[i % 3] as number)
  const away = outwards(edges, points, upwards)
  const reached = edges.map((ends) =>
    ends.map((vertex) => plus(at(points, vertex), times(0.5 * scene.thickness_mm, at(away, vertex)))),
  )
  return {
    points: edges.flatMap(([a, b], i) => [...at(points, a), ...at(points, b), ...(reached[i] as Vector[]).flat()]),
    triangles: edges.flatMap((_, i) => [0, 1, 2, 1, 3, 2].map((corner) => 4 * i + corner)),
    label: null,
  }
}

function middle(contour: number[]): Vector {
  let mean: Vector = [0, 0, 0]
  for (const [i, point] of vectors(contour).entries()) mean = blend(mean, point, 1 / (i + 1))
  return mean
}

function vectors(points: number[]): Vector[] {
  return Array.from({ length: points.length / 3 }, (_, i) => at(points, i))
}

export class Opening {
  readonly group = new Group()
  readonly labels: OpeningLabel[]
  readonly membranes_mm: Vector[][] // their points
  private readonly outline = new Lines({ width: 2, colour: TINTS.opening, inFront: true })

  /// `materials`: openingMaterials(), the same for all closures of a view.
  constructor(
    scene: Scene,
    private readonly materials: OpeningMaterials,
  ) {
    const shown = orificeMembranes(scene)
    const hidden = hiddenMembranes(scene)
    const membranes = [...shown, ...hidden]
    this.labels = membranes.flatMap(({ label }) => label ?? [])
    const gap_mm2 = scene.closure.coaptation?.gap_area_mm2 ?? 0
    const widest = hidden.sort((a, b) => b.points.length - a.points.length)[0]
    if (widest && gap_mm2 >= LEAST_NAMED_MM2)
      this.labels.push({
        point_mm: middleOfPairs(widest),
        text: `gap ${knownDigits(gap_mm2, scene.closure.coaptation?.gap_area_mm2_error)} mm²`,
      })
    this.membranes_mm = membranes.map(({ points }) => vectors(points))
    for (const membrane of membranes) this.add(membrane, [materials.seen, materials.throughTissue])
    for (const membrane of shown) this.add(skirt(scene, membrane), [materials.seen])
    this.outline.set(
      membranes.flatMap(({ points, triangles }) =>
        boundaryEdges(triangles).flatMap(([a, b]) => [...at(points, a), ...at(points, b)]),
      ),
    )
    this.group.add(this.outline.object)
  }

  private add({ points, triangles }: Membrane, materials: MeshBasicMaterial[]): void {
    const geometry = new BufferGeometry()
    geometry.setAttribute('position', new BufferAttribute(Float32Array.from(points), 3))
    geometry.setIndex(triangles)
    for (const material of materials) {
      const mesh = new Mesh(geometry, material)
      mesh.renderOrder = 2
      this.group.add(mesh)
    }
  }

  cut(planes: Plane[]): void {
    for (const material of Object.values(this.materials)) material.clippingPlanes = planes
    this.outline.cut(planes)
  }

  dispose(): void {
    for (const child of this.group.children) if (child instanceof Mesh) (child.geometry as BufferGeometry).dispose()
    this.outline.dispose()
  }
}

export interface OpeningMaterials {
  seen: MeshBasicMaterial
  throughTissue: MeshBasicMaterial
}

export function openingMaterials(): OpeningMaterials {
  const behind = { depthFunc: GreaterDepth, depthWrite: false, transparent: true, opacity: 0.5 }
  return {
    seen: new MeshBasicMaterial({ color: TINTS.opening, side: DoubleSide }),
    throughTissue: new MeshBasicMaterial({ color: TINTS.opening, side: DoubleSide, ...behind }),
  }
}
