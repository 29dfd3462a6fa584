// A valve in three dimensions: leaflets, chordae, annulus, where it is open, a cut, names.
import type { LeafletPoint, LeakSurfaces, Opening, Scene, Segment, Step, Vector } from '../api/types'
import { h } from '../dom'
import { chordaColours, cornerColours, cutColour, TINTS, type ColourMode, type Scale } from './colours'
import { at, chordaLines, closedNodes, nodesAt, seamLines, section, tieLines } from './geometry'
import { Bubble, type BubbleSurface } from './bubble'
import { type Camera, lookAt } from './camera'
import { clippingPlanes, isLeft, nearSide, turnToCut } from './cut_sight'
import { Handles } from './handles'
import { around, type Box, boxesOver } from './label_layout'
import { type DrawnLabel, Labels, type Label } from './labels'
import { leakLabels, LeakMeshes, openingLabels } from './leak'
import { Leaflets } from './leaflets'
import { Lines } from './lines'
import { hours, namesOf, wholeValve } from './marks'
import { Neighbours } from './neighbours'
import { isBehind, nearestAround, pickAt, type Pick, type PickKind } from './pick'
import { reading, Readout } from './readout'
import { PapillaryMuscles } from './papillary'
import { Ring } from './ring'
import { type Sight, Stage } from './stage'
import { TissueMaterial } from './tissue_material'
import viewerStyle from './viewer.module.css'

type Cut = Scene['sections'][number]

const NO_LEAK: LeakSurfaces = []
const TURNED_PX = 4 // a pointer that moved so far has turned the valve, not clicked it

export interface Look {
  mode: ColourMode
  scale: Scale | null
  share: number // of a beat: -1 open in diastole, 0 unstressed, 1 closed
  leak: boolean
  names: boolean
  hours: boolean // of a clock, in the surgeon's view
  cut: number | null // index into Scene.sections
}

/// What is shown, as a picture; all but `png` in pixels of the screen.
export interface Shot {
  png: string // data URL
  width: number
  height: number
  labels: DrawnLabel[]
  pixels_mm: number // of a millimetre at the middle of the view
}

export class Viewer {
  readonly element: HTMLElement
  readonly stage: Stage
  onPick: ((pick: Pick) => void) | null = null
  picks: PickKind[] = [] // what a click may mean
  extra: Label[] = []
  inset: HTMLElement | null = null // lies over the canvas
  readonly handles: Handles<Step>
  private scene: Scene | null = null
  private open: Opening | null = null // the same valve in diastole
  private nodes: Float32Array = new Float32Array()
  private leaflets: Leaflets | null = null
  private readonly tissue = new TissueMaterial()
  private readonly leak = new LeakMeshes()
  private pressed: [number, number] = [0, 0] // where on the screen
  private look: Look | null = null
  private drawn = '' // the look of the scene that is drawn
  private side = 1 // of the cut that is hidden: 1 posteromedial, -1 anterolateral
  private readonly labels: Labels
  private readonly neighbours: Neighbours
  private readonly readout = new Readout('readout')
  private pointed = 0 // the frame in which the readout follows the pointer
  private readonly ring = new Ring()
  private readonly muscles = new PapillaryMuscles()
  private readonly around = new Bubble() // a handle
  private readonly lines = {
    chordae: new Lines({ width: 1.6 }),
    ruptured: new Lines({ width: 1.6, colour: TINTS.ruptured, dashed: true }),
    sutures: new Lines({ width: 3, colour: TINTS.added }),
    ties: new Lines({ width: 5, colour: TINTS.added, inFront: true }),
    seams: new Lines({ width: 3, colour: TINTS.added, dashed: true, inFront: true }),
    behind: new Lines({ width: 2, colour: TINTS.added, dashed: true, inFront: true }), // sutures through tissue
    cut: new Lines({ width: 1, inMillimetres: true }),
    drawn: new Lines({ width: 2.5, colour: '#d6336c', inFront: true }),
  }

