// What was answered on the plans of a search, which this browser keeps by the job: the service keeps none of it.
import type { Job, PreferenceAnswer } from '../api/types'
import { store, stored } from './stored'

const KEY = 'coapt-preference-answers'
type ByJob = Record<Job['id'], PreferenceAnswer[]>

/// In the order given.
export function keptAnswers(job: Job['id']): PreferenceAnswer[] {
  return stored<ByJob>(KEY, {})[job] ?? []
}

export function keepAnswers(job: Job['id'], answers: PreferenceAnswer[]): void {
  const { [job]: _, ...others } = stored<ByJob>(KEY, {})
  store(KEY, answers.length > 0 ? { ...others, [job]: answers } : others)
}
