// What every part of the trainer has: a stage with a sentence above it, and panels beside it.
import { h } from '../dom'
import parts from '../style/parts.module.css'
import viewerStyle from '../viewer/viewer.module.css'
import trainStyle from './train.module.css'

export class Frame {
  readonly element: HTMLElement
  private readonly title = h('h2', { tabindex: -1 })
  private readonly sentence = h('p', { role: 'status', 'data-part': 'train-task' })
  private readonly body = h('div', { class: viewerStyle.stageBody })
  private readonly side = h('div', { class: parts.side })

  constructor() {
    const words = h('div', { class: trainStyle.task }, this.title, this.sentence)
    this.element = h('div', { class: parts.sides }, h('div', { class: viewerStyle.stage }, words, this.body), this.side)
  }

  show(title: string, sentence: string, body: HTMLElement, panels: HTMLElement[]): void {
    this.title.textContent = title
    this.sentence.textContent = sentence
    this.body.replaceChildren(body)
    this.side.replaceChildren(...panels)
    this.side.scrollTop = 0
    this.title.focus({ preventScroll: true }) // a screen reader goes on here
  }

  say(sentence: string): void {
    this.sentence.textContent = sentence
  }
}

export function panel(title: string, ...children: (HTMLElement | string)[]): HTMLElement {
  return h('section', { class: parts.panel, 'aria-label': title }, h('h2', {}, title), ...children)
}