  constructor(label: string) {
    this.stage = new Stage(label)
    this.labels = new Labels(this.stage)
    this.neighbours = new Neighbours(this.stage)
    this.labels.avoid = () => this.covered()
    this.labels.isBehind = (point_mm) => this.leaflets !== null && isBehind(point_mm, this.stage, this.leaflets)
    this.handles = new Handles(
      this.stage,
      (event) => this.aroundAt(event),
      (event) => this.leafletAt(event),
    )
    this.element = h(
      'div',
      { class: viewerStyle.viewer, 'data-part': 'viewer' },
      this.stage.canvas,
      this.labels.element,
      this.handles.element,
      this.readout.element,
    )
    this.stage.add(
      this.ring.mesh,
      this.muscles.mesh,
      this.around.mesh,
      this.leak.group,
      ...Object.values(this.lines).map((line) => line.object),
    )
    this.stage.controls.addEventListener('change', () => this.look && this.show(this.look))
    this.stage.canvas.addEventListener('pointerdown', ({ clientX, clientY }) => (this.pressed = [clientX, clientY]))
    this.stage.canvas.addEventListener('click', (event) => this.click(event))
    this.stage.canvas.addEventListener('pointermove', (event) => this.point(event))
    this.stage.canvas.addEventListener('pointerleave', () => this.pointAway())
  }

  /// Another valve or another closure. `ring`: whether the annulus carries one.
  set(scene: Scene, look: Look, ring = false): void {
    const first = this.scene === null
    this.scene = scene
    this.open = null
    this.leaflets?.dispose()
    if (this.leaflets) this.stage.scene.remove(this.leaflets.mesh)
    this.leaflets = new Leaflets(scene, this.tissue)
    this.drawn = ''
    this.stage.add(this.leaflets.mesh)
    this.ring.set(ring ? scene : null, closedNodes(scene))
    const sutures = scene.sutures.flatMap((suture) => [...suture.tip_mm, ...suture.anchor_mm])
    this.lines.sutures.set(sutures)
    this.lines.behind.set(sutures)
    this.show(look)
    if (first) this.view('atrial')
  }

  /// Of the valve that is shown.
  setOpen(open: Opening): void {
    this.open = open
    this.drawn = ''
  }

  show(look: Look): void {
    const { scene, leaflets } = this
    const wasCut = this.look?.cut ?? null
    this.look = look
    const cut = look.cut === null ? undefined : scene?.sections[look.cut]
    if (scene && cut && wasCut === null) turnToCut(this.stage, scene, this.nodes, cut)
    if (cut) this.side = nearSide(this.stage, cut, this.side)
    this.handles.isLeft = (point_mm) => isLeft(cut ?? null, this.side, point_mm)
    this.muscles.seenFrom(this.stage)
    const beside = this.neighbours.show(look.names ? scene : null)
    const asked = JSON.stringify([look, this.extra, this.side, beside.map(({ text }) => text)])
    if (!scene || !leaflets || asked === this.drawn) return
    this.drawn = asked
    this.pointAway()
    const closed = this.isClosed(look)
    this.nodes = closed ? closedNodes(scene) : nodesAt(scene, look.share, this.open?.scene)
    leaflets.move(this.nodes)
    const mode = this.modeOf(look)
    leaflets.paint(cornerColours(scene, mode, look.scale, this.nodes))
    this.tissue.wet(mode === 'leaflets' || mode === 'tension')
    this.drawChordae(scene, mode, look.scale)
    this.muscles.set(scene, this.nodes)
    this.lines.ties.set(tieLines(scene, this.nodes))
    this.lines.seams.set(seamLines(scene, this.nodes))
    this.drawCut(scene, cut)
    const { surfaces, labels } = this.leakAt(look)
    this.leak.show(surfaces)
    const names = look.names ? [...namesOf(scene, this.nodes), ...beside] : []
    const named = [...names, ...(look.hours ? hours(scene) : [])].filter(({ point_mm }) =>
      this.handles.isLeft(point_mm),
    )
    this.labels.set([...named, ...labels, ...this.extra])
    this.stage.draw()
  }

  shot(width_px: number): Shot {
    const { x: width, y: height } = this.stage.size
    const png = this.stage.capture(width_px)
    return { png, width, height, labels: this.labels.drawn(), pixels_mm: this.stage.pixels_mm }
  }

  private isClosed(look: Look): boolean {
    const states = [this.scene?.motion_mm, look.share < 0 ? this.open?.scene.motion_mm : []]
    return look.share >= 1 || states.every((motion_mm) => (motion_mm?.length ?? 0) < 2)
  }

  /// Nothing on the way between open and closed.
  private leakAt(look: Look): { surfaces: LeakSurfaces; labels: Label[] } {
    const { scene, open } = this
    if (look.leak && scene && this.isClosed(look)) return { surfaces: scene.leak, labels: leakLabels(scene) }
    if (look.leak && open && look.share <= -1) return { surfaces: open.scene.leak, labels: openingLabels(open) }
    return { surfaces: NO_LEAK, labels: [] }
  }

