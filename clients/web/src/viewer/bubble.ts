// A surface around a handle, coloured by the leak if what is grabbed ends there.
import { BufferAttribute, BufferGeometry, DoubleSide, Mesh, MeshBasicMaterial } from 'three'
import type { Vector } from '../api/types'
import { colourOf, type Scale, toLinear } from './colours'

/// Rows of points, each as long as the others; null: there is nothing.
export interface BubbleSurface {
  rows: (Vector | null)[][]
  values: (number | null)[][] // of the scale
  scale: Scale
}

export class Bubble {
  readonly mesh = new Mesh(
    new BufferGeometry(),
    new MeshBasicMaterial({
      vertexColors: true,
      side: DoubleSide,
      transparent: true,
      opacity: 0.85,
      depthTest: false, // tissue may lie before it
      depthWrite: false,
    }),
  )

  constructor() {
    this.mesh.renderOrder = 3
    this.mesh.visible = false
  }

  set(surface: BubbleSurface | null): void {
    this.mesh.visible = surface !== null
    if (!surface) return
    const { rows, values, scale } = surface
    const across = rows[0]?.length ?? 0
    const is = (row: number, column: number): boolean => rows[row]?.[column] != null && values[row]?.[column] != null
    const points = rows.flatMap((row) => row.flatMap((point) => point ?? [0, 0, 0]))
    const colours = values.flatMap((row) =>
      row.flatMap((value) => (value === null ? [0, 0, 0] : colourOf(scale, value).map(toLinear))),
    )
    const faces: number[] = []
    for (let row = 0; row + 1 < rows.length; ++row)
      for (let column = 0; column + 1 < across; ++column) {
        const at = (down: number, right: number): number => (row + down) * across + column + right
        const has = (down: number, right: number): boolean => is(row + down, column + right)
        if (has(0, 0) && has(0, 1) && has(1, 1)) faces.push(at(0, 0), at(0, 1), at(1, 1))
        if (has(0, 0) && has(1, 1) && has(1, 0)) faces.push(at(0, 0), at(1, 1), at(1, 0))
      }
    this.mesh.geometry.dispose()
    this.mesh.geometry = new BufferGeometry()
    this.mesh.geometry.setAttribute('position', new BufferAttribute(Float32Array.from(points), 3))
    this.mesh.geometry.setAttribute('color', new BufferAttribute(Float32Array.from(colours), 3))
    this.mesh.geometry.setIndex(faces)
  }
}
