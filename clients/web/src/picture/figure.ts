// A picture for a paper or a chart: raster pictures of the valve with their words, scale bar, legend and figures as
// vectors around them, 180 mm wide, on white.
import { svg } from '../dom'
import { number } from '../format'
import { css, TINTS, type Scale } from '../viewer/colours'
import type { Kind } from '../viewer/legend'
import type { Shot } from '../viewer/viewer'

export interface Figure {
  name: string // of the valve
  lines: string[] // what is measured, what was repaired
  shots: { title: string; shot: Shot }[] // one beside the other
  scale: Scale | null
  kinds: readonly Kind[] // that its colours mean, without a scale
}

export const WIDTH_MM = 180
const NOTICE = 'coapt: research software, not a medical device; not for clinical decisions'

const INK = '#1b2430'
const SOFT = '#55606e'
const BETWEEN_MM = 4
const NAME_MM = 5 // height of its letters, as those below
const LINE_MM = 3.4
const BAR_MM = 10 // of the valve
const LEADING = 1.4
const COLUMNS = 3 // of the legend

export function figureSvg({ name, lines, shots, scale, kinds }: Figure): SVGSVGElement {
  const parts: SVGElement[] = []
  let y = NAME_MM
  parts.push(text(0, y, NAME_MM, name, { 'font-weight': 700 }))
  for (const line of lines) {
    y += LEADING * LINE_MM
    parts.push(text(0, y, LINE_MM, line))
  }
  y += LINE_MM
  const width = (WIDTH_MM - BETWEEN_MM * (shots.length - 1)) / shots.length
  const drawn = shots.map(({ title, shot }, i) => panel(title, shot, { x: i * (width + BETWEEN_MM), y, width }))
  parts.push(...drawn.map(({ element }) => element))
  y = Math.max(...drawn.map(({ bottom }) => bottom)) + 2 * LINE_MM
  parts.push(scale ? scaleLegend(scale, y) : tintLegend(kinds, y))
  y += (scale ? 2 : 1 + LEADING * Math.ceil(kinds.length / COLUMNS)) * LINE_MM
  parts.push(text(0, y, LINE_MM, NOTICE, { fill: SOFT }))
  const height = y + LINE_MM
  return svg(
    'svg',
    {
      xmlns: 'http://www.w3.org/2000/svg',
      width: `${WIDTH_MM}mm`,
      height: `${height.toFixed(2)}mm`,
      viewBox: `0 0 ${WIDTH_MM} ${height.toFixed(2)}`,
      'font-family': "'Liberation Sans', Arial, Helvetica, sans-serif",
    },
    svg('rect', { width: WIDTH_MM, height, fill: '#ffffff' }),
    ...parts,
  )
}

function text(
  x: number,
  y: number,
  size: number,
  said: string,
  more: Record<string, string | number> = {},
): SVGElement {
  return svg('text', { x, y, 'font-size': size, fill: INK, ...more }, said)
}

/// `width` in mm of the paper; a label of the screen keeps its place and its share of the picture.
function panel(
  title: string,
  shot: Shot,
  { x, y, width }: { x: number; y: number; width: number },
): { element: SVGElement; bottom: number } {
  const mm = width / shot.width // of the paper, a pixel
  const height = shot.height * mm
  const top = title === '' ? y : y + LEADING * LINE_MM
  const place = (across: number, down: number) => ({ x: x + across * mm, y: top + down * mm })
  const words = shot.labels.map((label) => {
    const middle = place(label.x, label.y)
    const [wide, high] = [label.width * mm, label.height * mm]
    const isLeak = label.kind === 'leak'
    const ground = isLeak ? TINTS.opening : label.kind === 'distance' ? '#b0205a' : '#ffffff'
    return [
      svg('rect', {
        x: middle.x - wide / 2,
        y: middle.y - high / 2,
        width: wide,
        height: high,
        rx: 0.2 * high,
        fill: ground,
        'fill-opacity': ground === '#ffffff' ? 0.8 : 1,
      }),
      text(middle.x, middle.y + 0.26 * high, 0.68 * high, label.text, {
        'text-anchor': 'middle',
        fill: ground === '#ffffff' ? INK : '#ffffff',
        ...(label.kind === 'landmark' || label.kind === 'tip' ? {} : { 'font-weight': 700 }),
      }),
    ]
  })
  const leaders = shot.labels.flatMap((label) => {
    if (!label.to) return []
    const [from, to] = [place(label.x, label.y), place(label.to.x, label.to.y)]
    return svg('line', { x1: from.x, y1: from.y, x2: to.x, y2: to.y, stroke: INK, 'stroke-width': 0.2 })
  })
  const bar = BAR_MM * shot.pixels_mm * mm
  const foot = { x: x + 3, y: top + height - 3 }
  return {
    element: svg(
      'g',
      {},
      title !== '' && text(x, y + LINE_MM, LINE_MM, title, { 'font-weight': 700 }),
      svg('image', { href: shot.png, x, y: top, width, height }),
      svg('rect', { x, y: top, width, height, fill: 'none', stroke: '#d5dae1', 'stroke-width': 0.2 }),
      ...leaders,
      ...words.flat(),
      svg('line', { x1: foot.x, y1: foot.y, x2: foot.x + bar, y2: foot.y, stroke: INK, 'stroke-width': 0.6 }),
      text(foot.x, foot.y - 1.2, 0.85 * LINE_MM, `${BAR_MM} mm`),
    ),
    bottom: top + height,
  }
}

function tintLegend(kinds: readonly Kind[], top: number): SVGElement {
  const entries = kinds.flatMap(([colour, words], i) => {
    const x = ((i % COLUMNS) * WIDTH_MM) / COLUMNS
    const y = top + LEADING * LINE_MM * Math.floor(i / COLUMNS)
    return [
      svg('rect', { x, y: y - 0.8 * LINE_MM, width: LINE_MM, height: LINE_MM, fill: colour }),
      text(x + 1.4 * LINE_MM, y, LINE_MM, words),
    ]
  })
  return svg('g', {}, ...entries)
}

function scaleLegend(scale: Scale, y: number): SVGElement {
  const digits = scale.to - scale.from < 10 ? 1 : 0
  const ramp = svg(
    'linearGradient',
    { id: 'scale' },
    ...scale.stops.map((stop, i) =>
      svg('stop', { offset: i / (scale.stops.length - 1), 'stop-color': css(stop).replaceAll(' ', ', ') }),
    ),
  )
  return svg(
    'g',
    {},
    svg('defs', {}, ramp),
    text(0, y, LINE_MM, number(scale.from, digits)),
    svg('rect', { x: 12, y: y - 0.9 * LINE_MM, width: 50, height: LINE_MM, fill: 'url(#scale)' }),
    text(64, y, LINE_MM, `${number(scale.to, digits)} ${scale.unit}`),
    text(82, y, LINE_MM, scale.title),
  )
}
