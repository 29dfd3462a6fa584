// A valve as it is: opened, closing, measured, cut.
import type { Scene } from '../api/types'
import { h } from '../dom'
import { closureSaver } from '../files'
import { HAS_SERVICE } from '../mode'
import type { Figure } from '../picture/figure'
import { figureLines, pictureSaver } from '../picture/saver'
import { storyList } from '../story/offer'
import type { Slide } from '../story/types'
import type { Command, View } from '../view'
import { kindsOn, legend } from '../viewer/legend'
import { Viewer } from '../viewer/viewer'
import type { Sight } from '../viewer/stage'
import type { Workspace } from '../workspace'
import { certainty } from './certainty'
import { howSure } from './how_sure'
import { DistanceTool } from './distance'
import { Diastole } from './diastole'
import { diagnosisLine, headline } from './headline'
import { heartsPanel } from './hearts'
import { importStage } from './import_stage'
import { Looks } from './looks'
import { measures } from './measures'
import { openPanel } from './open'
import { sectionInset } from './section_inset'
import { TissueError } from './tissue_error'
import parts from '../style/parts.module.css'
import valveStyle from './valve.module.css'
import viewerStyle from '../viewer/viewer.module.css'

const FRAMES = 40 // of the opening
const FIRST = 'first valve' // drawn: a mark for who measures the page

export class ValveView implements View {
  readonly element: HTMLElement
  private readonly viewer = new Viewer('The valve in three dimensions; arrow keys turn it, plus and minus zoom')
  private readonly looks = new Looks(true)
  private readonly distance = new DistanceTool(this.viewer)
  private readonly legend = h('div', {})
  private readonly inset = h('div', { class: valveStyle.inset, hidden: true })
  private readonly headline = h('div', {})
  private readonly tissue = new TissueError(() => this.tell())
  private readonly diastole = new Diastole()
  private readonly measures = h('div', {})
  private share = 1 // of the closing, as it is drawn

  constructor(private readonly workspace: Workspace) {
    const told = h('div', {})
    const importing = importStage(workspace, (isShown) => this.stepAside(isShown))
    const opening = openPanel(workspace, importing)
    this.viewer.inset = this.inset
    this.looks.onChange = () => this.draw()
    this.looks.onView = (view) => importing.view(view) || this.viewer.view(view)
    this.element = h(
      'div',
      { class: parts.sides },
      h(
        'div',
        { class: viewerStyle.stage },
        h('h1', { class: parts.unseen }, 'Valve'),
        h(
          'div',
          { class: viewerStyle.tools },
          this.looks.views,
          this.distance.element,
          closureSaver(workspace, false, told).element,
          pictureSaver((width_px) => this.figure(width_px), told),
        ),
        this.headline,
        told,
        h('div', { class: viewerStyle.stageBody }, this.viewer.element, this.inset, importing.element),
        this.legend,
      ),
      h(
        'div',
        { class: parts.side },
        opening.element,
        h(
          'section',
          { class: parts.panel },
          h('h2', {}, 'Measured'),
          this.diastole.element,
          certainty(workspace, false),
          howSure(workspace),
          this.measures,
        ),
        this.looks.element,
        storyList(),
        HAS_SERVICE && heartsPanel(workspace), // last: its table is long
      ),
    )
    opening.dropOn(this.element)
    workspace.subscribe(() => this.take())
  }

  show(): void {
    this.take()
  }
  hide(): void {}

  settings(): Command[] {
    return this.looks.settings()
  }

  perform({ camera, ...shown }: Slide): void {
    this.looks.ask(shown)
    if (camera) this.viewer.view(camera)
  }
  get sight(): Sight | null {
    return this.viewer.sight
  }

  /// While files are imported they stand where the valve does else.
  private stepAside(isAside: boolean): void {
    this.viewer.element.hidden = isAside
    this.legend.hidden = isAside
    this.headline.hidden = isAside
    this.diastole.element.hidden = isAside
    this.draw()
    if (isAside) this.inset.hidden = true
  }

  private take(): void {
    const { before } = this.workspace
    if (!before || !this.element.isConnected) return
    if (this.viewer.shown !== before) {
      this.viewer.set(before, this.looks.look([before]))
      this.distance.clear()
      this.viewer.stage.drawNow()
      if (performance.getEntriesByName(FIRST).length === 0) performance.mark(FIRST)
      this.tell()
      this.measures.replaceChildren(measures(before, null))
      void this.openUp(before)
    }
    this.draw()
  }

  private tell(): void {
    const { before, valve } = this.workspace
    if (!before) return
    const drawn = this.tissue.of(before, valve?.reference, null)
    this.headline.replaceChildren(headline(before, null, drawn, diagnosisLine(before)))
  }

  /// After the closed valve, which does not wait for it. A valve that cannot be opened has a closing alone.
  private async openUp(before: Scene): Promise<void> {
    const reference = this.workspace.valve?.reference
    this.looks.motion?.setOpening(null)
    if (reference === undefined) return
    const opening = await this.diastole.ask(before, reference, null, FRAMES)
    if (!opening || this.viewer.shown !== before) return
    this.viewer.setOpen(opening)
    this.looks.motion?.setOpening(opening)
    this.draw()
  }

  private draw(): void {
    const { before } = this.workspace
    if (!before || this.viewer.shown !== before) return
    const look = this.looks.look([before])
    if (look.share !== this.share) {
      this.share = look.share
      this.distance.clear()
    }
    this.viewer.show(look)
    this.legend.replaceChildren(legend(look.mode, look.scale, kindsOn([before])))
    this.inset.replaceChildren(...(look.cut === null ? [] : [sectionInset(before, look.cut)]))
    this.inset.hidden = look.cut === null
  }

  private figure(width_px: number): Figure {
    const { before, valve, plan } = this.workspace
    if (!before) throw new Error('No valve is open.')
    const { scale } = this.looks.look([before])
    const lines = figureLines(before, null, plan)
    return {
      name: valve?.label ?? 'valve',
      lines,
      shots: [{ title: '', shot: this.viewer.shot(width_px) }],
      scale,
      kinds: kindsOn([before]),
    }
  }
}
