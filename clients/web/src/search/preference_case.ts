// What the service is told of the plans that are compared, and what it answers, in words and rows.
import type { LearnedWeights, Preference, PreferenceCase, RankedPlan } from '../api/types'
import { counted, percent } from '../format'
import { WEIGHTS } from './options'
import type { Weights } from './price'

const FEWEST = 3 // of two plans there is one question

/// Every plan has the amounts that weights multiply.
export function canBeCompared(plans: RankedPlan[]): boolean {
  return plans.length >= FEWEST && plans.every(({ cost_terms }) => cost_terms !== undefined)
}

/// By their ranks, which are their places there. Their leaks became amounts with the search's own share of the sd.
export function preferenceCase(
  name: string,
  plans: RankedPlan[],
  { sd_share }: Weights,
): PreferenceCase & { weights: Pick<Weights, 'sd_share'> } {
  const reduced = [...plans]
    .sort((a, b) => a.rank - b.rank)
    .map(({ cost_terms, description, leak_mm2, opening_area_mm2, durability_mm }) => ({
      cost_terms,
      description,
      leak_mm2: { mean: leak_mm2.mean },
      opening_area_mm2,
      durability_mm,
    }))
  return { schema: 'coapt.plans/2', name, weights: { sd_share }, plans: reduced }
}

export interface InformedWeight {
  label: string
  own: number
  learned: number
}

/// Those that the answers say something of, as the form of a search lists them.
export function informedWeights({ informed, weights }: LearnedWeights, own: Weights): InformedWeight[] {
  return WEIGHTS.flatMap(({ pointer, label }) => {
    const name = pointer.replace('/weights/', '') as keyof Weights
    const learned = weights[name]
    return informed.includes(name) && learned !== undefined ? [{ label, own: own[name], learned }] : []
  })
}

/// "3 questions answered. Plan 2 is most likely the one that you would prefer to all others (probability 61 %)."
export function standing({ first_places, learned }: Preference): string {
  const [first] = first_places
  if (learned.answers === 0 || !first) return 'No question answered yet.'
  return `${counted(learned.answers, 'question')} answered. Plan ${first.rank} is most likely your preferred plan (probability ${percent(first.probability)}).`
}
