// Words over the canvas at points of the scene.
import { Vector3 } from 'three'
import type { Vector } from '../api/types'
import { h } from '../dom'
import type { Stage } from './stage'
import viewerStyle from './viewer.module.css'

export interface Label {
  point_mm: Vector
  text: string
  kind: 'landmark' | 'tip' | 'segment' | 'orifice' | 'distance'
}

export class Labels {
  readonly element = h('div', { class: viewerStyle.labels, 'data-part': 'labels', 'aria-hidden': 'true' })
  private placed: { label: Label; node: HTMLElement }[] = []

  constructor(private readonly stage: Stage) {
    stage.onFrame.push(() => this.place())
  }

  set(labels: Label[]): void {
    this.placed = labels.map((label) => ({
      label,
      node: h('span', { class: viewerStyle[label.kind], 'data-part': label.kind }, label.text),
    }))
    this.element.replaceChildren(...this.placed.map(({ node }) => node))
    this.place()
  }

  private place(): void {
    // There the leaflets hide the tips.
    const fromAbove = this.stage.camera.getWorldDirection(new Vector3()).z < -0.8
    for (const { label, node } of this.placed) {
      const { x, y, depth } = this.stage.place(label.point_mm)
      node.hidden = depth > 1 || (label.kind === 'tip' && fromAbove)
      node.style.transform = `translate(-50%, -50%) translate(${x.toFixed(1)}px, ${y.toFixed(1)}px)`
    }
  }
}
