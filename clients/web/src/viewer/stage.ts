// Canvas, camera and light. Draws only when something has changed.
import {
  AmbientLight,
  Box3,
  Color,
  DirectionalLight,
  MathUtils,
  PerspectiveCamera,
  Scene,
  Vector2,
  Vector3,
  WebGLRenderer,
  type Object3D,
} from 'three'
import { OrbitControls } from 'three/examples/jsm/controls/OrbitControls.js'
import type { Vector } from '../api/types'
import { h } from '../dom'
import { onTheme } from '../shell/theme'
import { TOWARDS_MM, ZOOM } from './sight_ranges'

export type ViewName = 'atrial' | 'oblique' | 'anterior' | 'lateral' | 'ventricular'

/// How a camera looks at a valve, whatever the shape of its canvas.
export interface Sight {
  from: Vector // unit vector towards the camera
  towards_mm: Vector
  zoom: number // 1: as near as what is held allows
}

/// From where: unit vectors in the valve's frame (x posteromedial, y anterior, z atrial).
const VIEWS: Record<ViewName, [number, number, number]> = {
  atrial: [0, -1e-4, 1],
  oblique: [-0.35, -0.75, 0.56],
  anterior: [0, 1, 0.15],
  lateral: [-1, 0, 0.15],
  ventricular: [0, -0.2, -1],
}
const FIELD_DEG = 28
const MARGIN = 1.08 // around what is held
const FROM_ABOVE = 0.8 // cosine between sight and the valve's axis
const CENTRINGS = 3 // after two the middle moves by less than a pixel
const TURN = 0.12 // radians a key press

export class Stage {
  readonly canvas: HTMLCanvasElement
  readonly scene = new Scene()
  readonly camera = new PerspectiveCamera(FIELD_DEG, 1, 1, 2000)
  readonly controls: OrbitControls
  readonly onFrame: (() => void)[] = [] // after each drawing
  private readonly renderer: WebGLRenderer
  private readonly light = new DirectionalLight(0xffffff, 2.1)
  private held: Vector3[] = [] // points that the camera keeps in the picture
  private asked = 0

  constructor(label: string) {
    this.canvas = h('canvas', { tabindex: 0, role: 'img', 'aria-label': label })
    this.renderer = new WebGLRenderer({ canvas: this.canvas, antialias: true, preserveDrawingBuffer: false })
    this.renderer.localClippingEnabled = true
    this.renderer.setPixelRatio(Math.min(devicePixelRatio, 2))
    this.camera.up.set(0, 0, 1)
    this.scene.add(this.camera, new AmbientLight(0xffffff, 1.2))
    this.camera.add(this.light)
    this.light.position.set(-0.4, 0.7, 1)
    this.controls = new OrbitControls(this.camera, this.canvas)
    this.canvas.style.touchAction = '' // the style sheet's: a finger may scroll the page
    this.controls.addEventListener('change', () => {
      this.camera.updateMatrixWorld() // for who asks now where points are
      this.draw()
    })
    this.canvas.addEventListener('keydown', (event) => this.turn(event))
    new ResizeObserver(() => this.resize()).observe(this.canvas)
    onTheme(() => this.draw())
  }

  add(...objects: Object3D[]): void {
    this.scene.add(...objects)
  }

  /// Draws once before the next frame of the screen, however often it is asked.
  draw(): void {
    if (this.asked !== 0) return
    this.asked = requestAnimationFrame(() => this.drawNow())
  }

  drawNow(): void {
    cancelAnimationFrame(this.asked)
    this.asked = 0
    if (this.canvas.clientWidth === 0) return
    this.scene.background = new Color(getComputedStyle(this.canvas).backgroundColor)
    this.renderer.render(this.scene, this.camera)
    for (const drawn of this.onFrame) drawn()
  }

