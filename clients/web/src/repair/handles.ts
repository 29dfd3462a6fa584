// What of a plan can be grabbed on the repaired valve: both ends of a suture, where a neochorda inserts, the ring. Without
// drawing.
import type { LeafletPoint, Plan, Rings, Scene, Step, Vector } from '../api/types'
import { at, closedNodes, distance, minus, onFace, unit } from '../viewer/geometry'
import type { Drag, Handle } from '../viewer/handles'
import { aroundOf } from './errors'
import {
  type Approximation,
  anchorPoint,
  placeWords,
  reachable,
  sutureRange,
  undersizing,
  within,
  type Anatomy,
} from './steps'

type Ring = Extract<Step, { step: 'annuloplasty' }>
type Neochorda = Extract<Step, { step: 'neochorda' }>
type Unkeyed = Omit<Handle<Step>, 'key'>
type Range = { min: number; max: number; step: number }

const PLACE = { min: 0, max: 1, step: 0.01 } // along a leaflet and towards its free edge
const ANCHOR = { min: 0, max: 358, step: 2 } // degrees around the annulus
const SIZES_BELOW = { min: 0, max: 6, step: 1 }
const SIZE_MM = 2 // of the transverse dimension

export interface StepHandle {
  step: number // of the plan, the first is 0
  handle: Handle<Step>
}

/// Of the steps of `plan`, whose closure is `anatomy.ringed`.
export function handlesOf(plan: Plan, anatomy: Anatomy, { sizes_mm }: Rings): StepHandle[] {
  let neochordae = 0
  return plan.steps.flatMap((step, i) => {
    const named = (handle: Unkeyed): StepHandle => {
      return { step: i, handle: { ...handle, key: `${i} ${handle.name}` } }
    }
    if (step.step === 'annuloplasty') return [named(ringHandle(step, anatomy.ringed, sizes_mm))]
    if (step.step === 'papillary_approximation')
      return [named(sutureHandle(step, anatomy)), named(anchorHandle(step, anatomy))]
    if (step.step !== 'neochorda') return []
    const at_mm = insertion(anatomy.ringed, neochordae++)
    return at_mm ? [named(insertionHandle(step, at_mm))] : []
  })
}

/// A value that grows along `way` from `at_mm`, by `gain` a millimetre.
function along(
  at_mm: Vector,
  way: Vector,
  { value, range, gain }: { value: number; range: Range; gain: number },
  set: (value: number) => Step,
): Pick<Handle<Step>, 'at_mm' | 'value' | 'range' | 'dragged' | 'stepped'> {
  const to = (next: number): Step => set(within(next, range))
  return {
    at_mm,
    value,
    range,
    dragged: (drag: Drag) => to(value + gain * drag.mmAlong(at_mm, way)),
    stepped: (across: number, up: number) => to(value + (across + up) * range.step),
  }
}

function ringHandle(step: Ring, scene: Scene, sizes_mm: Range): Unkeyed {
  const at_mm = at(scene.annulus_mm, Math.max(scene.annulus.indexOf(scene.landmarks.mid_posterior ?? -1), 0))
  const radius = minus(at_mm, scene.plane.origin_mm)
  // The ring keeps its shape: of a size all lengths are as many times as long.
  const gain = scene.closure.annulus.al_pm_mm / distance(at_mm, scene.plane.origin_mm)
  const words = (ring: Step): string =>
    ring.step !== 'annuloplasty'
      ? ''
      : 'sizes_below' in ring
        ? undersizing(ring.sizes_below)
        : `size ${ring.size_mm} mm`
  const value =
    'sizes_below' in step
      ? along(
          at_mm,
          unit(radius),
          { value: step.sizes_below, range: SIZES_BELOW, gain: -gain / SIZE_MM },
          (sizes_below) => ({ step: 'annuloplasty', shape: 'own', sizes_below }),
        )
      : along(at_mm, unit(radius), { value: step.size_mm, range: sizes_mm, gain }, (size_mm) => ({ ...step, size_mm }))
  return { name: 'Ring size', words, ...value }
}

function sutureHandle(step: Approximation, anatomy: Anatomy): Unkeyed {
  const anchor = anchorPoint(anatomy.ringed, step)
  const tip = anatomy.ringed.sutures.find(({ side }) => side === step.side)?.tip_mm ?? anchor
  const range = sutureRange(anatomy, step)
  const words = (next: Step): string =>
    next.step === 'papillary_approximation' ? `suture ${next.suture_length_mm.toFixed(1)} mm` : ''
  const length = along(
    tip,
    unit(minus(tip, anchor)),
    { value: step.suture_length_mm, range, gain: 1 },
    (suture_length_mm) => ({ ...step, suture_length_mm }),
  )
  return { name: `Suture length, ${step.side}`, words, ...length }
}

function anchorHandle(step: Approximation, anatomy: Anatomy): Unkeyed {
  const at_mm = anchorPoint(anatomy.ringed, step)
  const value = 360 * (step.anchor === 'annulus_point' ? step.annulus_around : aroundOf(anatomy.ringed, at_mm))
  const { side, suture_length_mm } = step
  const to = (degrees: number): Step => {
    const annulus_around = (ANCHOR.step * Math.round((((degrees % 360) + 360) % 360) / ANCHOR.step)) / 360
    const tied = { step: 'papillary_approximation', side, suture_length_mm, anchor: 'annulus_point' } as const
    return reachable(anatomy, { ...tied, annulus_around: annulus_around % 1 })
  }
  return {
    name: `Suture anchor, ${side}`,
    at_mm,
    value,
    range: ANCHOR,
    words: (next) =>
      next.step === 'papillary_approximation' && next.anchor === 'annulus_point'
        ? `anchor at ${Math.round(360 * next.annulus_around)}°, suture ${next.suture_length_mm.toFixed(1)} mm`
        : `anchor at ${Math.round(value)}°`,
    dragged: (drag) => to(360 * drag.around()),
    stepped: (across, up) => to(value + (across + up) * ANCHOR.step),
  }
}

function insertionHandle(step: Neochorda, at_mm: Vector): Unkeyed {
  const to = ({ leaflet, along: side, height }: LeafletPoint): Step => {
    return { ...step, insertion: { leaflet, along: within(side, PLACE), height: within(height, PLACE) } }
  }
  const { leaflet, along: side, height } = step.insertion
  return {
    name: `Neochorda insertion, ${step.head}`,
    at_mm,
    value: side,
    range: PLACE,
    words: (next) =>
      next.step === 'neochorda'
        ? `${placeWords(next.insertion)}: along ${next.insertion.along.toFixed(2)}, height ${next.insertion.height.toFixed(2)}`
        : '',
    dragged: (drag) => {
      const point = drag.leaflet()
      return point && to(point)
    },
    stepped: (across, up) => to({ leaflet, along: side + across * PLACE.step, height: height + up * PLACE.step }),
  }
}

/// Where the neochorda that is the `index`th of the plan inserts.
function insertion(scene: Scene, index: number): Vector | null {
  const end = scene.chordae.filter(({ kind }) => kind === 'neochorda')[index]?.segments.at(-1)
  if (end?.face === undefined) return null
  return onFace(scene, closedNodes(scene), end.face, end.weights ?? [1, 0, 0])
}
