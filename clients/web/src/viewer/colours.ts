// What colours mean. Scales are readable to colour-blind people and in both themes.
import type { Scene, Segment, ValveShape } from '../api/types'
import { at, dot, minus, vertexCount } from './geometry'

export type Rgb = [number, number, number] // 0 to 1, sRGB

export type ColourMode = 'leaflets' | 'strain_circumferential' | 'strain_radial' | 'height' | 'tension'

export const COLOUR_MODES: readonly (readonly [ColourMode, string])[] = [
  ['leaflets', 'Leaflets'],
  ['strain_circumferential', 'Circumferential strain'],
  ['strain_radial', 'Radial strain'],
  ['height', 'Height above the annulus'],
  ['tension', 'Chordal tension'],
]

/// As in reports and pictures (io/picture/canvas.h; a test compares), but for ruptured chordae.
export const TINTS = {
  anterior: '#e8998a',
  posterior: '#f2c491',
  commissure: '#c39bb4',
  opening: '#1668d6',
  ruptured: '#c8342b',
  added: '#0f8a5f',
  ring: '#e4e7ec',
  annulus: '#29384d',
  chorda: '#8c7861',
  papillary: '#943f3d',
  surface: '#9db4d6', // of a file, its leaflets not told apart
} as const
const OUTER_THIRDS = 0.22 // of the way to white, so that segments can be told apart
const CUT_EDGE = 0.7 // as bright as the leaflet

const SEGMENTS: Record<Segment, Rgb> = {
  A1: paler(TINTS.anterior),
  A2: rgb(TINTS.anterior),
  A3: paler(TINTS.anterior),
  P1: paler(TINTS.posterior),
  P2: rgb(TINTS.posterior),
  P3: paler(TINTS.posterior),
  AC: rgb(TINTS.commissure),
  PC: rgb(TINTS.commissure),
}
const TISSUE: Rgb = rgb('#cdb7b0')
export const RISING = ['#2c1160', '#711f81', '#b63679', '#ee605e', '#fdae78', '#fcfdbf'].map(rgb) // after matplotlib's magma
/// Of chordae, thin lines over tissue and both grounds: each stop has a contrast of 2.9 or more against light and dark.
export const PULLED = ['#6f7b89', '#a8842c', '#d9660f', '#d02c16'].map(rgb)
export const BALANCED = ['#2166ac', '#92c5de', '#f0eee8', '#f4a582', '#b2182b'].map(rgb) // after ColorBrewer's RdBu

/// Of an opening, by its width: the same blue, so that it is known for one; wider ones are as dark as 8 mm.
export const OPEN: Scale = {
  title: 'width of the opening',
  unit: 'mm',
  from: 0,
  to: 8,
  stops: ['#9cc6ff', TINTS.opening, '#062a6b'].map(rgb),
}

export interface Scale {
  title: string
  unit: string
  from: number
  to: number
  stops: Rgb[]
}

export function rgb(hex: string): Rgb {
  const value = Number.parseInt(hex.slice(1), 16)
  return [(value >> 16) / 255, ((value >> 8) & 255) / 255, (value & 255) / 255]
}

/// Shaders work with linear light.
export function toLinear(part: number): number {
  return part <= 0.04045 ? part / 12.92 : ((part + 0.055) / 1.055) ** 2.4
}

function paler(hex: string): Rgb {
  return rgb(hex).map((part) => part + OUTER_THIRDS * (1 - part)) as Rgb
}

/// Where a leaflet is cut.
export function cutColour(segment: Segment): Rgb {
  return SEGMENTS[segment].map((part) => CUT_EDGE * part) as Rgb
}

export function css(colour: Rgb): string {
  return `rgb(${colour.map((part) => Math.round(255 * part)).join(' ')})`
}

/// Values outside the scale get its ends.
export function colourOf(scale: Scale, value: number): Rgb {
  const { stops } = scale
  const share = scale.to > scale.from ? (value - scale.from) / (scale.to - scale.from) : 0
  const place = Math.min(Math.max(share, 0), 1) * (stops.length - 1)
  const first = Math.min(Math.floor(place), stops.length - 2)
  const [a, b] = [stops[first] as Rgb, stops[first + 1] as Rgb]
  return [0, 1, 2].map((k) => (a[k] as number) + (place - first) * ((b[k] as number) - (a[k] as number))) as Rgb
}

