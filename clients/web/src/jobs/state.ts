// A job's state in words.
import type { Job, JobState } from '../api/types'
import { h } from '../dom'
import { counted } from '../format'
import parts from '../style/parts.module.css'

const WORDS: Record<JobState, [words: string, tone: string]> = {
  QUEUED: ['waiting', 'soft'],
  RUNNING: ['running', 'soft'],
  SUCCEEDED: ['done', 'good'],
  FAILED: ['failed', 'bad'],
  CANCELLED: ['cancelled', 'warn'],
}

export function stateBadge(state: JobState): HTMLElement {
  const [words, tone] = WORDS[state]
  return h('span', { class: `${parts.badge} ${parts[tone]}` }, words)
}

/// What a job that has not ended is waiting for or doing.
export function standing(job: Job): string {
  if (job.waiting_for) return `Paused: ${job.waiting_for}. The job resumes automatically.`
  if (job.state === 'QUEUED')
    return job.queue_position ? `Waiting: ${counted(job.queue_position, 'job')} ahead.` : 'Waiting in the queue.'
  return job.cancel_requested ? 'Stopping soon with the best result so far.' : ''
}
