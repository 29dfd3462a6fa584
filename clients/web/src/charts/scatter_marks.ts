// Points of a scatter chart, the names beside them, and the legend of what they look like.
import { h, svg } from '../dom'
import { layOut, type Box } from '../viewer/label_layout'
import chartsStyle from './charts.module.css'

/// 0 to LEVELS - 1, told by colour and by size; null: not known; aside: a cross, what the others are compared with.
export type Level = number | null | 'aside'

export interface Mark {
  left: number // px
  top: number
  level: Level
  isRinged: boolean
  isSmall: boolean // of less weight than the others
  name: string // beside it
}

export interface Legend {
  title: string // of the levels
  levels: string[]
  unknown: string
  ringed: string
  small: string // ringed, too
  aside: string
}

export const LEVELS = 6
const RADII_PX = [3.5, 4.8, 6.1, 7.4, 8.7, 10] // by level
const UNKNOWN_PX = 5
const CROSS_PX = 5
const RING_PX = 3.5 // around the point
const SMALL = 0.6 // of the others' size
const LETTER_PX = 7.5
const LINE_PX = 14
const NAME_REACH_PX = 74
const LEADER_PX = 12 // between a point and its name: then a line joins them
const KEY_PX = 28

export function markOf(mark: Omit<Mark, 'name'>): SVGElement {
  const { left, top, level, isRinged } = mark
  const radius = radiusOf(mark)
  return svg(
    'g',
    { transform: `translate(${left} ${top})` },
    isRinged && ring(reachOf(mark)),
    level === 'aside'
      ? svg('path', {
          class: chartsStyle.cross,
          d: `M${-radius} ${-radius}L${radius} ${radius}M${-radius} ${radius}L${radius} ${-radius}`,
        })
      : svg('circle', { class: `${chartsStyle.point} ${chartsStyle[`level${level ?? 'Unknown'}`]}`, r: radius }),
  )
}

/// Indices of `marks` in the order of drawing: none hides a smaller one.
export function largestFirst(marks: Mark[]): number[] {
  const radii = marks.map(radiusOf)
  return marks.map((_, i) => i).sort((a, b) => (radii[b] as number) - (radii[a] as number))
}

function ring(radius: number): SVGElement {
  return svg('circle', { class: chartsStyle.ring, r: radius })
}

type Shape = Pick<Mark, 'level' | 'isRinged' | 'isSmall'>

function radiusOf({ level, isSmall }: Shape): number {
  const radius = level === 'aside' ? CROSS_PX : level === null ? UNKNOWN_PX : (RADII_PX[level] as number)
  return isSmall ? SMALL * radius : radius
}

/// With its ring.
function reachOf(mark: Shape): number {
  return radiusOf(mark) + (mark.isRinged ? RING_PX : 0)
}

/// None over another, over a point or in `kept`; a line leads to one that had to go away, and one without room is left out.
export function namesOf(marks: Mark[], kept: Box[], size: { width: number; height: number }): SVGElement[] {
  const boxes = marks.map((mark): Box => {
    const { left, top } = mark
    const reach = reachOf(mark)
    return { left: left - reach, right: left + reach, top: top - reach, bottom: top + reach }
  })
  const words = marks.map(({ left, top, name }, i) => ({
    x: left,
    y: top,
    width: LETTER_PX * name.length + 2,
    height: LINE_PX,
    rank: i,
    reach: NAME_REACH_PX,
  }))
  return layOut(words, [...boxes, ...kept], size).flatMap((spot, i) => {
    const [mark, word] = [marks[i] as Mark, words[i] as (typeof words)[number]]
    if (!spot) return []
    const x2 = Math.max(spot.x - word.width / 2, Math.min(spot.x + word.width / 2, mark.left))
    const y2 = Math.max(spot.y - LINE_PX / 2, Math.min(spot.y + LINE_PX / 2, mark.top))
    const isFar = Math.hypot(x2 - mark.left, y2 - mark.top) > radiusOf(mark) + LEADER_PX
    return [
      ...(isFar ? [svg('line', { class: chartsStyle.leader, x1: mark.left, y1: mark.top, x2, y2 })] : []),
      svg('text', { class: chartsStyle.name, x: spot.x, y: spot.y + 4, 'text-anchor': 'middle' }, mark.name),
    ]
  })
}

/// Of what occurs among `marks`.
export function legendOf(legend: Legend, marks: Shape[]): HTMLElement {
  const shown = (shape: Shape) => markOf({ left: 0, top: 0, ...shape })
  const plain = (level: Level) => shown({ level, isRinged: false, isSmall: false })
  const has = (level: Level) => marks.some((mark) => mark.level === level)
  const levels: Key[] = legend.levels.map((words, level) => [plain(level), words])
  if (!marks.some(({ level }) => typeof level === 'number')) levels.length = 0
  if (has(null)) levels.push([plain(null), legend.unknown])
  const others: Key[] = []
  if (marks.some(({ isRinged, isSmall }) => isRinged && !isSmall))
    others.push([ring(CROSS_PX + RING_PX), legend.ringed])
  const small = marks.find(({ isSmall }) => isSmall)
  if (small) others.push([shown(small), legend.small])
  if (has('aside')) others.push([plain('aside'), legend.aside])
  return h(
    'div',
    { class: chartsStyle.marks, 'data-part': 'legend' },
    h('span', {}, legend.title),
    keyList(legend.title, levels),
    others.length > 0 && keyList('Other marks', others),
  )
}

type Key = [mark: SVGElement, words: string]

function keyList(title: string, keys: Key[]): HTMLElement {
  const box = `${-KEY_PX / 2} ${-KEY_PX / 2} ${KEY_PX} ${KEY_PX}`
  return h(
    'ul',
    { 'aria-label': title },
    ...keys.map(([mark, words]) =>
      h('li', {}, svg('svg', { width: KEY_PX, height: KEY_PX, viewBox: box, 'aria-hidden': 'true' }, mark), words),
    ),
  )
}
