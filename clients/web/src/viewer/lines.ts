// Lines of a width in pixels or millimetres: chordae, sutures, the cut, outlines.
import type { InterleavedBufferAttribute, Plane } from 'three'
import { LineMaterial } from 'three/examples/jsm/lines/LineMaterial.js'
import { LineSegments2 } from 'three/examples/jsm/lines/LineSegments2.js'
import { LineSegmentsGeometry } from 'three/examples/jsm/lines/LineSegmentsGeometry.js'
import { rgb, toLinear } from './colours'

export interface LineStyle {
  width: number // in pixels
  inMillimetres?: boolean // its width
  colour?: string // hex; left out: each end has its own
  dashed?: boolean
  inFront?: boolean // of everything
}

export class Lines {
  readonly object: LineSegments2
  private readonly material: LineMaterial
  private count = -1

  constructor(style: LineStyle) {
    this.material = new LineMaterial({
      linewidth: style.width,
      worldUnits: style.inMillimetres ?? false,
      vertexColors: style.colour === undefined,
      dashed: style.dashed ?? false,
      dashSize: 1.2,
      gapSize: 0.8,
      depthTest: !(style.inFront ?? false),
      transparent: style.inFront ?? false,
    })
    if (style.colour !== undefined) this.material.color.setRGB(...rgb(style.colour), 'srgb')
    this.object = new LineSegments2(new LineSegmentsGeometry(), this.material)
    this.object.frustumCulled = false
    this.object.visible = false
    if (style.inFront) this.object.renderOrder = 3
  }

  /// Six numbers a line; with `colours` as many.
  set(points: number[], colours?: number[]): void {
    this.object.visible = points.length > 0
    if (points.length === 0) return
    // Its buffers cannot grow.
    if (points.length !== this.count) {
      this.object.geometry.dispose()
      this.object.geometry = new LineSegmentsGeometry()
      this.object.geometry.setPositions(points)
      if (colours) this.object.geometry.setColors(colours.map(toLinear))
      this.count = points.length
    } else {
      this.refill('instanceStart', points)
      if (colours) this.refill('instanceColorStart', colours.map(toLinear))
    }
    if (this.material.dashed) this.object.computeLineDistances()
  }

  /// In place: what moves does not get new buffers for each picture.
  private refill(name: string, numbers: number[]): void {
    const { data } = this.object.geometry.getAttribute(name) as InterleavedBufferAttribute
    data.set(numbers)
    data.needsUpdate = true
  }

  set width(width: number) {
    this.material.linewidth = width
  }

  cut(planes: Plane[]): void {
    this.material.clippingPlanes = planes
  }

  dispose(): void {
    this.object.geometry.dispose()
    this.material.dispose()
  }
}
