// A valve that moves, as it is drawn: leaflets, chordae, annular plane, hooks, a cut.
import { BufferAttribute, BufferGeometry, DoubleSide, Mesh, MeshBasicMaterial, Vector3 } from 'three'
import type { Segment, ValveShape, Vector } from '../api/types'
import type { HookState, Picture } from '../engine/picture'
import { cornerColours, cutColour, rgb, TINTS, type Rgb } from '../viewer/colours'
import {
  at,
  chordaLines,
  cross,
  distance,
  dot,
  minus,
  plus,
  seamLines,
  section,
  tieLines,
  times,
  unit,
} from '../viewer/geometry'
import { Leaflets } from '../viewer/leaflets'
import { Lines } from '../viewer/lines'
import { PapillaryMuscles } from '../viewer/papillary'
import { Ring } from '../viewer/ring'
import { TissueMaterial } from '../viewer/tissue_material'
import { clippingPlanes, type CutPlane, isLeft, nearSide } from '../viewer/cut_sight'
import type { Stage } from '../viewer/stage'
import type { LiveValve } from './client'
import { highlighted, prolapse, strainColour } from './surface'

export interface LiveLook {
  strain: boolean // of chordae, in colour
  prolapse: boolean // of leaflets, in colour
  plane: boolean // the annular plane
  cut: number | null // -1 to 1: from the anterolateral end of the annulus to the posteromedial one
  noChordae?: boolean // they are not drawn, and no press grabs them
  amplified?: number // times the length of a force's arrow
}

const CHORDA: Rgb = rgb('#978a72')
const ARROW_MM = 4 // a newton
const HEAD_MM = 1.6 // of an arrow
const RING_MOVED_MM = 0.05 // from where it is drawn anew
const OUTSIDE = 1.12 // the annular plane reaches beyond the annulus

export class LiveDrawing {
  leaflets: Leaflets | null = null
  valve: LiveValve | null = null
  nodes: Float32Array = new Float32Array()
  cableLines: number[] = [] // six numbers a cable that is a chorda's; of ties NaN
  private readonly tissue = new TissueMaterial()
  private readonly ring = new Ring()
  private readonly muscles = new PapillaryMuscles()
  private readonly plane = new Mesh(
    new BufferGeometry(),
    new MeshBasicMaterial({ color: '#3f8fd9', transparent: true, opacity: 0.28, side: DoubleSide, depthWrite: false }),
  )
  private readonly lines = {
    chordae: new Lines({ width: 2 }),
    ruptured: new Lines({ width: 1.6, colour: TINTS.ruptured, dashed: true }),
    sutures: new Lines({ width: 3, colour: TINTS.added }),
    ties: new Lines({ width: 5, colour: TINTS.added, inFront: true }),
    seams: new Lines({ width: 3, colour: TINTS.added, dashed: true, inFront: true }),
    cut: new Lines({ width: 1, inMillimetres: true }),
    threads: new Lines({ width: 1.2, colour: '#5b6b82', inFront: true }), // from the tissue to the hand
    arrows: new Lines({ width: 3.5, colour: '#d6336c', inFront: true }),
    measured: new Lines({ width: 2.5, colour: '#d6336c', inFront: true }),
  }
  private plain: Float32Array = new Float32Array() // colours of the corners
  private places: number[] = [] // of each cable: of its line among chordaLines(), -1 for ties
  private isAbove = '' // as painted
  private hasRing = false
  private ringAt: Vector[] = []
  private side = 1 // of the cut that is hidden: 1 posteromedial, -1 anterolateral

  constructor(private readonly stage: Stage) {
    this.ring.set(null)
    this.plane.renderOrder = 1
    stage.add(this.ring.mesh, this.muscles.mesh, this.plane, ...Object.values(this.lines).map((line) => line.object))
  }

  set(valve: LiveValve, hasRing: boolean): void {
    const { scene } = valve
    this.valve = valve
    this.hasRing = hasRing
    this.ringAt = []
    if (this.nodes.length < scene.rest_mm.length) this.nodes = new Float32Array() // of another valve
    if (!hasRing) this.ring.set(null)
    if (this.leaflets) this.stage.scene.remove(this.leaflets.mesh)
    this.leaflets?.dispose()
    this.leaflets = new Leaflets(scene, this.tissue)
    this.stage.add(this.leaflets.mesh)
    this.plain = cornerColours(scene, 'leaflets', null, scene.rest_mm)
    this.isAbove = ''
    const first: number[] = [] // of each chorda
    let count = 0
    for (const { segments } of scene.chordae) {
      first.push(count)
      count += segments.length
    }
    this.places = valve.cables.map(([chorda, segment]) => (chorda < 0 ? -1 : (first[chorda] as number) + segment))
    this.lines.sutures.set(scene.sutures.flatMap(({ tip_mm, anchor_mm }) => [...tip_mm, ...anchor_mm]))
    this.setPlane(scene)
  }

  move(picture: Picture, look: LiveLook): void {
    const { leaflets, valve } = this
    if (!leaflets || !valve) return
    const { scene } = valve
    this.nodes = picture.nodes
    leaflets.move(picture.nodes)
    this.paint(look)
    if (!look.noChordae) {
      this.drawChordae(scene, picture, look)
      this.muscles.set(scene, picture.nodes)
      this.muscles.seenFrom(this.stage)
    }
    this.lines.ties.set(tieLines(scene, picture.nodes))
    this.lines.seams.set(seamLines(scene, picture.nodes))
    this.drawRing(scene)
    this.plane.visible = look.plane
    this.drawHooks(picture.hooks, look.amplified ?? 1)
    this.drawCut(scene, look)
  }

