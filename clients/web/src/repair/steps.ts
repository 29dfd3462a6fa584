// Steps of a repair plan: what they are called, what a new one is, what may be set of them.
import type { LeafletPoint, Plan, Scene, Side, Step, Vector } from '../api/types'
import { counted } from '../format'
import { annulusPoint, at, distance, leafletPlace, papillaryTip } from '../viewer/geometry'

export const SIDES: readonly (readonly [Side, string])[] = [
  ['anterolateral', 'Anterolateral'],
  ['posteromedial', 'Posteromedial'],
]
export const ANCHORS = [
  ['ipsilateral_trigone', 'Trigone of its side'],
  ['saddle_peak', 'Saddle peak'],
  ['annulus_point', 'A point on the annulus'],
] as const
export const MOVED_AT_FIRST = 0.85 // of the distance from tip to anchor: what a new suture leaves
export const NEOCHORDA_MM = { min: 5, max: 40, step: 0.5 }
export const EDGE_MM = { min: 2, max: 15, step: 0.5 }
export const EDGE_ALONG = { min: 0.05, max: 0.95, step: 0.01 }
export const EDGE_DEVICES = [
  ['stitch', 'Stitch (Alfieri)'],
  ['clip', 'Clip'],
  ['cleft_suture', 'Suture of a cleft'],
] as const
export const RESECTION_ALONG = { min: 0.15, max: 0.85, step: 0.01 }
export const RESECTION_HEIGHT = { min: 0.3, max: 0.95, step: 0.05 }
export const RESECTION_SHAPES = [
  ['triangular', 'Triangular'],
  ['quadrangular', 'Quadrangular'],
] as const
export const CHANGE_MM = { min: -20, max: 20, step: 0.5 }
const HALF_MM = 0.5
/// The middle of each segment's free edge.
export const FREE_EDGE: Readonly<Record<string, LeafletPoint>> = Object.fromEntries(
  (['anterior', 'posterior'] as const).flatMap((leaflet) =>
    [1, 2, 3].map((third) => [
      `${leaflet === 'anterior' ? 'A' : 'P'}${third}`,
      { leaflet, along: (2 * third - 1) / 6, height: 1 },
    ]),
  ),
)

export function hasRing(plan: Plan | null): boolean {
  return plan?.steps.some((step) => step.step === 'annuloplasty') ?? false
}

/// Steps that need nothing picked, as they are added first.
export const FIRST_STEPS = {
  Ring: { step: 'annuloplasty', shape: 'own', sizes_below: 2 },
  Resection: {
    step: 'leaflet_resection',
    shape: 'triangular',
    leaflet: 'posterior',
    along: 0.5,
    width_mm: 10,
    height: 0.7,
  },
  'Edge-to-edge': { step: 'edge_to_edge', device: 'clip', along: 0.5, width_mm: 4 },
} as const satisfies Record<string, Step>

/// `steps` with one more; a ring takes the place of the ring before.
export function withStep(steps: readonly Step[], added: Step): Step[] {
  const others = steps.filter(({ step }) => step !== 'annuloplasty' || added.step !== 'annuloplasty')
  return [...others, added]
}

export type Annuloplasty = Extract<Step, { step: 'annuloplasty' }>
export type EdgeToEdge = Extract<Step, { step: 'edge_to_edge' }>
export type Resection = Extract<Step, { step: 'leaflet_resection' }>
export type Approximation = Extract<Step, { step: 'papillary_approximation' }>

/// Of a ring that is not of the valve's own shape.
export function ringName(step: Exclude<Annuloplasty, { shape: 'own' }>): string {
  return step.shape === 'designed' ? `${step.ring.name} (designed)` : step.shape
}

/// Of a ring in the annulus's own shape.
export const undersizing = (sizes: number): string =>
  sizes === 0 ? 'not undersized' : `undersized by ${counted(sizes, 'size')}`

/// In surgical words.
export function describe(step: Step): string {
  switch (step.step) {
    case 'annuloplasty':
      return 'sizes_below' in step
        ? `Ring in the annulus's own shape, ${undersizing(step.sizes_below)}`
        : `Ring ${ringName(step)}, size ${step.size_mm} mm`
    case 'papillary_approximation':
      return `${step.side === 'anterolateral' ? 'Anterolateral' : 'Posteromedial'} papillary muscle to ${anchorWords(step)}, suture ${step.suture_length_mm.toFixed(1)} mm`
    case 'neochorda':
      return `Neochorda from ${step.head} to ${placeWords(step.insertion)}, ${step.length_mm.toFixed(1)} mm`
    case 'edge_to_edge':
      if (step.device === 'cleft_suture')
        return `Suture of the cleft at ${segmentAt('posterior', step.along)}, ${step.width_mm.toFixed(1)} mm from its root`
      return `${step.device === 'clip' ? 'Clip' : 'Edge-to-edge stitch'} from ${segmentAt('anterior', step.along)} to ${segmentAt('posterior', step.along)}, ${step.width_mm.toFixed(1)} mm wide`
    case 'leaflet_resection':
      return step.shape === 'triangular'
        ? `Triangular resection of ${segmentAt(step.leaflet, step.along)}, ${step.width_mm.toFixed(1)} mm wide, over ${Math.round(100 * step.height)} % of the height`
        : `Quadrangular resection of ${segmentAt('posterior', step.along)}, ${step.width_mm.toFixed(1)} mm wide, ${step.sliding ? 'with sliding plasty' : 'with plication'}`
    case 'chordal_length_change':
      return `Chorda ${step.chorda} ${step.change_mm < 0 ? 'shortened' : 'lengthened'} by ${Math.abs(step.change_mm).toFixed(1)} mm`
    case 'chordal_excision':
      return `Chorda ${step.chorda} cut`
    case 'chordal_transfer':
      return `Chorda ${step.chorda} transferred to ${placeWords(step.insertion)}`
  }
}

