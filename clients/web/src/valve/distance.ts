// Measures straight distances between points that are clicked.
import { h } from '../dom'
import { withUnit } from '../format'
import { iconButton } from '../icons'
import type { Vector } from '../api/types'
import { blend, distance } from '../viewer/geometry'
import type { Label } from '../viewer/labels'
import type { Pick, PickKind } from '../viewer/pick'
import parts from '../style/parts.module.css'

/// Of a viewer, what is used here.
export interface Measured {
  picks: PickKind[]
  onPick: ((pick: Pick) => void) | null
  mark(labels: Label[]): void
  draw(points: number[]): void
  placeOf?(pick: Pick): Vector // of a valve that moves
}

export class DistanceTool {
  readonly element: HTMLElement
  private readonly toggle: HTMLButtonElement
  private readonly said = h('output', { class: parts.hint })
  private first: Pick | null = null
  private ends: [Pick, Pick] | null = null

  constructor(private readonly viewer: Measured) {
    this.toggle = iconButton('distance', 'Measure a distance', () => this.switch(), { 'aria-pressed': 'false' })
    this.element = h('div', { class: parts.row }, this.toggle, this.said)
  }

  private switch(): void {
    const on = this.toggle.getAttribute('aria-pressed') !== 'true'
    this.toggle.setAttribute('aria-pressed', String(on))
    this.viewer.picks = on ? ['head', 'annulus', 'leaflet'] : []
    this.viewer.onPick = on ? (pick) => this.take(pick) : null
    this.clear()
  }

  /// Of another state of the valve nothing is measured.
  clear(): void {
    this.first = this.ends = null
    this.said.textContent = this.viewer.onPick ? 'Click two points on leaflets, annulus or papillary tips.' : ''
    this.viewer.mark([])
    this.viewer.draw([])
  }

  private take(pick: Pick): void {
    if (this.first === null) {
      this.clear()
      this.first = pick
      this.said.textContent = 'Now click the second point.'
      return
    }
    this.ends = [this.first, pick]
    this.first = null
    this.update()
  }

  /// Between the two points as they are now.
  update(): void {
    if (!this.ends) return
    const [a, b] = this.ends.map((pick) => this.viewer.placeOf?.(pick) ?? pick.point_mm) as [Vector, Vector]
    const text = withUnit(distance(a, b), 'mm')
    this.viewer.draw([...a, ...b])
    this.viewer.mark([{ point_mm: blend(a, b, 0.5), text, kind: 'distance' }])
    this.said.textContent = `${text} in a straight line. Click again to start over.`
  }
}