function upTo(values: number[], share: number): number {
  const sorted = values.filter(Number.isFinite).sort((a, b) => a - b)
  return sorted[Math.floor(share * (sorted.length - 1))] ?? 0
}

/// The scale of a mode over all these scenes, so that they can be compared; null: none is needed.
export function scaleOf(mode: ColourMode, scenes: Scene[]): Scale | null {
  switch (mode) {
    case 'leaflets':
      return null
    case 'strain_circumferential':
    case 'strain_radial': {
      const part = mode === 'strain_radial' ? 'radial' : 'circumferential'
      const all = scenes.flatMap((scene) => scene.strain?.[part] ?? [])
      return {
        title: `${part} strain of the closed valve`,
        unit: '%',
        from: 0,
        to: 100 * Math.max(upTo(all, 0.99), 0.01),
        stops: RISING,
      }
    }
    case 'height': {
      const most = Math.max(
        1,
        ...scenes.map((scene) => upTo(heights(scene, scene.closed_mm ?? scene.rest_mm).map(Math.abs), 0.95)),
      )
      return { title: 'height above the annular plane', unit: 'mm', from: -most, to: most, stops: BALANCED }
    }
    case 'tension': {
      const all = scenes.flatMap((scene) => scene.chordae.flatMap((c) => c.segments.map((s) => s.tension_n ?? 0)))
      return { title: 'chordal tension, valve closed', unit: 'N', from: 0, to: Math.max(0.1, ...all), stops: PULLED }
    }
  }
}

function heights({ plane, rest_mm }: ValveShape, nodes: ArrayLike<number>): number[] {
  return Array.from({ length: rest_mm.length / 3 }, (_, i) => dot(minus(at(nodes, i), plane.origin_mm), plane.normal))
}

/// One colour for each corner of each face; `nodes` is the state that is drawn.
export function cornerColours(
  scene: ValveShape,
  mode: ColourMode,
  scale: Scale | null,
  nodes: ArrayLike<number>,
): Float32Array {
  const colours: number[] = []
  const values = vertexValues(scene, mode, nodes)
  for (let face = 0; face < scene.segments.length; ++face)
    for (let k = 0; k < 3; ++k) {
      const value = values?.[scene.faces[3 * face + k] as number]
      if (mode === 'leaflets' || !scale) colours.push(...SEGMENTS[scene.segments[face] as Segment])
      else colours.push(...(value === undefined ? TISSUE : colourOf(scale, value)))
    }
  return Float32Array.from(colours)
}

/// What a mode shows at each vertex, in the unit of its scale: strain is the mean over the faces around it. Null: nothing.
export function vertexValues(scene: ValveShape, mode: ColourMode, nodes: ArrayLike<number>): number[] | null {
  if (mode === 'height') return heights(scene, nodes)
  if (mode !== 'strain_radial' && mode !== 'strain_circumferential') return null
  const strain = scene.strain?.[mode === 'strain_radial' ? 'radial' : 'circumferential']
  if (!strain) return null
  const sums = new Float64Array(vertexCount(scene))
  const counts = new Float64Array(sums.length)
  for (const [corner, vertex] of scene.faces.entries()) {
    ;(sums[vertex] as number) += 100 * (strain[Math.floor(corner / 3)] as number)
    ;(counts[vertex] as number) += 1
  }
  return Array.from(sums, (sum, i) => sum / Math.max(counts[i] as number, 1))
}

const CHORDAE: Record<string, Rgb> = {
  marginal: rgb('#978a72'),
  strut: rgb('#7a6d5b'),
  basal: rgb('#ac9f87'),
  neochorda: rgb(TINTS.added),
}

/// One colour for each end of each segment, in the order of chordaLines().
export function chordaColours(scene: Scene, mode: ColourMode, scale: Scale | null): number[] {
  const colours: number[] = []
  for (const chorda of scene.chordae)
    for (const segment of chorda.segments) {
      const plain = chorda.ruptured ? rgb(TINTS.ruptured) : (CHORDAE[chorda.kind] as Rgb)
      const colour = mode === 'tension' && scale && !chorda.ruptured ? colourOf(scale, segment.tension_n ?? 0) : plain
      colours.push(...colour, ...colour)
    }
  return colours
}
