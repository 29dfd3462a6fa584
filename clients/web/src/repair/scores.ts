// Kept plans closed with small errors of execution, one after the other, so that one sees how far it is.
import { evaluate } from '../api/calls'
import type { Plan, RankedPlan } from '../api/types'
import { doubts } from '../search/figures'
import { rankedCost } from '../search/price'

export const REGION_POINTS = 65 // closures a plan

/// In the order of `plans`; `done` is told how many are scored.
export async function scorePlans(
  valve: string,
  plans: Plan[],
  done: (count: number) => void,
): Promise<(RankedPlan | null)[]> {
  const scores: (RankedPlan | null)[] = []
  for (const plan of plans) {
    done(scores.length)
    const { plans: scored } = await evaluate(valve, [plan], REGION_POINTS)
    scores.push(scored[0] ?? null)
  }
  return scores
}

/// Index of the one that costs least; null where none has a cost.
export function bestOf(scores: (RankedPlan | null | undefined)[]): number | null {
  let best: number | null = null
  let least = Infinity
  scores.forEach((score, i) => {
    const cost = score ? rankedCost(score) : null
    if (cost === null || cost >= least) return
    best = i
    least = cost
  })
  return best
}

export function warningsOf(score: RankedPlan): string[] {
  return [...doubts(score), ...score.warnings]
}
