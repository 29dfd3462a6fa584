// Words over the canvas at points of the scene. They avoid each other and the leak; one that stands beside its place
// has a line to it.
import type { Vector } from '../api/types'
import { h, svg } from '../dom'
import { type Box, layOut, type Spot } from './label_layout'
import type { Pick } from './pick'
import type { Stage } from './stage'
import viewerStyle from './viewer.module.css'

export interface Label {
  point_mm: Vector // where the word is best
  names_mm?: Vector // what it names, if that is elsewhere
  text: string
  kind: 'landmark' | 'tip' | 'segment' | 'leak' | 'distance' | 'neighbour' | 'hour'
}

/// The most important first; pixels that a word may be moved.
const KINDS: Record<Label['kind'], { rank: number; reach: number }> = {
  distance: { rank: 0, reach: 160 },
  leak: { rank: 1, reach: 160 },
  segment: { rank: 2, reach: 80 },
  neighbour: { rank: 2, reach: 30 },
  hour: { rank: 3, reach: 0 },
  landmark: { rank: 3, reach: 50 },
  tip: { rank: 4, reach: 50 },
}

/// As it is seen, in pixels of the canvas: its middle and its size; `to`: the end of its line.
export interface DrawnLabel extends Spot {
  text: string
  kind: Label['kind']
  width: number
  height: number
  to: { x: number; y: number } | null
}

interface Placed {
  label: Label
  node: HTMLElement
  line: SVGLineElement
  size: { width: number; height: number } | null // not measured yet
  spot: Spot | null // left out
}

export class Labels {
  readonly element = h('div', { class: viewerStyle.labels, 'data-part': 'labels', 'aria-hidden': 'true' })
  avoid: () => Box[] = () => [] // what words may not cover
  isBehind: (point_mm: Vector) => boolean = () => false // tissue
  private placed: Placed[] = []
  private width = 0 // of the stage, as the words were measured

  constructor(private readonly stage: Stage) {
    stage.onFrame.push(() => this.place())
  }

  /// Placed, and seen, when the stage draws next.
  set(labels: Label[]): void {
    this.placed = labels.map((label) => ({
      label,
      node: h('span', { class: viewerStyle[label.kind], 'data-part': label.kind }, label.text),
      line: svg('line'),
      size: null,
      spot: null,
    }))
    for (const { node, line } of this.placed) node.style.visibility = line.style.visibility = 'hidden'
    const lines = svg('svg', {}, ...this.placed.map(({ line }) => line))
    this.element.replaceChildren(lines, ...this.placed.map(({ node }) => node))
  }

  /// The papillary head whose name lies under the pointer.
  headAt(event: MouseEvent): Pick | null {
    const box = this.element.getBoundingClientRect()
    const [x, y] = [event.clientX - box.left, event.clientY - box.top]
    const found = this.placed.find(
      ({ label, size, spot }) =>
        label.kind === 'tip' &&
        size &&
        spot &&
        Math.abs(spot.x - x) < size.width / 2 &&
        Math.abs(spot.y - y) < size.height / 2,
    )
    return found ? { kind: 'head', id: found.label.text, point_mm: found.label.point_mm } : null
  }

  drawn(): DrawnLabel[] {
    return this.placed.flatMap(({ label, size, spot }) => {
      if (!size || !spot) return []
      const to = spot.isMoved ? this.stage.place(label.names_mm ?? label.point_mm) : null
      return { ...spot, ...size, text: label.text, kind: label.kind, to }
    })
  }

  private place(): void {
    const { x: width, y: height } = this.stage.size
    if (width !== this.width) for (const placed of this.placed) placed.size = null // letters may have another size, too
    this.width = width
    const shown = this.placed.filter((placed) => this.isSeen(placed))
    const words = shown.map((placed) => {
      const { x, y } = this.stage.place(placed.label.point_mm)
      placed.size ??= measured(placed.node)
      return { x, y, ...(placed.size ?? { width: 0, height: 0 }), ...KINDS[placed.label.kind] }
    })
    const spots = new Map(layOut(words, this.avoid(), { width, height }).map((spot, i) => [shown[i], spot]))
    for (const placed of this.placed) this.move(placed, spots.get(placed) ?? null)
  }

  private isSeen({ label }: Placed): boolean {
    const { depth } = this.stage.place(label.point_mm)
    if (depth > 1) return false
    // From above the leaflets hide the tips; from elsewhere there is no clock.
    if (label.kind === 'tip') return !this.stage.isFromAbove
    if (label.kind === 'neighbour' || label.kind === 'hour') return this.stage.isFromAbove
    return label.kind !== 'segment' || !this.isBehind(label.point_mm)
  }

  private move(placed: Placed, spot: Spot | null): void {
    const { label, node, line } = placed
    placed.spot = spot
    node.style.visibility = spot ? '' : 'hidden'
    line.style.visibility = spot?.isMoved ? '' : 'hidden'
    if (!spot) return
    node.style.transform = `translate(-50%, -50%) translate(${spot.x.toFixed(1)}px, ${spot.y.toFixed(1)}px)`
    const to = this.stage.place(label.names_mm ?? label.point_mm)
    for (const [name, value] of Object.entries({ x1: spot.x, y1: spot.y, x2: to.x, y2: to.y }))
      line.setAttribute(name, value.toFixed(1))
  }
}

/// Null while the view is not in the page.
function measured(node: HTMLElement): { width: number; height: number } | null {
  return node.offsetWidth === 0 ? null : { width: node.offsetWidth, height: node.offsetHeight }
}
