// Files that are to be imported, as they are, in three dimensions; a click picks a place on them.
import {
  BufferAttribute,
  BufferGeometry,
  DoubleSide,
  Group,
  Mesh,
  MeshLambertMaterial,
  Plane,
  Raycaster,
  Vector3,
} from 'three'
import type { Vector } from '../api/types'
import { h } from '../dom'
import type { Role } from '../valve/parts'
import { rgb, TINTS } from './colours'
import { inputFrame, intoFile, intoView, pointsOf, type InputFrame, type Part } from './input_frame'
import { Labels, type Label } from './labels'
import { Lines } from './lines'
import { Stage, type ViewName } from './stage'
import viewerStyle from './viewer.module.css'

const COLOURS: Record<Role, string> = {
  detected: '#c3c9d1',
  anterior: TINTS.anterior,
  posterior: TINTS.posterior,
  labels: TINTS.anterior,
  voxels: '#c3c9d1',
  surface: TINTS.surface,
  annulus: '#cdb7b0',
  chordae: '#cdb7b0',
  tips: '#cdb7b0',
  landmarks: '#cdb7b0',
  folder: '#cdb7b0',
  none: '#c3c9d1',
}
const ARM = 1 // of the crosses that mark places, in the picture's size of 60
const SNAP_PX = 24 // to the annulus
const TIP_DEPTH = 0.75 // papillary tips lie so many widths of the picture's half below the annulus
const TURNED_PX = 4 // a pointer that moved so far has turned the picture

export interface Seen {
  place: Vector // in the files' coordinates
  text: string
}

export class InputViewer {
  readonly element: HTMLElement
  onPick: ((place: Vector) => void) | null = null
  pickInAir = false // as papillary tips may have to be
  private readonly stage = new Stage(
    'The files to import, in three dimensions; arrow keys turn them, plus and minus zoom',
  )
  private readonly labels = new Labels(this.stage)
  private readonly group = new Group()
  private readonly lines = {
    annulus: new Lines({ width: 3, colour: TINTS.annulus, inFront: true }),
    chordae: new Lines({ width: 1.4, colour: TINTS.chorda }),
    marks: new Lines({ width: 4, colour: '#b0205a', inFront: true }),
    tips: new Lines({ width: 3, colour: TINTS.papillary, inFront: true }),
  }
  private frame: InputFrame | null = null
  private loop: Vector[] = [] // of the annulus, as it is drawn
  private corners: Vector[] = [] // of the box around all of it
  private pressed: [number, number] = [0, 0]

  constructor() {
    this.element = h(
      'div',
      { class: viewerStyle.viewer, 'data-part': 'input-viewer' },
      this.stage.canvas,
      this.labels.element,
    )
    this.stage.add(this.group, ...Object.values(this.lines).map((line) => line.object))
    this.stage.canvas.addEventListener('pointerdown', ({ clientX, clientY }) => (this.pressed = [clientX, clientY]))
    this.stage.canvas.addEventListener('click', (event) => this.click(event))
  }

  set(parts: Part[]): void {
    const shown = parts.filter(({ file }) => file.points.length > 0)
    this.clear()
    this.frame = inputFrame(shown)
    const { frame } = this
    this.stage.draw()
    if (!frame) return
    const drawn = shown.map((part) => ({ ...part, points: pointsOf(part.file).map((point) => intoView(frame, point)) }))
    const segments: number[] = []
    const chordae: number[] = []
    const tips: number[] = []
    for (const { file, role, points } of drawn) {
      if (file.faces.length > 0) this.group.add(surface(points, file.faces, COLOURS[role]))
      else if (file.content === 'chordae') chordae.push(...points.flat())
      else if (file.content === 'curve') {
        if (role === 'annulus' || role === 'folder') this.loop.push(...points)
        for (const [i, point] of points.entries())
          segments.push(...point, ...(points[(i + 1) % points.length] as Vector))
      } else for (const point of points) tips.push(...cross(point))
    }
    this.lines.annulus.set(segments)
    this.lines.chordae.set(chordae)
    this.lines.tips.set(tips)
    this.corners = cornersOf(drawn.flatMap(({ points }) => points))
    this.view('oblique')
  }