  /// The picture as it is shown, on white, as a PNG of this width (a data URL).
  capture(width_px: number): string {
    const { clientWidth, clientHeight } = this.canvas
    const ratio = this.renderer.getPixelRatio()
    this.renderer.setPixelRatio(width_px / clientWidth)
    this.renderer.setSize(clientWidth, clientHeight, false)
    this.scene.background = new Color('#ffffff')
    this.renderer.render(this.scene, this.camera)
    const png = this.canvas.toDataURL('image/png')
    this.renderer.setPixelRatio(ratio)
    this.renderer.setSize(clientWidth, clientHeight, false)
    this.drawNow()
    return png
  }

  /// Of a millimetre at the middle of the view.
  get pixels_mm(): number {
    const away = this.camera.position.distanceTo(this.controls.target)
    return this.canvas.clientHeight / (2 * away * Math.tan((FIELD_DEG * Math.PI) / 360))
  }

  /// Turns to a view, or to where a vector points from, that holds all of `points_mm`; it holds them on a canvas of another shape, too.
  look(view: ViewName | Vector, points_mm: readonly Vector[]): void {
    this.held = vectorsOf(points_mm)
    const way = new Vector3(...(typeof view === 'string' ? VIEWS[view] : view)).normalize()
    const { target } = this.controls
    target.copy(middleOf(this.held))
    for (let i = 0; i < CENTRINGS; ++i) {
      this.camera.position.copy(target).add(way)
      this.controls.update()
      const away = this.fitting()
      target.add(this.offCentre(away))
      this.camera.position.copy(target).addScaledVector(way, away)
      this.controls.update()
    }
    this.draw()
  }

  /// As sight() has it of these points.
  see({ from, towards_mm, zoom }: Sight, points_mm: readonly Vector[]): void {
    this.held = vectorsOf(points_mm)
    this.controls.target.set(...towards_mm)
    this.camera.position.copy(this.controls.target).add(new Vector3(...from))
    this.controls.update()
    this.zoom(this.fitting() / zoom)
    this.draw()
  }

  sight(points_mm: readonly Vector[]): Sight {
    const { target } = this.controls
    const offset = this.camera.position.clone().sub(target)
    const [away, from] = [offset.length(), offset.normalize()]
    const zoom = MathUtils.clamp(this.fitting(vectorsOf(points_mm)) / away, ZOOM.min, ZOOM.max)
    return {
      from: rounded(from, 4),
      towards_mm: rounded(target.clone().clampScalar(TOWARDS_MM.min, TOWARDS_MM.max), 2),
      zoom: Number(zoom.toFixed(3)),
    }
  }

  /// What brings the camera back to where it is now.
  pose(): () => void {
    const [held, target, position] = [this.held, this.controls.target.clone(), this.camera.position.clone()]
    return () => {
      this.held = held
      this.controls.target.copy(target)
      this.camera.position.copy(position)
      this.controls.update()
      this.draw()
    }
  }

  /// As the surgeon looks into the atrium, or nearly so.
  get isFromAbove(): boolean {
    return this.camera.getWorldDirection(new Vector3()).z < -FROM_ABOVE
  }

  /// Whether a point is in the picture, behind something or not.
  shows(point_mm: Vector): boolean {
    const { x, y } = this.place(point_mm)
    return x > 0 && y > 0 && x < this.size.x && y < this.size.y
  }

  /// From the target to the middle of what is seen from so far away: what is nearer is seen larger, and farther from the middle.
  private offCentre(away: number): Vector3 {
    const turned = this.camera.quaternion.clone().invert()
    const seen = this.held.map((point) => {
      const { x, y, z } = point.clone().sub(this.controls.target).applyQuaternion(turned)
      return new Vector3(x, y, 0).multiplyScalar(away / (away - z))
    })
    return middleOf(seen).applyQuaternion(this.camera.quaternion)
  }

  /// How far the camera is to be from its target, in its present direction, to have all held points in the picture.
  private fitting(held = this.held): number {
    this.camera.updateMatrixWorld()
    const upright = Math.tan((FIELD_DEG * Math.PI) / 360) / MARGIN
    const sideways = upright * this.camera.aspect
    const turned = this.camera.quaternion.clone().invert()
    const needs = held.map((point) => {
      const { x, y, z } = point.clone().sub(this.controls.target).applyQuaternion(turned)
      return z + Math.max(Math.abs(x) / sideways, Math.abs(y) / upright)
    })
    return Math.max(1, ...needs)
  }

