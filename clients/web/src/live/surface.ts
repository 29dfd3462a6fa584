// What is told by colour of a valve that moves: tissue that prolapses, strain of chordae.
import type { ValveShape, Vector } from '../api/types'
import { at, dot, minus } from '../viewer/geometry'
import { colourOf, PULLED, rgb, type Rgb, type Scale } from '../viewer/colours'

export const ABOVE = '#7a3ff2' // tissue that prolapses
export const PROLAPSE_MM = 2 // above the annulus, from where it is called so

const BASE = 0.2 // of the way from annulus to free edge

export const STRAIN: Scale = { title: 'strain of chordae', unit: '%', from: 0, to: 15, stops: PULLED }

/// Of each vertex whether it prolapses: lies 2 mm or more above the annular plane and above the line between the two hinges of
/// its long axis, as echocardiography has it. What begins at the annulus bulges over it in healthy valves, too, and does not count.
export function prolapse(scene: ValveShape, nodes: ArrayLike<number>): boolean[] {
  const { plane, annulus, leaflet_coordinates } = scene
  const places = leaflet_coordinates.height.map((_, i): Vector => {
    const from = minus(at(nodes, i), plane.origin_mm)
    return [dot(from, plane.x), dot(from, plane.y), dot(from, plane.normal)]
  })
  const hinges = annulus.map((vertex) => places[vertex] as Vector)
  return places.map(([x, y, z], i) => {
    if (z < PROLAPSE_MM || (leaflet_coordinates.height[i] as number) < BASE) return false
    return z >= PROLAPSE_MM + lineHeight(hinges, x, y)
  })
}

/// At (x, y), of the line along y between the front and the back of an outline; without one minus infinity.
function lineHeight(outline: readonly Vector[], x: number, y: number): number {
  const ends: [y: number, z: number][] = []
  for (const [i, a] of outline.entries()) {
    const b = outline[(i + 1) % outline.length] as Vector
    if (a[0] < x === b[0] < x) continue
    const share = (x - a[0]) / (b[0] - a[0])
    ends.push([a[1] + share * (b[1] - a[1]), a[2] + share * (b[2] - a[2])])
  }
  ends.sort(([first], [second]) => first - second)
  const [back, front] = [ends[0], ends.at(-1)]
  if (!back || !front) return -Infinity
  const share = Math.min(Math.max((y - back[0]) / (front[0] - back[0] || 1), 0), 1)
  return back[1] + share * (front[1] - back[1])
}

/// Colours of the corners of Scene.faces, where it prolapses another one.
export function highlighted(scene: ValveShape, plain: Float32Array, isAbove: readonly boolean[]): Float32Array {
  const colours = plain.slice()
  const colour = rgb(ABOVE)
  for (const [corner, vertex] of scene.faces.entries()) if (isAbove[vertex]) colours.set(colour, 3 * corner)
  return colours
}

/// `strain`: a share of the rest length.
export function strainColour(strain: number): Rgb {
  return colourOf(STRAIN, 100 * strain)
}

/// The free edge's vertex in the middle of a segment, such as P2; -1 if there is none.
export function edgeOf(
  { segments, faces, leaflet_coordinates: { around, height } }: ValveShape,
  segment: string,
): number {
  const places = new Map<number, number>() // around, without the jump
  for (const [face, name] of segments.entries()) {
    if (name !== segment) continue
    for (const vertex of faces.slice(3 * face, 3 * face + 3)) {
      const at = around[vertex] as number
      const [first = at] = places.values()
      places.set(vertex, at - Math.round(at - first))
    }
  }
  const turns = [...places.values()]
  const middle = (Math.min(...turns) + Math.max(...turns)) / 2
  const edge = [...places].filter(([vertex]) => (height[vertex] as number) > 0.99)
  const [best] = edge.sort(([, a], [, b]) => Math.abs(a - middle) - Math.abs(b - middle))
  return best?.[0] ?? -1
}
