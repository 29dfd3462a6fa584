// Pictures of a valve before and after plans, as the 3D view shows them from the atrium, closed or open, or cut across the
// line of coaptation in the middle. One view that nobody sees takes those from the atrium, one after the other, and again when
// the theme changes.
import { drawScene, openValve } from '../api/calls'
import type { Opening, Plan, Scene, Vector } from '../api/types'
import { h } from '../dom'
import { hasRing } from '../repair/steps'
import { onTheme } from '../shell/theme'
import { sectionInset } from '../valve/section_inset'
import { TINTS } from '../viewer/colours'
import type { Viewer } from '../viewer/viewer'
import parts from '../style/parts.module.css'
import searchStyle from './search.module.css'

const ENDS = 2 // of the motion: what is open is drawn as its last state

export type Beat = 'closed' | 'open'

const LOOK = { mode: 'leaflets', scale: null, share: 1, leak: true, names: false, hours: false, cut: null } as const

// Colours and widths in pixels of strokes over each other.
const RING = [
  [TINTS.annulus, 11],
  [TINTS.ring, 8],
] as const
const SUTURE = [
  ['#ffffff', 5],
  [TINTS.added, 3],
] as const

let studio: Promise<Viewer> | null = null

async function openStudio(): Promise<Viewer> {
  const { Viewer } = await import('../viewer/viewer')
  const viewer = new Viewer('The valve shown in the pictures')
  document.body.append(h('div', { class: searchStyle.studio, inert: true }, viewer.element))
  await new Promise((laidOut) => requestAnimationFrame(() => requestAnimationFrame(laidOut)))
  return viewer
}

export class Photos {
  private readonly scenes = new Map<string, Promise<Scene>>() // by the plan
  private readonly openings = new Map<string, Promise<Opening>>()
  private readonly taken: (() => void)[] = []
  private last: Promise<unknown> = Promise.resolve() // one at a time

  /// `valve`: a preset's name or a stored valve's id. Nothing is asked for after `signal` aborts.
  constructor(
    private readonly valve: string,
    private readonly signal: AbortSignal,
  ) {
    const again = () => {
      for (const take of this.taken) take()
    }
    onTheme(again, signal)
  }

  /// Of the valve as `plan` leaves it; null: as it is.
  photo(plan: Plan | null, alt: string, beat: Beat = 'closed'): HTMLElement {
    const canvas = h('canvas', { role: 'img', 'aria-label': alt })
    const frame = h('div', { class: searchStyle.photo, 'data-part': 'photo' }, canvas)
    const take = () => {
      frame.removeAttribute('data-taken')
      this.last = this.last
        .then(() => this.take(canvas, plan, beat))
        .then(
          () => {
            frame.replaceChildren(canvas)
            frame.setAttribute('data-taken', '')
          },
          () => frame.replaceChildren(h('p', { class: parts.hint }, 'The picture could not be drawn.')),
        )
    }
    take()
    this.taken.push(take)
    return frame
  }

  /// The closed valve, cut.
  section(plan: Plan, alt: string): HTMLElement {
    const frame = h('div', { class: searchStyle.photo, role: 'img', 'aria-label': alt, 'data-part': 'cut' })
    this.scene(plan).then(
      (scene) => frame.replaceChildren(sectionInset(scene, Math.floor(scene.sections.length / 2))),
      () => frame.replaceChildren(h('p', { class: parts.hint }, 'The cut could not be drawn.')),
    )
    return frame
  }

  private async take(canvas: HTMLCanvasElement, plan: Plan | null, beat: Beat): Promise<void> {
    if (this.signal.aborted) return
    studio ??= openStudio().catch((error: unknown) => {
      studio = null // the next picture tries again
      throw error
    })
    const opening = beat === 'open' ? this.opening(plan) : null
    const [before, scene, viewer, open] = await Promise.all([this.scene(null), this.scene(plan), studio, opening])
    if (this.signal.aborted) return
    viewer.set(scene, LOOK)
    if (open) {
      viewer.setOpen(open)
      viewer.show({ ...LOOK, share: -1 })
    }
    viewer.stage.look('atrial', points(before.annulus_mm)) // all in one scale
    viewer.stage.drawNow()
    const drawn = viewer.stage.canvas
    canvas.width = drawn.width
    canvas.height = drawn.height
    const pen = canvas.getContext('2d')
    if (!pen) return
    pen.drawImage(drawn, 0, 0)
    pen.scale(drawn.width / drawn.clientWidth, drawn.height / drawn.clientHeight)
    drawImplants(pen, scene, hasRing(plan), (point) => viewer.stage.place(point))
  }

  private scene(plan: Plan | null): Promise<Scene> {
    return once(this.scenes, plan, () => drawScene(this.valve, plan, 0, this.signal))
  }

  private opening(plan: Plan | null): Promise<Opening> {
    return once(this.openings, plan, () => openValve(this.valve, plan, ENDS))
  }
}

/// Asks again only for what failed.
function once<T>(asked: Map<string, Promise<T>>, plan: Plan | null, ask: () => Promise<T>): Promise<T> {
  const key = JSON.stringify(plan?.steps ?? [])
  const known = asked.get(key)
  if (known) return known
  const answer = ask()
  asked.set(key, answer)
  answer.catch(() => asked.delete(key))
  return answer
}

type Place = (point_mm: Vector) => { x: number; y: number }

/// Over the leaflets, as in the report: seen from the atrium they hide the sutures and neochordae.
function drawImplants(pen: CanvasRenderingContext2D, scene: Scene, hasRing: boolean, place: Place): void {
  const line = (points_mm: Vector[], colour: string, width: number) => {
    pen.beginPath()
    for (const point of points_mm) {
      const { x, y } = place(point)
      pen.lineTo(x, y)
    }
    pen.strokeStyle = colour
    pen.lineWidth = width
    pen.stroke()
  }
  pen.lineJoin = pen.lineCap = 'round'
  const annulus = points(scene.annulus_mm)
  if (hasRing) for (const [colour, width] of RING) line([...annulus, ...annulus.slice(0, 2)], colour, width)
  const ties = scene.sutures.map(({ tip_mm, anchor_mm }) => [tip_mm, anchor_mm])
  const neochordae = scene.chordae
    .filter(({ kind }) => kind === 'neochorda')
    .map(({ head, segments }) => [scene.heads[head]?.tip_mm, ...segments.map(({ end_mm }) => end_mm)])
  for (const implant of [...ties, ...neochordae])
    for (const [colour, width] of SUTURE)
      line(
        implant.filter((point) => point !== undefined),
        colour,
        width,
      )
}

function points(flat_mm: number[]): Vector[] {
  return Array.from({ length: flat_mm.length / 3 }, (_, i) => flat_mm.slice(3 * i, 3 * i + 3) as Vector)
}
