// Canvas, camera and light. Draws only when something has changed.
import {
  AmbientLight,
  Color,
  DirectionalLight,
  PerspectiveCamera,
  Scene,
  Vector2,
  Vector3,
  WebGLRenderer,
  type Object3D,
} from 'three'
import { OrbitControls } from 'three/examples/jsm/controls/OrbitControls.js'
import { h } from '../dom'

export type ViewName = 'atrial' | 'oblique' | 'anterior' | 'lateral' | 'ventricular'

/// From where: unit vectors in the valve's frame (x posteromedial, y anterior, z atrial).
const VIEWS: Record<ViewName, [number, number, number]> = {
  atrial: [0, -1e-4, 1],
  oblique: [-0.35, -0.75, 0.56],
  anterior: [0, 1, 0.15],
  lateral: [-1, 0, 0.15],
  ventricular: [0, -0.2, -1],
}
const FIELD_DEG = 28
const TURN = 0.12 // radians a key press

export class Stage {
  readonly canvas: HTMLCanvasElement
  readonly scene = new Scene()
  readonly camera = new PerspectiveCamera(FIELD_DEG, 1, 1, 2000)
  readonly controls: OrbitControls
  readonly onFrame: (() => void)[] = [] // after each drawing
  private readonly renderer: WebGLRenderer
  private readonly light = new DirectionalLight(0xffffff, 2.2)
  private radius_mm = 30
  private asked = 0

  constructor(label: string) {
    this.canvas = h('canvas', { tabindex: 0, role: 'img', 'aria-label': label })
    this.renderer = new WebGLRenderer({ canvas: this.canvas, antialias: true, preserveDrawingBuffer: false })
    this.renderer.localClippingEnabled = true
    this.renderer.setPixelRatio(Math.min(devicePixelRatio, 2))
    this.camera.up.set(0, 0, 1)
    this.scene.add(this.camera, new AmbientLight(0xffffff, 1.5))
    this.camera.add(this.light)
    this.light.position.set(-0.4, 0.7, 1)
    this.controls = new OrbitControls(this.camera, this.canvas)
    this.controls.addEventListener('change', () => this.draw())
    this.canvas.addEventListener('keydown', (event) => this.turn(event))
    new ResizeObserver(() => this.resize()).observe(this.canvas)
    document.addEventListener('themechange', () => this.draw())
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
    this.scene.background = new Color(getComputedStyle(this.canvas).getPropertyValue('--view').trim() || '#e9edf2')
    this.renderer.render(this.scene, this.camera)
    for (const drawn of this.onFrame) drawn()
  }

  /// Turns to a view of the whole valve, which fits in a ball of `radius_mm` around `centre_mm`.
  look(view: ViewName, centre_mm: readonly number[], radius_mm = this.radius_mm): void {
    this.radius_mm = radius_mm
    const narrow = Math.min(1, this.camera.aspect)
    const away = (1.06 * radius_mm) / Math.sin((FIELD_DEG * Math.PI) / 360) / narrow
    const centre = new Vector3(...centre_mm)
    this.controls.target.copy(centre)
    this.camera.position.copy(new Vector3(...VIEWS[view]).normalize().multiplyScalar(away).add(centre))
    this.controls.update()
    this.draw()
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
    return new Vector2((2 * (event.clientX - box.left)) / box.width - 1, 1 - (2 * (event.clientY - box.top)) / box.height)
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
        to.camera.position.copy(from.camera.position)
        to.controls.target.copy(from.controls.target)
        to.controls.update()
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
      offset.set(Math.sin(tilt) * Math.cos(around), Math.sin(tilt) * Math.sin(around), Math.cos(tilt)).multiplyScalar(away)
    }
    event.preventDefault()
    this.camera.position.copy(this.controls.target).add(offset)
    this.controls.update()
    this.draw()
  }

  private resize(): void {
    const { clientWidth, clientHeight } = this.canvas
    if (clientWidth === 0 || clientHeight === 0) return
    this.renderer.setSize(clientWidth, clientHeight, false)
    this.camera.aspect = clientWidth / clientHeight
    this.camera.updateProjectionMatrix()
    this.drawNow()
  }
}
