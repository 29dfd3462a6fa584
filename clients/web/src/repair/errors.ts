// Where a step of a plan may end instead of where it was planned: the ways that it can miss, and where its handle is then. Without drawing.
import type { LeafletPoint, Rings, Scene, Step, Vector } from '../api/types'
import {
  annulusPoint,
  at,
  closedNodes,
  distance,
  dot,
  leafletPlace,
  minus,
  onFace,
  papillaryTip,
  plus,
  times,
  unit,
} from '../viewer/geometry'
import { type Anatomy, anchorPoint, type Approximation } from './steps'

/// In this direction a step ends so many millimetres off.
export interface Way {
  name: string // "along the annulus"
  signs: readonly [less: string, more: string] // what an error below 0 is, and one above
}

/// Errors are in millimetres, one a way.
export interface Misses {
  name: string // of what misses
  unit: { mm: number; words: string } // the least error that is tried: "a millimetre", "a size"
  ways: Way[] // the first two span the surface
  stepAt(errors: readonly number[]): Step | null // null: nobody can do this
  placeAt(errors: readonly number[]): Vector | null // of the handle; null: there is no tissue
  around: boolean // the surface is a band all around the annulus, of the first way
}

type Ring = Extract<Step, { step: 'annuloplasty' }>
type Neochorda = Extract<Step, { step: 'neochorda' }>

const MILLIMETRE = { mm: 1, words: 'a millimetre' }
const SIZE = { mm: 2, words: 'one size' } // of the transverse dimension
const MOST_SIZES_BELOW = 6
const ROUNDING = 1e-9
const PART = 0.04 // of a turn of the annulus, a leaflet's width or height, over which a millimetre is measured

/// `handle`: which of the step's handles is grabbed, the first is 0. Null: of this step nothing can be varied.
export function missesOf(step: Step, handle: number, anatomy: Anatomy, rings: Rings): Misses | null {
  switch (step.step) {
    case 'annuloplasty':
      return ringMisses(step, anatomy.ringed, rings)
    case 'papillary_approximation':
      return sutureMisses(step, handle === 1, anatomy)
    case 'neochorda':
      return neochordaMisses(step, anatomy.ringed)
    default:
      return null
  }
}

function ringMisses(step: Ring, scene: Scene, { sizes_mm }: Rings): Misses {
  const middle = scene.plane.origin_mm
  const mid = at(scene.annulus_mm, Math.max(scene.annulus.indexOf(scene.landmarks.mid_posterior ?? -1), 0))
  const gain = distance(mid, middle) / scene.closure.annulus.al_pm_mm
  return {
    name: 'Ring size',
    unit: SIZE,
    ways: [{ name: 'size', signs: ['smaller', 'larger'] }],
    stepAt([error = 0]) {
      if ('sizes_below' in step) {
        const sizes_below = step.sizes_below - error / SIZE.mm
        const is = Number.isInteger(sizes_below) && sizes_below >= 0 && sizes_below <= MOST_SIZES_BELOW
        return is ? { ...step, sizes_below } : null
      }
      const size_mm = step.size_mm + error
      return size_mm >= sizes_mm.min && size_mm <= sizes_mm.max ? { ...step, size_mm } : null
    },
    placeAt: ([error = 0]) => plus(mid, times(gain * error, unit(minus(mid, middle)))),
    around: true,
  }
}

function sutureMisses(step: Approximation, isAnchor: boolean, { before, ringed }: Anatomy): Misses {
  const tip = papillaryTip(before, step.side)
  const anchor = anchorPoint(ringed, step)
  const around = step.anchor === 'annulus_point' ? step.annulus_around : aroundOf(ringed, anchor)
  const ends = [around - PART / 2, around + PART / 2].map((place) => annulusPoint(ringed, place)) as [Vector, Vector]
  const turn = PART / distance(...ends) // of a millimetre
  const anchorAt = (beside: number): Vector =>
    plus(anchor, minus(annulusPoint(ringed, around + turn * beside), annulusPoint(ringed, around)))
  return {
    name: `Suture, ${step.side}`,
    unit: MILLIMETRE,
    ways: [
      { name: 'length', signs: ['shorter', 'longer'] },
      { name: 'anchor along the annulus', signs: ['towards the posteromedial commissure', 'away from it'] },
    ],
    stepAt([longer = 0, beside = 0]) {
      const suture_length_mm = step.suture_length_mm + longer
      if (suture_length_mm > distance(tip, anchorAt(beside))) return null // it would push
      if (beside === 0) return { ...step, suture_length_mm }
      const { side } = step
      const annulus_around = (((around + turn * beside) % 1) + 1) % 1
      return { step: 'papillary_approximation', side, suture_length_mm, anchor: 'annulus_point', annulus_around }
    },
    /// The whole suture beside its place: its lower end follows the upper one, though the muscle would hardly.
    placeAt([longer = 0, beside = 0]) {
      const way = unit(minus(tip, anchor))
      return plus(anchorAt(beside), times(longer + (isAnchor ? 0 : step.suture_length_mm), way))
    },
    around: false,
  }
}

