// A valve in three dimensions: leaflets, chordae, annulus, orifices, a cut, names.
import { Plane, Vector3 } from 'three'
import type { Scene, Vector } from '../api/types'
import { h } from '../dom'
import { chordaColours, cornerColours, type ColourMode, type Scale } from './colours'
import { at, boundaryEdges, chordaLines, closedNodes, dot, minus, nodesAt, section } from './geometry'
import { Labels, type Label } from './labels'
import { leafletMaterial, Leaflets } from './leaflets'
import { Lines, pieces } from './lines'
import { namedAnnulus, namesOf, wholeValve } from './marks'
import { openingMaterials, Opening } from './opening'
import { pickAt, type Pick, type PickKind } from './pick'
import { Stage, type ViewName } from './stage'
import viewerStyle from './viewer.module.css'

const TURNED_PX = 4 // a pointer that moved so far has turned the valve, not clicked it

export interface Look {
  mode: ColourMode
  scale: Scale | null
  share: number // of the closing: 0 open, 1 closed
  orifices: boolean
  names: boolean
  cut: number | null // index into Scene.sections
}

export class Viewer {
  readonly element: HTMLElement
  readonly stage: Stage
  onPick: ((pick: Pick) => void) | null = null
  picks: PickKind[] = [] // what a click may mean
  extra: Label[] = [] // words besides the names
  private scene: Scene | null = null
  private nodes: Float32Array = new Float32Array()
  private leaflets: Leaflets | null = null
  private opening: Opening | null = null
  // Kept: a new one would have its program compiled again.
  private readonly materials = { leaflets: leafletMaterial(), opening: openingMaterials() }
  private edges: [number, number][] = []
  private pressed: [number, number] = [0, 0] // where on the screen
  private drawn = '' // the look of the scene that is drawn
  private readonly labels: Labels
  private readonly lines = {
    chordae: new Lines({ pixels: 1.6 }),
    ruptured: new Lines({ pixels: 1.6, colour: '#c8342b', dashed: true }),
    edges: new Lines({ pixels: 1.4, colour: '#5b3a3a' }),
    annulus: new Lines({ pixels: 4, colour: '#8a8f98' }),
    sutures: new Lines({ pixels: 3, colour: '#0f8a5f' }),
    cut: new Lines({ pixels: 3.5 }),
    drawn: new Lines({ pixels: 2.5, colour: '#d6336c', inFront: true }),
  }

  constructor(label: string) {
    this.stage = new Stage(label)
    this.labels = new Labels(this.stage)
    this.element = h(
      'div',
      { class: viewerStyle.viewer, 'data-part': 'viewer' },
      this.stage.canvas,
      this.labels.element,
    )
    this.stage.add(...Object.values(this.lines).map((line) => line.object))
    this.stage.onFrame.push(() => {
      for (const line of Object.values(this.lines)) line.resolution(this.stage.size)
    })
    this.stage.canvas.addEventListener('pointerdown', ({ clientX, clientY }) => (this.pressed = [clientX, clientY]))
    this.stage.canvas.addEventListener('click', (event) => this.click(event))
  }

  /// Another valve or another closure. `ring`: whether the annulus carries one.
  set(scene: Scene, look: Look, ring = false): void {
    const first = this.scene === null
    this.scene = scene
    this.leaflets?.dispose()
    this.opening?.dispose()
    if (this.leaflets) this.stage.scene.remove(this.leaflets.mesh)
    if (this.opening) this.stage.scene.remove(this.opening.group)
    this.leaflets = new Leaflets(scene, this.materials.leaflets)
    this.opening = new Opening(scene, this.materials.opening)
    this.edges = boundaryEdges(scene.faces)
    this.drawn = ''
    this.stage.add(this.leaflets.mesh, this.opening.group)
    this.lines.annulus.set(pieces(scene.annulus_mm, true))
    this.lines.annulus.object.visible = ring
    this.lines.sutures.set(scene.sutures.flatMap((suture) => [...suture.tip_mm, ...suture.anchor_mm]))
    this.show(look)
    if (first) this.view('atrial')
  }

