// What is told by colour of a valve that moves: tissue that prolapses, strain of chordae.
import type { ValveShape } from '../api/types'
import { colourOf, rgb, heights, RISING, type Rgb, type Scale } from '../viewer/colours'

export const ABOVE = '#7a3ff2' // tissue that prolapses
export const PROLAPSE_MM = 2 // above the annulus, from where it is called so

export const STRAIN: Scale = { title: 'strain of chordae', unit: '%', from: 0, to: 15, stops: RISING }

/// Of each vertex whether it prolapses: lies 2 mm or more above a surface that begins at the annulus, which is a saddle and
/// itself above its plane at the peaks, and is that plane at the free edge. `beside`: annulusBeside().
export function prolapse(scene: ValveShape, nodes: ArrayLike<number>, beside: readonly number[]): boolean[] {
  const z = heights(scene, nodes)
  const { height } = scene.leaflet_coordinates
  return beside.map(
    (vertex, i) => (z[i] as number) >= PROLAPSE_MM + (1 - (height[i] as number)) * (z[vertex] as number),
  )
}

/// Of each vertex the vertex of the annulus that is nearest around.
export function annulusBeside({ annulus, leaflet_coordinates: { around } }: ValveShape): number[] {
  const apart = (a: number, b: number): number => {
    const way = Math.abs((around[a] as number) - (around[b] as number))
    return Math.min(way, 1 - way)
  }
  return around.map((_, i) => annulus.reduce((best, vertex) => (apart(i, vertex) < apart(i, best) ? vertex : best)))
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
