// What this browser asked of a job; the service's list of jobs does not tell.
const STORED = 'coapt-job-notes'

function notes(): Record<string, string> {
  try {
    return JSON.parse(localStorage.getItem(STORED) ?? '{}') as Record<string, string>
  } catch {
    return {}
  }
}

export function noteJob(id: string, words: string): void {
  localStorage.setItem(STORED, JSON.stringify({ ...notes(), [id]: words }))
}

export function noteOf(id: string): string | null {
  return notes()[id] ?? null
}
