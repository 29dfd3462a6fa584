// What this browser asked of a job; the service's list of jobs does not tell.
import { store, stored } from '../state/stored'

const STORED = 'coapt-jobs-asked'

export interface JobNote {
  words: string // what was asked, in short
  limit_s: number | null // of its time
}

const notes = () => stored<Record<string, JobNote>>(STORED, {})

export function noteJob(id: string, note: JobNote): void {
  store(STORED, { ...notes(), [id]: note })
}

export function noteOf(id: string): JobNote | null {
  return notes()[id] ?? null
}

export function forgetJob(id: string): void {
  const { [id]: _, ...others } = notes()
  store(STORED, others)
}
