// Words beside the pointer: what the picture shows there.
import type { Scene, Vector } from '../api/types'
import { h } from '../dom'
import { number, withUnit } from '../format'
import { vertexValues, type ColourMode, type Scale } from './colours'
import type { Pick } from './pick'
import viewerStyle from './viewer.module.css'

const OFFSET_PX = 14 // from the pointer

export class Readout {
  readonly element: HTMLElement

  constructor(part: string) {
    this.element = h('output', { class: viewerStyle.readout, 'data-part': part, hidden: true })
  }

  /// Beside `at`, on the side that has room in a stage of this size.
  show(text: string, at: { x: number; y: number }, stage: { width: number; height: number }): void {
    this.element.textContent = text
    this.element.hidden = false
    const { offsetWidth, offsetHeight } = this.element
    const beside = (place: number, size: number, most: number): number =>
      Math.max(place + OFFSET_PX + size > most ? place - OFFSET_PX - size : place + OFFSET_PX, 0)
    const [x, y] = [beside(at.x, offsetWidth, stage.width), beside(at.y, offsetHeight, stage.height)]
    this.element.style.transform = `translate(${x}px, ${y}px)`
  }

  hide(): void {
    this.element.hidden = true
  }
}

/// `scale`: of the mode; without one a leaflet tells its segment and height alone.
export function reading(
  scene: Scene,
  nodes: ArrayLike<number>,
  mode: ColourMode,
  scale: Scale | null,
  pick: Pick,
): string {
  if (pick.kind === 'chorda') return chordaReading(scene, pick.id)
  if (pick.kind !== 'leaflet') return ''
  const segment = scene.segments[pick.face] ?? ''
  const values = vertexValues(scene, mode, nodes)
  if (values && scale) {
    const value = onCorners(scene, values, pick.face, pick.weights)
    return `${segment}: ${withUnit(value, scale.unit, scale.unit === '%' ? 0 : 1)}`
  }
  const height = onCorners(scene, vertexValues(scene, 'height', nodes) ?? [], pick.face, pick.weights)
  return `${segment}: ${number(Math.abs(height))} mm ${height < 0 ? 'below' : 'above'} the annular plane`
}

function chordaReading(scene: Scene, id: string): string {
  const chorda = scene.chordae.find((other) => other.id === id)
  if (!chorda) return ''
  if (chorda.ruptured) return `${id}: ruptured`
  return `${id}: ${withUnit(Math.max(...chorda.segments.map(({ tension_n }) => tension_n ?? 0)), 'N', 2)}`
}

function onCorners(scene: Scene, values: number[], face: number, weights: Vector): number {
  return weights.reduce((sum, weight, k) => sum + weight * (values[scene.faces[3 * face + k] as number] ?? NaN), 0)
}
