// Files of plans: a list as the page saves it, or one coapt.plan/1.
import type { Plan } from '../api/types'
import type { KeptPlan } from '../state/kept_plans'
import { describe } from './steps'

export interface FoundPlan {
  plan: Plan
  name?: string
  valve?: string
}

export function planFile(kept: KeptPlan[]): Blob {
  const plans = kept.map(({ name, valve, plan }) => ({ name, valve, plan }))
  return new Blob([JSON.stringify({ plans }, null, 1)], { type: 'application/json' })
}

/// Those that cannot be said in words are no plans.
export function plansIn(text: string): FoundPlan[] {
  const json = parsed(text) as { plans?: Partial<FoundPlan>[] } & Partial<Plan>
  const entries = json.schema === 'coapt.plan/1' ? [{ plan: json as Plan }] : (json.plans ?? [])
  const plans = entries.filter((entry): entry is FoundPlan => isPlan(entry?.plan))
  if (plans.length === 0) throw new Error('the file contains no plan (coapt.plan/1)')
  return plans
}

function parsed(text: string): unknown {
  try {
    return JSON.parse(text)
  } catch {
    throw new Error('the file is not a JSON document')
  }
}

function isPlan(plan: Plan | undefined): boolean {
  try {
    return plan?.steps.map(describe).every((words) => typeof words === 'string') ?? false
  } catch {
    return false
  }
}