function neochordaMisses(step: Neochorda, scene: Scene): Misses {
  const nodes = closedNodes(scene)
  const { leaflet, along, height } = step.insertion
  const placed = (point: LeafletPoint): Vector | null => leafletPointPlace(scene, nodes, point)
  const partPer_mm = (one: LeafletPoint, other: LeafletPoint): number => {
    const [from, to] = [placed(one), placed(other)]
    return from && to ? PART / Math.max(distance(from, to), 1e-6) : 0
  }
  const inner = Math.max(height - PART, 0)
  const aside = along > 0.5 ? along - PART : along + PART
  const alongPer_mm = partPer_mm({ leaflet, along, height }, { leaflet, along: aside, height })
  const heightPer_mm = partPer_mm({ leaflet, along, height: inner + PART }, { leaflet, along, height: inner })
  const pointAt = (beside: number, up: number): LeafletPoint | null => {
    const point = { leaflet, along: along + alongPer_mm * beside, height: height + heightPer_mm * up }
    const is = point.along >= 0 && point.along <= 1 && point.height >= 0 && point.height <= 1 + ROUNDING
    return is ? { ...point, height: Math.min(point.height, 1) } : null
  }
  return {
    name: `Neochorda, ${step.head}`,
    unit: MILLIMETRE,
    ways: [
      { name: 'stitch along the leaflet', signs: ['anterolateral', 'posteromedial'] },
      { name: 'stitch towards the free edge', signs: ['annular', 'edge'] },
      { name: 'length', signs: ['shorter', 'longer'] },
    ],
    stepAt([beside = 0, up = 0, longer = 0]) {
      const insertion = pointAt(beside, up)
      return insertion && { ...step, insertion, length_mm: step.length_mm + longer }
    },
    placeAt([beside = 0, up = 0]) {
      const point = pointAt(beside, up)
      return point && placed(point)
    },
    around: false,
  }
}

/// Where a place of a leaflet is in the closed valve.
function leafletPointPlace(
  scene: Scene,
  nodes: ArrayLike<number>,
  { leaflet, along, height }: LeafletPoint,
): Vector | null {
  const { around, height: heights } = scene.leaflet_coordinates
  const SLACK = 1e-3
  for (let face = 0; 3 * face < scene.faces.length; ++face) {
    const corners = scene.faces.slice(3 * face, 3 * face + 3)
    const places = corners.map((vertex) => leafletPlace(around[vertex] as number))
    // Commissures belong to both leaflets.
    if (places.filter((place) => place.leaflet === leaflet).length < 2) continue
    const [a, b, c] = places.map((place, k) => [
      place.leaflet === leaflet ? place.along : Math.round(place.along),
      heights[corners[k] as number] as number,
    ]) as [[number, number], [number, number], [number, number]]
    const area = (b[0] - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (b[1] - a[1])
    const second = ((along - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (height - a[1])) / area
    const third = ((b[0] - a[0]) * (height - a[1]) - (along - a[0]) * (b[1] - a[1])) / area
    if (second >= -SLACK && third >= -SLACK && second + third <= 1 + SLACK)
      return onFace(scene, nodes, face, [1 - second - third, second, third])
  }
  return null
}

/// The place around the annulus that is nearest to a point.
export function aroundOf(scene: Scene, point: Vector): number {
  const places = Array.from({ length: 180 }, (_, i) => i / 180)
  const away = (around: number): number => distance(annulusPoint(scene, around), point)
  return places.reduce((best, place) => (away(place) < away(best) ? place : best))
}

/// Outwards from the middle of the annulus at each of its vertices, `mm` wider at the widest.
export function widened({ annulus_mm, plane, closure }: Scene, mm: number): Vector[] {
  const share = mm / closure.annulus.al_pm_mm
  return Array.from({ length: annulus_mm.length / 3 }, (_, i) => {
    const way = minus(at(annulus_mm, i), plane.origin_mm)
    const flat = minus(way, times(dot(way, plane.normal), plane.normal))
    return plus(at(annulus_mm, i), times(share, flat))
  })
}
