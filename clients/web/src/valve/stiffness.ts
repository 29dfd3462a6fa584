// How sure the closed shape is: the valve closed with leaflets from soft to stiff, within what the model's sources allow. In
// functional regurgitation more than half of the tissue's part of the error is theirs (docs/researcher/accuracy.md). No answer
// holds the closed shapes of the draws behind the tissue interval, which vary all of tissue and chordae at once.
import { drawScene } from '../api/calls'
import type { Scene, ValveDocument } from '../api/types'
import { intervalWords, type Interval } from '../estimate'
import { withUnit } from '../format'
import { valveText } from '../state/valves'
import { closedNodes } from '../viewer/geometry'

/// Of the moduli above the transition, times the valve's own (search/model_draw.cpp).
const RANGE = { lower: 0.5, upper: 3 }
const SHARES = [0.05, 0.275, 0.5, 0.725, 0.95] // of the draws that are softer

export interface Variant {
  factor: number // of the valve's own stiffness
  scene: Scene
}

/// At a share of the draws; 1 at a half.
export function stiffnessAt(share: number): number {
  return (share < 0.5 ? RANGE.lower : RANGE.upper) ** Math.abs(2 * share - 1)
}

/// From soft to stiff, those that are closed.
export async function stiffnessVariants(reference: string, signal: AbortSignal): Promise<Variant[]> {
  const valve = JSON.parse(await valveText(reference)) as ValveDocument
  const { tissue, fit } = valve
  if (fit?.parameters.some((name) => name.startsWith('stiffness')))
    throw new Error('The stiffness of this valve was fitted to its closed shape, and is not varied.')
  const variants: Variant[] = []
  for (const factor of SHARES.map(stiffnessAt)) {
    const changed = {
      ...tissue,
      radial_post_kpa: factor * tissue.radial_post_kpa,
      circumferential_post_kpa: factor * tissue.circumferential_post_kpa,
    }
    const scene = await drawScene({ ...valve, tissue: changed }, null, 0, signal)
    if (scene.closure.status === 'converged' && !scene.closure.crossing) variants.push({ factor, scene })
  }
  if (variants.length < 2) throw new Error('Too few of the variants close to tell how sure the shape is.')
  return variants
}

/// One scene that moves through the closed shapes of all: Scene.motion_mm from the first to the last.
export function breathing(variants: readonly Variant[]): Scene {
  const last = variants.at(-1) as Variant
  return { ...last.scene, motion_mm: variants.map(({ scene }) => [...closedNodes(scene)]) }
}

/// "Leaflets 0.5 times as stiff: leak 81 mm²".
export function variantWords({ factor, scene }: Variant): string {
  const leaflets = factor === 1 ? 'Leaflets as stiff as in the file' : `Leaflets ${factor.toFixed(1)} times as stiff`
  return `${leaflets}: leak ${withUnit(scene.closure.leak.area_mm2, 'mm²', 0)}`
}

/// "Their stiffness alone changes the leak from 30 to 81 mm²; all of tissue and chordae leave it between 37 and 83 mm²."
export function spreadWords(variants: readonly Variant[], interval: Interval | null): string {
  const leaks = variants.map(({ scene }) => scene.closure.leak.area_mm2 ?? NaN).filter(Number.isFinite)
  const whole = (value: number): string => value.toFixed(0)
  const alone = `The stiffness of the leaflets alone changes the leak from ${whole(Math.min(...leaks))} to ${whole(Math.max(...leaks))} mm²`
  if (!interval) return `${alone}.`
  return `${alone}; all that is not known of tissue and chordae leaves it at ${intervalWords(interval)} mm² (5 to 95 %).`
}
