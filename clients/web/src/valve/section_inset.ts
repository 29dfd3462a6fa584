// The cut as a drawing: atrium up, anterior left. Where the leaflets are nearer than the distance of contact the line is
// thick, as a help to the eye; the height is the service's.
import type { Scene, Vector } from '../api/types'
import { svg } from '../dom'
import { withUnit } from '../format'
import { blend, closedNodes, distance, dot, minus, section, type SectionPiece } from '../viewer/geometry'
import valveStyle from './valve.module.css'

const CONTACT = 1.25 // of the thickness: mid-surfaces nearer than this touch (coaptation.h)
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
    : `apart ${withUnit(place.distance_mm, 'mm')}`
  drawing.setAttribute('aria-label', `Section of the closed valve: ${words}`)
  const anterior = cut.filter(({ face }) => isAnterior(scene, face))
  const posterior = cut.filter(({ face }) => !isAnterior(scene, face))
  for (const [pieces, others, name] of [
    [anterior, posterior, 'anterior'],
    [posterior, anterior, 'posterior'],
  ] as const)
    for (const piece of pieces) {
      const [x1, y1] = flat(piece.from)
      const [x2, y2] = flat(piece.to)
      const touches = others.some((other) => nearness(piece, other) < CONTACT * scene.thickness_mm)
      drawing.append(
        svg('line', {
          x1,
          y1,
          x2,
          y2,
          class: touches ? `${valveStyle[name]} ${valveStyle.contact}` : valveStyle[name],
        }),
      )
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

/// Of pieces that do not cross.
function nearness(a: SectionPiece, b: SectionPiece): number {
  return Math.min(toPiece(a.from, b), toPiece(a.to, b), toPiece(b.from, a), toPiece(b.to, a))
}

function toPiece(point: Vector, { from, to }: SectionPiece): number {
  const way = minus(to, from)
  const share = dot(minus(point, from), way) / Math.max(dot(way, way), 1e-12)
  return distance(point, blend(from, to, Math.min(Math.max(share, 0), 1)))
}
