// The cut as a drawing: atrium up, anterior left, leaflets as thick and coloured as in the other pictures. Where they are
// nearer than the distance of contact their edges are dark, as a help to the eye; the height is the service's. Where they
// are apart a line joins the nearest points.
import type { Scene, Segment, Vector } from '../api/types'
import { svg } from '../dom'
import { withUnit } from '../format'
import { css, cutColour, TINTS } from '../viewer/colours'
import { blend, closedNodes, distance, dot, minus, section, type SectionPiece } from '../viewer/geometry'
import valveStyle from './valve.module.css'

const CONTACT = 1.25 // of the thickness: mid-surfaces nearer than this touch (coaptation.h)
const EDGED = 0.6 // of the thickness is within the edges
const MARGIN_MM = 3
const LETTERS = 26 // heights of a letter across the drawing

export function sectionInset(scene: Scene, index: number): SVGSVGElement {
  const place = scene.sections[index]
  const drawing = svg('svg', { class: valveStyle.section, 'data-part': 'section', role: 'img' })
  if (!place) return drawing
  const cut = section(scene, closedNodes(scene), place.point_mm, place.normal)
  const flat = (point: Vector): [number, number] => {
    const offset = minus(point, place.point_mm)
    return [-dot(offset, scene.plane.y), -dot(offset, scene.plane.normal)]
  }
  const xs = cut.flatMap(({ from, to }) => [flat(from)[0], flat(to)[0]])
  const ys = cut.flatMap(({ from, to }) => [flat(from)[1], flat(to)[1]])
  const [left, top] = [Math.min(...xs) - MARGIN_MM, Math.min(...ys) - 2 * MARGIN_MM]
  const [width, height] = [Math.max(...xs) + MARGIN_MM - left, Math.max(...ys) + MARGIN_MM - top]
  drawing.setAttribute('viewBox', `${left} ${top} ${width} ${height}`)
  const words = place.contact
    ? `coaptation ${withUnit(place.height_mm, 'mm')}`
    : `leaflets ${withUnit(place.distance_mm, 'mm')} apart`
  drawing.setAttribute('aria-label', `Section of the closed valve: ${words}`)
  const anterior = cut.filter(({ face }) => isAnterior(scene, face))
  const posterior = cut.filter(({ face }) => !isAnterior(scene, face))
  const stroke = ({ from, to }: { from: Vector; to: Vector }, colour: string, breadth: number): void => {
    const [x1, y1] = flat(from)
    const [x2, y2] = flat(to)
    drawing.append(svg('line', { x1, y1, x2, y2, stroke: colour, 'stroke-width': breadth }))
  }
  const touching = new Set([...touches(scene, anterior, posterior), ...touches(scene, posterior, anterior)])
  for (const piece of cut) {
    const edge = css(cutColour(scene.segments[piece.face] as Segment))
    stroke(piece, touching.has(piece) ? 'var(--text)' : edge, scene.thickness_mm)
  }
  for (const piece of cut) {
    const tint = isAnterior(scene, piece.face) ? TINTS.anterior : TINTS.posterior
    stroke(piece, tint, EDGED * scene.thickness_mm)
  }
  if (!place.contact && place.nearest_mm) {
    const [from, to] = place.nearest_mm as [Vector, Vector]
    stroke({ from, to }, TINTS.opening, 0.5 * scene.thickness_mm)
  }
  const size = width / LETTERS
  const text = (x: number, y: number, anchor: string, said: string, name = ''): SVGTextElement =>
    svg('text', { x, y, 'text-anchor': anchor, 'font-size': size, class: name }, said)
  drawing.append(
    text(left + 0.5 * size, top + 1.2 * size, 'start', 'anterior'),
    text(left + width - 0.5 * size, top + 1.2 * size, 'end', 'posterior'),
    text(left + width / 2, top + 1.2 * size, 'middle', words, valveStyle.result),
    svg('line', { x1: left + 1, y1: top + height - 1, x2: left + 11, y2: top + height - 1, class: valveStyle.bar }),
    text(left + 1, top + height - 1.6, 'start', '10 mm'),
  )
  return drawing
}

function isAnterior(scene: Scene, face: number): boolean {
  return scene.segments[face]?.startsWith('A') ?? false
}

function touches(scene: Scene, pieces: SectionPiece[], others: SectionPiece[]): SectionPiece[] {
  return pieces.filter((piece) => others.some((other) => nearness(piece, other) < CONTACT * scene.thickness_mm))
}

/// Of pieces that do not cross.
function nearness(a: SectionPiece, b: SectionPiece): number {
  return Math.min(toPiece(a.from, b), toPiece(a.to, b), toPiece(b.from, a), toPiece(b.to, a))
}

function toPiece(point: Vector, { from, to }: SectionPiece): number {
  const way = minus(to, from)
  const share = dot(minus(point, from), way) / Math.max(dot(way, way), 1e-12)
  return distance(point, blend(from, to, Math.min(Math.max(share, 0), 1)))
}
