// A job's state in words.
import type { Job, JobState } from '../api/types'
import { h } from '../dom'

const WORDS: Record<JobState, [words: string, tone: string]> = {
  QUEUED: ['waiting', 'soft'],
  RUNNING: ['running', 'soft'],
  SUCCEEDED: ['done', 'good'],
  FAILED: ['failed', 'bad'],
  CANCELLED: ['cancelled', 'warn'],
}

export function stateBadge(state: JobState): HTMLElement {
  const [words, tone] = WORDS[state]
  return h('span', { class: `badge ${tone}` }, words)
}

/// What a job that has not ended is waiting for or doing.
export function standing(job: Job): string {
  if (job.waiting_for) return `Stands still: ${job.waiting_for}. It goes on by itself.`
  if (job.state === 'QUEUED')
    return job.queue_position ? `Waits: ${job.queue_position} before it.` : 'Waits for its turn.'
  return job.cancel_requested ? 'Ends soon, with the best so far.' : ''
}
