// What this browser asked of a job; the service's list of jobs does not tell.
import { store, stored } from '../state/stored'

const STORED = 'coapt-job-notes'

const notes = () => stored<Record<string, string>>(STORED, {})

export function noteJob(id: string, words: string): void {
  store(STORED, { ...notes(), [id]: words })
}

export function noteOf(id: string): string | null {
  return notes()[id] ?? null
}

export function forgetJob(id: string): void {
  const { [id]: _, ...others } = notes()
  store(STORED, others)
}