  show(look: Look): void {
    const { scene, leaflets, opening, lines } = this
    const asked = JSON.stringify([look, this.extra])
    if (!scene || !leaflets || !opening || asked === this.drawn) return
    this.drawn = asked
    const closed = look.share >= 1 || scene.motion_mm.length < 2
    this.nodes = closed ? closedNodes(scene) : nodesAt(scene, look.share)
    leaflets.move(this.nodes)
    // Strain and tension are those of the closed valve.
    const mode = closed || look.mode === 'height' ? look.mode : 'leaflets'
    leaflets.paint(cornerColours(scene, mode, look.scale, this.nodes))
    this.drawChordae(scene, mode, look.scale)
    lines.edges.set(this.edges.flatMap(([a, b]) => [...at(this.nodes, a), ...at(this.nodes, b)]))
    opening.group.visible = look.orifices && closed
    this.drawCut(scene, look)
    const words: Label[] = look.names ? namesOf(scene, this.nodes) : []
    if (opening.group.visible) words.push(...opening.labels.map((label) => ({ ...label, kind: 'orifice' as const })))
    const cut = look.cut === null ? undefined : scene.sections[look.cut]
    const isLeft = ({ point_mm }: Label): boolean => !cut || dot(minus(point_mm, cut.point_mm), cut.normal) <= 0
    this.labels.set([...words.filter(isLeft), ...this.extra])
    this.stage.draw()
  }

  view(name: ViewName): void {
    const { scene } = this
    // From above only the annulus matters, with its names beside it.
    if (scene) this.stage.look(name, name === 'atrial' ? namedAnnulus(scene) : wholeValve(scene))
  }

  /// Lines drawn over everything, such as a measured distance: six numbers each.
  draw(points: number[]): void {
    this.lines.drawn.set(points)
    this.stage.draw()
  }

  private drawChordae(scene: Scene, mode: ColourMode, scale: Scale | null): void {
    const all = chordaLines(scene, this.nodes)
    const colours = chordaColours(scene, mode, scale)
    const whole: number[] = []
    const wholeColours: number[] = []
    const ruptured: number[] = []
    let i = 0
    for (const chorda of scene.chordae)
      for (let s = 0; s < chorda.segments.length; ++s, i += 6) {
        if (chorda.ruptured) ruptured.push(...all.slice(i, i + 6))
        else {
          whole.push(...all.slice(i, i + 6))
          wholeColours.push(...colours.slice(i, i + 6))
        }
      }
    this.lines.chordae.set(whole, wholeColours)
    this.lines.ruptured.set(ruptured)
  }

  /// Hides what lies on the posteromedial side of the cut and traces where it goes through.
  private drawCut(scene: Scene, look: Look): void {
    const chosen = look.cut === null ? undefined : scene.sections[look.cut]
    const planes = chosen
      ? [
          new Plane().setFromNormalAndCoplanarPoint(
            new Vector3(...chosen.normal).negate(),
            new Vector3(...chosen.point_mm),
          ),
        ]
      : []
    this.leaflets?.cut(planes)
    this.opening?.cut(planes)
    for (const name of ['chordae', 'ruptured', 'edges', 'annulus', 'sutures'] as const) this.lines[name].cut(planes)
    const traced = chosen ? section(scene, this.nodes, chosen.point_mm, chosen.normal) : []
    this.lines.cut.set(
      traced.flatMap(({ from, to }) => [...from, ...to]),
      traced.flatMap(({ face }) => {
        const colour = scene.segments[face]?.startsWith('A') ? [0.75, 0.12, 0.12] : [0.1, 0.35, 0.75]
        return [...colour, ...colour]
      }),
    )
  }

  private click(event: MouseEvent): void {
    if (!this.scene || !this.leaflets || !this.onPick || this.picks.length === 0) return
    const [x, y] = this.pressed
    if (Math.hypot(event.clientX - x, event.clientY - y) > TURNED_PX) return
    const pick = pickAt(event, this.stage, this.scene, this.nodes, this.leaflets, this.picks)
    if (pick) this.onPick(pick)
  }

  get shown(): Scene | null {
    return this.scene
  }
  /// A point's place as it is drawn at present.
  nodeAt(vertex: number): Vector {
    return at(this.nodes, vertex)
  }
}