  /// Where a point is on the canvas, in its pixels; `depth` grows away from the eye, over 1 is behind it.
  place(point_mm: readonly number[]): { x: number; y: number; depth: number } {
    const seen = new Vector3(...point_mm).project(this.camera)
    return {
      x: ((seen.x + 1) / 2) * this.canvas.clientWidth,
      y: ((1 - seen.y) / 2) * this.canvas.clientHeight,
      depth: seen.z,
    }
  }

  /// -1 to 1 across the canvas, as raycasters want it.
  pointer(event: MouseEvent): Vector2 {
    const box = this.canvas.getBoundingClientRect()
    return new Vector2(
      (2 * (event.clientX - box.left)) / box.width - 1,
      1 - (2 * (event.clientY - box.top)) / box.height,
    )
  }

  get size(): Vector2 {
    return new Vector2(this.canvas.clientWidth, this.canvas.clientHeight)
  }

  /// Follows another stage's camera, and that one this.
  pair(other: Stage): void {
    let following = false // an update tells of a change, too
    for (const [from, to] of [
      [this, other],
      [other, this],
    ] as const)
      from.controls.addEventListener('change', () => {
        if (following) return
        following = true
        to.held = from.held
        to.controls.target.copy(from.controls.target)
        to.camera.position.copy(from.camera.position)
        to.controls.update()
        to.zoom(to.fitting() / from.fitting()) // canvases may differ in shape
        following = false
        to.draw()
      })
  }

  private turn(event: KeyboardEvent): void {
    const ways: Record<string, [number, number]> = {
      ArrowLeft: [-TURN, 0],
      ArrowRight: [TURN, 0],
      ArrowUp: [0, -TURN],
      ArrowDown: [0, TURN],
    }
    const offset = this.camera.position.clone().sub(this.controls.target)
    if (event.key === '+' || event.key === '-') offset.multiplyScalar(event.key === '+' ? 0.9 : 1.1)
    else {
      const way = ways[event.key]
      if (!way) return
      const flat = Math.hypot(offset.x, offset.y)
      const around = Math.atan2(offset.y, offset.x) + way[0]
      const tilt = Math.min(Math.max(Math.atan2(flat, offset.z) + way[1], 1e-4), Math.PI - 1e-4)
      const away = offset.length()
      offset
        .set(Math.sin(tilt) * Math.cos(around), Math.sin(tilt) * Math.sin(around), Math.cos(tilt))
        .multiplyScalar(away)
    }
    event.preventDefault()
    this.camera.position.copy(this.controls.target).add(offset)
    this.controls.update()
    this.draw()
  }

  /// What was turned or zoomed stays so: the camera moves as much as the canvas asks for.
  private resize(): void {
    const { clientWidth, clientHeight } = this.canvas
    if (clientWidth === 0 || clientHeight === 0) return
    const before = this.fitting()
    this.renderer.setSize(clientWidth, clientHeight, false)
    this.camera.aspect = clientWidth / clientHeight
    this.camera.updateProjectionMatrix()
    this.zoom(this.fitting() / before)
    this.controls.dispatchEvent({ type: 'change' }) // more or less is in sight, also where the camera has not moved
    this.drawNow()
  }

  /// Moves the camera to so many times its distance.
  private zoom(times: number): void {
    const offset = this.camera.position.clone().sub(this.controls.target)
    this.camera.position.copy(this.controls.target).addScaledVector(offset, times)
    this.controls.update()
  }
}

function vectorsOf(points_mm: readonly Vector[]): Vector3[] {
  return points_mm.map((point) => new Vector3(...point))
}

function rounded(vector: Vector3, digits: number): Vector {
  return vector.toArray().map((part) => Number(part.toFixed(digits))) as Vector
}

function middleOf(points: Vector3[]): Vector3 {
  return new Box3().setFromPoints(points).getCenter(new Vector3())
}