  /// Whether a point is on the side of the cut that is drawn.
  leaves(point_mm: Vector, look: LiveLook): boolean {
    const cut = this.valve && cutOf(this.valve.scene, look)
    return isLeft(cut, this.side, point_mm)
  }

  measure(points: number[]): void {
    this.lines.measured.set(points)
  }

  private paint(look: LiveLook): void {
    const { leaflets, valve, nodes, plain } = this
    if (!leaflets || !valve) return
    const isAbove = look.prolapse ? prolapse(valve.scene, nodes) : []
    const key = `p${isAbove.map(Number).join('')}`
    if (key === this.isAbove) return
    this.isAbove = key
    leaflets.paint(look.prolapse ? highlighted(valve.scene, plain, isAbove) : plain)
  }

  private drawChordae(scene: ValveShape, picture: Picture, look: LiveLook): void {
    const all = chordaLines(scene, picture.nodes)
    const colours: number[] = []
    const whole: number[] = []
    this.cableLines = this.places.flatMap((place) =>
      place < 0 ? Array<number>(6).fill(NaN) : all.slice(6 * place, 6 * place + 6),
    )
    for (const [cable, place] of this.places.entries()) {
      if (place < 0) continue
      const kind = scene.chordae[this.valve?.cables[cable]?.[0] ?? 0]?.kind
      const plain = kind === 'neochorda' ? rgb(TINTS.added) : CHORDA
      const colour = look.strain ? strainColour(picture.cables[2 * cable + 1] ?? 0) : plain
      whole.push(...all.slice(6 * place, 6 * place + 6))
      colours.push(...colour, ...colour)
    }
    this.lines.chordae.set(whole, colours)
    const ruptured: number[] = []
    let i = 0
    for (const chorda of scene.chordae) {
      const size = 6 * chorda.segments.length
      if (chorda.ruptured) ruptured.push(...all.slice(i, i + size))
      i += size
    }
    this.lines.ruptured.set(ruptured)
  }

  /// With the annulus, which moves in a beat alone.
  private drawRing(scene: ValveShape): void {
    if (!this.hasRing) return
    const annulus = scene.annulus.map((vertex) => at(this.nodes, vertex))
    if (
      this.ringAt.length > 0 &&
      annulus.every((point, i) => distance(point, this.ringAt[i] as Vector) < RING_MOVED_MM)
    )
      return
    this.ringAt = annulus
    this.ring.set({ ...scene, annulus_mm: annulus.flat() }, this.nodes)
  }

  /// A force is drawn as an arrow at the tissue, four millimetres a newton.
  private drawHooks(hooks: (HookState | null)[], amplified: number): void {
    const threads: number[] = []
    const arrows: number[] = []
    const sight = this.stage.camera.getWorldDirection(new Vector3()).toArray()
    for (const hook of hooks) {
      if (!hook) continue
      threads.push(...hook.spot_mm, ...hook.hand_mm)
      if (hook.force_n === 0) continue
      const way = unit(hook.force)
      const tip = plus(hook.spot_mm, times(ARROW_MM * amplified * hook.force_n, way))
      const side = unit(cross(way, sight))
      arrows.push(...hook.spot_mm, ...tip)
      for (const sign of [-1, 1])
        arrows.push(...tip, ...plus(tip, plus(times(-HEAD_MM, way), times(sign * 0.6 * HEAD_MM, side))))
    }
    this.lines.threads.set(threads)
    this.lines.arrows.set(arrows)
  }

  /// A fan around its origin, beyond the annulus.
  private setPlane({ plane, annulus, annulus_mm }: ValveShape): void {
    const outline = annulus.map((_, i) => {
      const way = minus(at(annulus_mm, i), plane.origin_mm)
      return plus(plane.origin_mm, times(OUTSIDE, minus(way, times(dot(way, plane.normal), plane.normal))))
    })
    const corners = outline.flatMap((point, i) => [
      ...plane.origin_mm,
      ...point,
      ...(outline[(i + 1) % outline.length] as Vector),
    ])
    this.plane.geometry.dispose()
    this.plane.geometry = new BufferGeometry()
    this.plane.geometry.setAttribute('position', new BufferAttribute(Float32Array.from(corners), 3))
  }

  /// Across the annulus; the side that is nearer to the eye is hidden.
  private drawCut(scene: ValveShape, look: LiveLook): void {
    const cut = cutOf(scene, look)
    if (cut) this.side = nearSide(this.stage, cut, this.side)
    const planes = clippingPlanes(cut, this.side)
    this.leaflets?.cut(planes)
    this.ring.cut(planes)
    this.muscles.cut(planes)
    for (const name of ['chordae', 'ruptured', 'sutures', 'ties', 'seams'] as const) this.lines[name].cut(planes)
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
}

/// Of a look; null: the valve is whole.
export function cutOf(scene: ValveShape, { cut }: LiveLook): CutPlane | null {
  return cut === null ? null : { point_mm: cutPoint(scene, cut), normal: scene.plane.x }
}

/// Where a cut across the annulus lies; `cut` as of LiveLook.
export function cutPoint({ plane: { origin_mm, x }, annulus, annulus_mm }: ValveShape, cut: number): Vector {
  const reaches = annulus.map((_, i) => Math.abs(dot(minus(at(annulus_mm, i), origin_mm), x)))
  return plus(origin_mm, times(cut * Math.max(...reaches), x))
}