  /// Places that were picked.
  mark(seen: Seen[]): void {
    const { frame } = this
    if (!frame) return
    const points = seen.map(({ place }) => intoView(frame, place))
    this.lines.marks.set(points.flatMap(cross))
    this.labels.set(seen.map(({ text }, i): Label => ({ point_mm: points[i] as Vector, text, kind: 'landmark' })))
    this.stage.draw()
  }

  view(name: ViewName): void {
    this.stage.look(name, this.corners)
  }

  private clear(): void {
    for (const child of this.group.children) (child as Mesh).geometry.dispose()
    this.group.clear()
    for (const line of Object.values(this.lines)) line.set([])
    this.labels.set([])
    this.loop = []
    this.corners = []
  }

  private click(event: MouseEvent): void {
    const [x, y] = this.pressed
    if (!this.onPick || !this.frame || Math.hypot(event.clientX - x, event.clientY - y) > TURNED_PX) return
    const place = this.pickInAir ? this.aimed(event) : (this.onAnnulus(event) ?? this.onSurface(event))
    if (place) this.onPick(intoFile(this.frame, place))
  }

  private onAnnulus(event: MouseEvent): Vector | null {
    const box = this.stage.canvas.getBoundingClientRect()
    let best = SNAP_PX
    let nearest: Vector | null = null
    for (const point of this.loop) {
      const seen = this.stage.place(point)
      const away = Math.hypot(seen.x - event.clientX + box.left, seen.y - event.clientY + box.top)
      if (away < best) [best, nearest] = [away, point]
    }
    return nearest
  }

  private caster(event: MouseEvent): Raycaster {
    const caster = new Raycaster()
    caster.setFromCamera(this.stage.pointer(event), this.stage.camera)
    return caster
  }

  private onSurface(event: MouseEvent): Vector | null {
    const [hit] = this.caster(event).intersectObjects(this.group.children, false)
    return hit ? hit.point.toArray() : null
  }

  /// At the depth where papillary tips are, as far from the eye as the middle of the valve is.
  private aimed(event: MouseEvent): Vector | null {
    const radius = Math.max(...this.loop.map((point) => Math.hypot(...point)), 1)
    const away = this.stage.camera.getWorldDirection(new Vector3())
    const plane = new Plane().setFromNormalAndCoplanarPoint(away, new Vector3(0, 0, -2 * TIP_DEPTH * radius))
    return this.caster(event).ray.intersectPlane(plane, new Vector3())?.toArray() ?? null
  }
}

function cornersOf(points: Vector[]): Vector[] {
  const low: Vector = [Infinity, Infinity, Infinity]
  const high: Vector = [-Infinity, -Infinity, -Infinity]
  for (const point of points)
    for (const k of [0, 1, 2] as const) {
      low[k] = Math.min(low[k], point[k])
      high[k] = Math.max(high[k], point[k])
    }
  return [low[0], high[0]].flatMap((x) =>
    [low[1], high[1]].flatMap((y) => [low[2], high[2]].map((z): Vector => [x, y, z])),
  )
}

/// Three lines across each other.
function cross([x, y, z]: Vector): number[] {
  const lines = [
    [x - ARM, y, z, x + ARM, y, z],
    [x, y - ARM, z, x, y + ARM, z],
    [x, y, z - ARM, x, y, z + ARM],
  ]
  return lines.flat()
}

function surface(points: Vector[], faces: number[], colour: string): Mesh {
  const geometry = new BufferGeometry()
  geometry.setAttribute('position', new BufferAttribute(new Float32Array(points.flat()), 3))
  geometry.setIndex(faces)
  geometry.computeVertexNormals()
  const material = new MeshLambertMaterial({ side: DoubleSide })
  material.color.setRGB(...rgb(colour), 'srgb')
  return new Mesh(geometry, material)
}
