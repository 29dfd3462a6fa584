// The echo of a valve that moves, or of some closed ones: atrium up, anterior left, as the cut's other drawings.
import type { ValveShape, Vector } from '../api/types'
import { field, h, select } from '../dom'
import { dot, minus, plus, section, times } from '../viewer/geometry'
import { echoImage, type Frame, type Quality } from './image'
import parts from '../style/parts.module.css'
import echoStyle from './echo.module.css'

const FRAME: Frame = { left_mm: -26, top_mm: -12, pixel_mm: 0.25, width: 208, height: 168 } // of the middle of the annulus
const EVERY_MS = 80
const QUALITIES = [
  ['good', 'Good'],
  ['fair', 'Fair'],
  ['poor', 'Poor'],
] as const

export class EchoPanel {
  readonly element: HTMLDetailsElement
  private readonly canvases: HTMLCanvasElement[]
  private quality: Quality = 'fair'
  private drawn_ms = 0
  private last: (() => void) | null = null // draws what was told last

  /// `names`: of the valves, if there are some.
  constructor(names: readonly string[] = []) {
    const canvasOf = (name: string): HTMLCanvasElement =>
      h('canvas', {
        class: echoStyle.echo,
        width: FRAME.width,
        height: FRAME.height,
        role: 'img',
        'aria-label': `Synthetic echo of a cut through ${name}`,
      })
    const isOne = names.length === 0
    this.canvases = isOne ? [canvasOf('the valve')] : names.map(canvasOf)
    const pictures = this.canvases.map((canvas, i) => h('figure', {}, canvas, h('figcaption', {}, names[i] ?? '')))
    this.element = h(
      'details',
      { class: parts.panel, 'data-part': 'echo' },
      h('summary', {}, 'Synthetic echo'),
      ...(isOne ? this.canvases : [h('div', { class: echoStyle.echoes }, ...pictures)]),
      field(
        'Quality',
        select(QUALITIES, this.quality, (quality) => {
          this.quality = quality as Quality
          this.last?.()
        }),
      ),
      h(
        'p',
        { class: parts.hint },
        'Long-axis view through the middle of the annulus, or at the position of the cut: speckle and blur resemble echocardiography, but acoustics are not simulated.',
      ),
    )
    this.element.addEventListener('toggle', () => this.element.open && this.last?.())
  }

  /// `nodes`: of each valve; `point_mm`: of the cut, whose normal is the plane's x; `isLast`: the valve is at rest. While it moves it
  /// is drawn no more often than the eye needs.
  tell(scene: ValveShape, nodes: readonly ArrayLike<number>[], point_mm: Vector, isLast: boolean): void {
    this.last = () => {
      for (const [i, canvas] of this.canvases.entries()) draw(canvas, scene, nodes[i] ?? [], point_mm, this.quality)
    }
    const now_ms = performance.now()
    if (!this.element.open || (!isLast && now_ms - this.drawn_ms < EVERY_MS)) return
    this.drawn_ms = now_ms
    this.last()
  }
}

function draw(
  canvas: HTMLCanvasElement,
  scene: ValveShape,
  nodes: ArrayLike<number>,
  point_mm: Vector,
  quality: Quality,
): void {
  const { x, y, normal } = scene.plane
  const flat = (point: Vector): [number, number] => {
    const offset = minus(point, point_mm)
    return [-dot(offset, y), -dot(offset, normal)]
  }
  const sheets = section(scene, nodes, point_mm, x).map(({ from, to }) => ({ from: flat(from), to: flat(to) }))
  const place = (across: number, depth: number) => plus(point_mm, plus(times(-across, y), times(-depth, normal)))
  paint(canvas, echoImage(sheets, scene.thickness_mm, FRAME, place, quality))
}

function paint(canvas: HTMLCanvasElement, grey: Uint8ClampedArray): void {
  const pen = canvas.getContext('2d')
  if (!pen) return
  const image = pen.createImageData(FRAME.width, FRAME.height)
  for (const [i, value] of grey.entries()) image.data.set([value, value, value, 255], 4 * i)
  pen.putImageData(image, 0, 0)
}
