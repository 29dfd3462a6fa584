// A valve as it is: opened, closing, measured, cut.
import '../style/viewer.css'
import { button, download, h } from '../dom'
import { closureSaver } from '../files'
import type { View } from '../view'
import { legend } from '../viewer/legend'
import { Viewer } from '../viewer/viewer'
import type { Workspace } from '../workspace'
import { DistanceTool } from './distance'
import { Looks } from './looks'
import { measures } from './measures'
import { openPanel } from './open'
import { sectionInset } from './section_inset'

const FIRST = 'first valve' // drawn: a mark for who measures the page

export class ValveView implements View {
  readonly element: HTMLElement
  private readonly viewer = new Viewer('The valve in three dimensions; arrow keys turn it, plus and minus zoom')
  private readonly looks = new Looks(true)
  private readonly distance = new DistanceTool(this.viewer)
  private readonly legend = h('div', {})
  private readonly inset = h('div', { class: 'inset' })
  private readonly measures = h('div', {})
  private share = 1 // of the closing, as it is drawn

  constructor(private readonly workspace: Workspace) {
    const told = h('div', {})
    this.looks.onChange = () => this.draw()
    this.looks.onView = (view) => this.viewer.view(view)
    this.distance.onResult = () => this.draw()
    this.element = h(
      'div',
      { class: 'sides' },
      h(
        'div',
        {},
        openPanel(workspace),
        this.looks.element,
        h('section', { class: 'panel' }, h('h2', {}, 'Measured'), this.measures),
      ),
      h(
        'div',
        { class: 'stage' },
        h('h1', { class: 'unseen' }, 'Valve'),
        h('div', { class: 'row' }, this.looks.views, this.distance.element, closureSaver(workspace, false, told).element, button('Save picture', () => this.savePicture(), { class: 'quiet' })),
        told,
        h('div', { class: 'stage-body' }, this.viewer.element, this.inset),
        this.legend,
      ),
    )
    workspace.subscribe(() => this.take())
  }

  show(): void {
    this.take()
  }
  hide(): void {}

  private take(): void {
    const { before } = this.workspace
    if (!before || !this.element.isConnected) return
    if (this.viewer.shown !== before) {
      this.viewer.set(before, this.looks.look([before]))
      this.distance.clear()
      this.viewer.stage.drawNow()
      if (performance.getEntriesByName(FIRST).length === 0) performance.mark(FIRST)
      this.measures.replaceChildren(measures(before, null))
    }
    this.draw()
  }

  private draw(): void {
    const { before } = this.workspace
    if (!before || this.viewer.shown !== before) return
    const look = this.looks.look([before])
    if (look.share !== this.share) {
      this.share = look.share
      return this.distance.clear() // and draws
    }
    this.viewer.show(look)
    this.legend.replaceChildren(legend(look.mode, look.scale))
    this.inset.replaceChildren(...(look.cut === null ? [] : [sectionInset(before, look.cut)]))
    this.inset.hidden = look.cut === null
  }

  private savePicture(): void {
    this.viewer.stage.drawNow()
    this.viewer.stage.canvas.toBlob((blob) => blob && download(`${this.workspace.valve?.label ?? 'valve'}.png`, blob))
  }
}
