// The surface whose area is the leak of a closed valve, or the opening of one that stands open: solid where nothing is
// before it, seen through tissue with its outline drawn over everything. The wider it is the darker.
import {
  BufferAttribute,
  BufferGeometry,
  DoubleSide,
  GreaterDepth,
  Group,
  Mesh,
  MeshBasicMaterial,
  type Plane,
} from 'three'
import type { Leak, LeakSurfaces, Opening, Scene, Vector } from '../api/types'
import { cm2, knownDigits } from '../format'
import { colourOf, OPEN, TINTS, toLinear } from './colours'
import { gapWidths } from './gap_width'
import { at, closedLine } from './geometry'
import type { Label } from './labels'
import { Lines } from './lines'

export const LEAST_NAMED_MM2 = 0.5 // smaller openings are drawn without a label

const LEAST_NAMED_OPEN_MM2 = 5 // less is no tenth of a cm²

/// At each opening of a closed valve, its area to the digits that are known of the leak.
export function leakLabels({ closure: { leak } }: Scene): Label[] {
  return named(leak, LEAST_NAMED_MM2, (area_mm2) => `${knownDigits(area_mm2, leak.error_mm2)} mm²`)
}

export function openingLabels({ leak }: Opening): Label[] {
  return named(leak, LEAST_NAMED_OPEN_MM2, cm2)
}

function named({ openings }: Leak, least_mm2: number, words: (area_mm2: number) => string): Label[] {
  return openings
    .filter(({ area_mm2 }) => area_mm2 >= least_mm2)
    .map(({ area_mm2, centroid_mm }) => ({ point_mm: centroid_mm, text: words(area_mm2), kind: 'leak' }))
}

export class LeakMeshes {
  readonly group = new Group()
  outlines_mm: Vector[][] = []
  private shown: LeakSurfaces | null = null
  private meshes: Mesh[] = []
  // Kept: a new one would have its program compiled again.
  private readonly materials = [
    new MeshBasicMaterial({ vertexColors: true, side: DoubleSide }),
    new MeshBasicMaterial({
      vertexColors: true,
      side: DoubleSide,
      depthFunc: GreaterDepth,
      depthWrite: false,
      transparent: true,
      opacity: 0.5,
    }),
  ]
  private readonly outline = new Lines({ width: 2, colour: TINTS.opening, inFront: true })

  constructor() {
    this.group.add(this.outline.object)
  }

  show(surfaces: LeakSurfaces): void {
    if (surfaces === this.shown) return
    this.shown = surfaces
    for (const mesh of this.meshes) mesh.geometry.dispose()
    this.group.remove(...this.meshes)
    this.meshes = surfaces.flatMap((surface) => this.meshesOf(surface))
    if (this.meshes.length > 0) this.group.add(...this.meshes)
    this.outlines_mm = surfaces.map(({ points_mm, outline }) => outline.map((i) => at(points_mm, i)))
    this.outline.set(this.outlines_mm.flatMap(closedLine))
  }

  cut(planes: Plane[]): void {
    for (const material of this.materials) material.clippingPlanes = planes
    this.outline.cut(planes)
  }

  private meshesOf(surface: LeakSurfaces[number]): Mesh[] {
    const { points_mm, faces } = surface
    const geometry = new BufferGeometry()
    geometry.setAttribute('position', new BufferAttribute(Float32Array.from(points_mm), 3))
    const colours = gapWidths(surface).flatMap((width_mm) => colourOf(OPEN, width_mm).map(toLinear))
    geometry.setAttribute('color', new BufferAttribute(Float32Array.from(colours), 3))
    geometry.setIndex(faces)
    return this.materials.map((material) => {
      const mesh = new Mesh(geometry, material)
      mesh.renderOrder = 2
      return mesh
    })
  }
}
