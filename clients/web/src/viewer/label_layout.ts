// Where words go so that none covers another or what must be seen. The most important word is placed first, as near to its
// place as it has room, rather away from what must be seen than across it; one without room near enough is left out.
// Pixels, y down.

export interface Box {
  left: number
  top: number
  right: number
  bottom: number
}

export interface Word {
  x: number // of its middle, where it would be best
  y: number
  width: number
  height: number
  rank: number // the lowest is placed first
  reach: number // how far it may be moved, px
}

export interface Spot {
  x: number
  y: number
  isMoved: boolean
}

const GAP = 3 // between words
const RINGS = [14, 22, 32, 44, 58, 74, 92, 112, 134, 158] // px
const DIRECTIONS = 16

/// In the order of `words`; null: left out. `kept`: what must be seen, the most important first.
export function layOut(words: Word[], kept: Box[], size: { width: number; height: number }): (Spot | null)[] {
  const taken = [...kept]
  const spots: (Spot | null)[] = words.map(() => null)
  const order = words.map((_, i) => i).sort((a, b) => rankOf(words, a) - rankOf(words, b))
  for (const i of order) {
    const word = words[i] as Word
    const spot = candidates(word, kept[0]).find((place) => isFree(boxOf(place, word), taken, size))
    if (!spot) continue
    spots[i] = spot
    taken.push(boxOf(spot, word))
  }
  return spots
}

/// Around `points`; null if there are none.
export function around(points: readonly { x: number; y: number }[]): Box | null {
  if (points.length === 0) return null
  const xs = points.map(({ x }) => x)
  const ys = points.map(({ y }) => y)
  return { left: Math.min(...xs), top: Math.min(...ys), right: Math.max(...xs), bottom: Math.max(...ys) }
}

/// Of elements that lie over a canvas, in its pixels.
export function boxesOver(canvas: Element, elements: readonly (Element | null)[]): Box[] {
  const { x, y } = canvas.getBoundingClientRect()
  return elements.flatMap((element) => {
    const box = element?.getBoundingClientRect()
    return box && box.width > 0
      ? [{ left: box.left - x, top: box.top - y, right: box.right - x, bottom: box.bottom - y }]
      : []
  })
}

export function overlap(a: Box, b: Box): boolean {
  return a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom
}

function rankOf(words: Word[], i: number): number {
  return (words[i] as Word).rank
}

/// Its own place, then rings around it, what is farther from `seen` first; else above and below first: words are wide.
function candidates({ x, y, width, height, reach }: Word, seen: Box | undefined): Spot[] {
  const spots: Spot[] = [{ x, y, isMoved: false }]
  const turns = Array.from({ length: DIRECTIONS }, (_, k) => (k % 2 === 0 ? k : -k - 1) / DIRECTIONS + 0.5)
  const ways = turns.map((turn) => [Math.cos(turn * Math.PI), Math.sin(turn * Math.PI)] as const)
  if (seen) {
    const [across, along] = [x - (seen.left + seen.right) / 2, y - (seen.top + seen.bottom) / 2]
    ways.sort((a, b) => b[0] * across + b[1] * along - a[0] * across - a[1] * along)
  }
  for (const ring of RINGS.filter((radius) => radius <= reach))
    for (const [across, along] of ways)
      spots.push({ x: x + across * (ring + width / 2), y: y + along * (ring + height / 2), isMoved: true })
  return spots
}

function boxOf({ x, y }: { x: number; y: number }, { width, height }: Word): Box {
  return { left: x - width / 2, top: y - height / 2, right: x + width / 2, bottom: y + height / 2 }
}

function isFree(box: Box, taken: Box[], { width, height }: { width: number; height: number }): boolean {
  if (box.left < 0 || box.top < 0 || box.right > width || box.bottom > height) return false
  const wide = { left: box.left - GAP, top: box.top - GAP, right: box.right + GAP, bottom: box.bottom + GAP }
  return !taken.some((other) => overlap(wide, other))
}
