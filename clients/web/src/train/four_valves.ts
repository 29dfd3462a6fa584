// The four closed valves of exam A, turned together; one of them can be chosen. Leaflets alone: chordae would tell the lesions.
import type { ValveShape, Vector } from '../api/types'
import { field, h } from '../dom'
import { EchoPanel } from '../echo/panel'
import { cutPoint } from '../live/drawing'
import { cornerColours, rgb } from '../viewer/colours'
import { at } from '../viewer/geometry'
import { Labels } from '../viewer/labels'
import { Leaflets } from '../viewer/leaflets'
import { TissueMaterial } from '../viewer/tissue_material'
import { namesAround } from '../viewer/marks'
import { viewButtons } from '../valve/looks'
import { Stage, type ViewName } from '../viewer/stage'
import parts from '../style/parts.module.css'
import viewerStyle from '../viewer/viewer.module.css'
import trainStyle from './train.module.css'
import type { SegmentName } from './types'

const PALE = rgb('#d9d2cd')
const CHOICES = [1, 2, 3, 4]

export class FourValves {
  readonly element: HTMLElement
  readonly echo = new EchoPanel(CHOICES.map((choice) => `Valve ${choice}`))
  onChoice: (choice: number) => void = () => {}
  private readonly stages: Stage[]
  private readonly radios: HTMLInputElement[]
  private readonly words: HTMLElement[]
  private readonly labels: Labels[]
  private scene: ValveShape | null = null
  private leaflets: Leaflets[] = []
  private closed_mm: readonly (readonly number[])[] = []
  private held: Vector[] = [] // vertices of all four
  private readonly cut = h('input', {
    type: 'range',
    min: -1,
    max: 1,
    step: 0.05,
    value: 0,
    oninput: () => this.tellEcho(),
  })

  constructor() {
    this.stages = CHOICES.map(
      (choice) => new Stage(`Closed valve ${choice}: drag, or arrow keys, to rotate all four; plus and minus zoom`),
    )
    const [first, ...others] = this.stages as [Stage, ...Stage[]]
    for (const other of others) first.pair(other)
    this.echo.element.append(field('Position of the cut', this.cut))
    this.radios = CHOICES.map((choice) =>
      h('input', { type: 'radio', name: 'closed-valve', value: choice, onchange: () => this.onChoice(choice) }),
    )
    this.words = CHOICES.map((choice) => h('span', {}, `Valve ${choice}`))
    this.labels = this.stages.map((stage) => new Labels(stage))
    const valves = this.stages.map((stage, i) =>
      h(
        'div',
        { class: trainStyle.choice },
        h('div', { class: viewerStyle.viewer }, stage.canvas, this.labels[i]?.element),
        h('label', { class: parts.check }, this.radios[i] as HTMLElement, this.words[i] as HTMLElement),
      ),
    )
    this.element = h(
      'div',
      { class: trainStyle.closed },
      h(
        'div',
        { class: viewerStyle.tools },
        viewButtons((view) => this.view(view)),
      ),
      h('div', { class: trainStyle.four, 'data-part': 'four-valves' }, ...valves),
    )
  }

  /// `closed_mm`: of each valve, in the order of the scene's vertices; the mesh is that of the scene.
  set(scene: ValveShape, closed_mm: readonly (readonly number[])[]): void {
    for (const [i, stage] of this.stages.entries()) {
      const before = this.leaflets[i]
      if (before) stage.scene.remove(before.mesh)
      before?.dispose()
      const leaflets = new Leaflets(scene, before?.mesh.material ?? new TissueMaterial())
      leaflets.move(Float32Array.from(closed_mm[i] ?? []))
      stage.add(leaflets.mesh)
      this.leaflets[i] = leaflets
    }
    this.held = closed_mm.flatMap((points) => Array.from({ length: points.length / 3 }, (_, i) => at(points, i)))
    this.closed_mm = closed_mm
    this.scene = scene
    this.cut.value = '0'
    this.tellEcho()
    this.mark(null)
    this.view('oblique')
  }

  private tellEcho(): void {
    const { scene, closed_mm } = this
    if (scene) this.echo.tell(scene, closed_mm, cutPoint(scene, Number(this.cut.value)), true)
  }

  /// One segment in its colour and with its name, the others pale; null: all as they are.
  mark(segment: SegmentName | null): void {
    const { scene } = this
    if (!scene) return
    const colours = cornerColours(scene, 'leaflets', null, scene.rest_mm)
    for (let corner = 0; segment !== null && corner < scene.faces.length; ++corner)
      if (scene.segments[Math.floor(corner / 3)] !== segment) colours.set(PALE, 3 * corner)
    for (const [i, stage] of this.stages.entries()) {
      this.leaflets[i]?.paint(colours)
      this.labels[i]?.set(namesAround(scene, (name) => (name === segment ? name : null)))
      stage.draw()
    }
  }

  view(name: ViewName): void {
    for (const stage of this.stages) stage.look(name, this.held)
  }

  /// Radio buttons are there while a choice is asked for.
  ask(isAsked: boolean): void {
    for (const radio of this.radios) {
      radio.hidden = !isAsked
      radio.disabled = false
      radio.checked = false
    }
    for (const [i, words] of this.words.entries()) words.textContent = `Valve ${i + 1}`
  }

  /// After the answer.
  tell(answer: number, choice: number): void {
    for (const [i, words] of this.words.entries()) {
      const radio = this.radios[i] as HTMLInputElement
      radio.disabled = true
      radio.checked = i + 1 === choice
      if (i + 1 === answer) words.textContent = `Valve ${i + 1}: the correct answer`
      else if (i + 1 === choice) words.textContent = `Valve ${i + 1}: your answer`
    }
  }
}