function anchorWords(step: Approximation): string {
  if (step.anchor === 'annulus_point') return `the annulus at ${Math.round(360 * step.annulus_around)}°`
  return step.anchor === 'saddle_peak' ? 'the saddle peak' : 'its trigone'
}

function segmentAt(leaflet: LeafletPoint['leaflet'], along: number): string {
  return `${leaflet === 'anterior' ? 'A' : 'P'}${along < 1 / 3 ? 1 : along < 2 / 3 ? 2 : 3}`
}

export function placeWords({ leaflet, along, height }: LeafletPoint): string {
  const level = height > 0.85 ? 'free edge' : height > 0.4 ? 'belly' : 'base'
  return `${segmentAt(leaflet, along)}, ${level}`
}

/// Widths that a resection may have, as far as they do not depend on the valve.
export function resectionWidths(step: Resection): { min: number; max: number; step: number } {
  const most = step.shape === 'triangular' ? (step.leaflet === 'anterior' ? 10 : 20) : step.sliding ? 30 : 15
  return { min: 3, max: most, step: 0.5 }
}

/// With another shape, leaflet or fate of the annulus, and a width that it may have.
export function reshaped(step: Resection): Resection {
  return { ...step, width_mm: within(step.width_mm, resectionWidths(step)) }
}

/// Where a suture of this kind is tied.
export function anchorPoint(scene: Scene, step: Approximation): Vector {
  if (step.anchor === 'annulus_point') return annulusPoint(scene, step.annulus_around)
  const landmark = step.anchor === 'saddle_peak' ? 'saddle_peak' : `${step.side}_trigone`
  const place = scene.annulus.indexOf(scene.landmarks[landmark] ?? -1)
  return at(scene.annulus_mm, Math.max(place, 0))
}

/// The valve before the repair, and with the ring of the plan if it has one: sutures are tied to the ringed annulus.
export interface Anatomy {
  before: Scene
  ringed: Scene
}

/// From half of the distance between tip and anchor (12 mm at least) to the whole of it (100 mm at most).
export function sutureRange(
  { before, ringed }: Anatomy,
  step: Approximation,
): { min: number; max: number; step: number } {
  const whole = distance(papillaryTip(before, step.side), anchorPoint(ringed, step))
  const max = Math.min(100, Math.floor(whole / HALF_MM) * HALF_MM)
  return { min: Math.min(max, Math.max(12, Math.ceil((0.5 * whole) / HALF_MM) * HALF_MM)), max, step: HALF_MM }
}

/// With the suture's length inside what its anchor allows.
export function reachable(anatomy: Anatomy, step: Approximation): Approximation {
  const { min, max } = sutureRange(anatomy, step)
  return { ...step, suture_length_mm: Math.min(Math.max(step.suture_length_mm, min), max) }
}

/// The nearest step of the range.
export function within(value: number, { min, max, step }: { min: number; max: number; step: number }): number {
  const near = min + step * Math.round(((Number.isFinite(value) ? value : min) - min) / step)
  return Number(Math.min(Math.max(near, min), max).toFixed(6))
}

/// With a suture of a length that is possible there.
export function newApproximation(
  anatomy: Anatomy,
  side: Side,
  anchor: Approximation['anchor'],
  annulus_around?: number,
): Approximation {
  const suture = { step: 'papillary_approximation', side, suture_length_mm: 0 } as const
  const usual = side === 'posteromedial' ? 0.1 : 0.4
  const step: Approximation =
    anchor === 'annulus_point' ? { ...suture, anchor, annulus_around: annulus_around ?? usual } : { ...suture, anchor }
  const { min, max } = sutureRange(anatomy, step)
  step.suture_length_mm = Math.max(min, Math.round((MOVED_AT_FIRST * max) / HALF_MM) * HALF_MM)
  return step
}

/// As long as from the head to where the other leaflet meets this place in the closed valve: a prolapsed edge comes down
/// to it.
export function newNeochorda(scene: Scene, head: string, insertion: LeafletPoint): Step {
  const tip = scene.heads.find(({ id }) => id === head)?.tip_mm ?? [0, 0, 0]
  const usual = distance(tip, partnerOf(scene, insertion))
  const length_mm = Math.min(Math.max(Math.round(usual / HALF_MM) * HALF_MM, NEOCHORDA_MM.min), NEOCHORDA_MM.max)
  return { step: 'neochorda', head, insertion, length_mm }
}

/// The vertex of the other leaflet that is nearest to this place in leaflet coordinates, in the closed valve.
function partnerOf(scene: Scene, { leaflet, along, height }: LeafletPoint): Vector {
  const { around, height: heights } = scene.leaflet_coordinates
  let least = Infinity
  let found = 0
  around.forEach((turn, vertex) => {
    const place = leafletPlace(turn)
    const away = Math.hypot(place.along - along, (heights[vertex] ?? 0) - height)
    if (place.leaflet === leaflet || away >= least) return
    least = away
    found = vertex
  })
  return at(scene.closed_mm ?? scene.rest_mm, found)
}