  /// Strain and tension are those of the closed valve.
  private modeOf(look: Look): ColourMode {
    return this.isClosed(look) || look.mode === 'height' ? look.mode : 'leaflets'
  }

  view(camera: Camera): void {
    if (this.scene) lookAt(this.stage, camera, this.scene, this.nodes)
  }
  get sight(): Sight | null {
    return this.scene && this.stage.sight(wholeValve(this.scene))
  }

  /// Words besides the names.
  mark(labels: Label[]): void {
    this.extra = labels
    if (this.look) this.show(this.look)
  }

  /// Around the handle that is grabbed; null: none is.
  bubble(surface: BubbleSurface | null): void {
    this.around.set(surface)
    this.stage.draw()
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

  /// Hides what lies between the eye and the cut and shows the cut edge.
  private drawCut(scene: Scene, cut: Cut | undefined): void {
    const planes = clippingPlanes(cut ?? null, this.side)
    this.leaflets?.cut(planes)
    this.leak.cut(planes)
    this.ring.cut(planes)
    this.muscles.cut(planes)
    for (const name of ['chordae', 'ruptured', 'sutures', 'behind', 'ties', 'seams'] as const)
      this.lines[name].cut(planes)
    const traced = cut ? section(scene, this.nodes, cut.point_mm, cut.normal) : []
    this.lines.cut.width = scene.thickness_mm
    this.lines.cut.set(
      traced.flatMap(({ from, to }) => [...from, ...to]),
      traced.flatMap(({ face }) => {
        const colour = cutColour(scene.segments[face] as Segment)
        return [...colour, ...colour]
      }),
    )
  }

  /// Once a frame; not while the valve is turned.
  private point(event: PointerEvent): void {
    this.pointAway()
    if (event.buttons === 0) this.pointed = requestAnimationFrame(() => this.read(event))
  }

  private pointAway(): void {
    cancelAnimationFrame(this.pointed)
    this.readout.hide()
  }

  private read(event: MouseEvent): void {
    const { scene, leaflets, look, stage, nodes } = this
    if (!scene || !leaflets || !look) return
    const kinds: PickKind[] = look.mode === 'tension' ? ['chorda'] : ['leaflet']
    const pick = pickAt(event, stage, scene, nodes, leaflets, kinds)
    const text = pick ? reading(scene, nodes, this.modeOf(look), look.scale, pick) : ''
    const box = stage.canvas.getBoundingClientRect()
    const place = { x: event.clientX - box.left, y: event.clientY - box.top }
    if (text !== '') this.readout.show(text, place, box)
  }

  private leafletAt(event: PointerEvent): LeafletPoint | null {
    if (!this.scene || !this.leaflets) return null
    const pick = pickAt(event, this.stage, this.scene, this.nodes, this.leaflets, ['leaflet'])
    return pick?.kind === 'leaflet' ? pick.point : null
  }

  private aroundAt(event: PointerEvent): number {
    return this.scene ? nearestAround(event, this.stage, this.scene) : 0
  }

  private click(event: MouseEvent): void {
    const [x, y] = this.pressed
    if (!this.scene || !this.leaflets || Math.hypot(event.clientX - x, event.clientY - y) > TURNED_PX) return
    if (!this.onPick || this.picks.length === 0) {
      this.read(event) // a finger does not hover
      return
    }
    const named = this.picks.includes('head') ? this.labels.headAt(event) : null
    const pick = named ?? pickAt(event, this.stage, this.scene, this.nodes, this.leaflets, this.picks)
    if (pick) this.onPick(pick)
  }

  /// By what has to be seen: the leak, the inset. An open valve is wide enough to hold its label.
  private covered(): Box[] {
    const shown = this.look && this.isClosed(this.look) ? this.leak.outlines_mm : []
    const boxes = shown.flatMap((points) => around(points.map((point) => this.stage.place(point))) ?? [])
    return [...boxes, ...this.handles.boxes(), ...boxesOver(this.stage.canvas, [this.inset])]
  }

  get shown(): Scene | null {
    return this.scene
  }
  /// A point's place as it is drawn at present.
  nodeAt(vertex: number): Vector {
    return at(this.nodes, vertex)
  }
}
