// A job from now on: its state and progress, until it has ended.
import { follow } from '../api/events'
import type { Job, JobProgress, JobState } from '../api/types'
import { hasEnded, job } from './calls'

export interface Watcher {
  progress(progress: JobProgress): void // also those before now, one after the other
  changed(job: Job): void // a new state
}

/// Ends when the job has ended and its last state was told, or `signal` aborts.
export async function followJob(id: string, watcher: Watcher, signal: AbortSignal): Promise<void> {
  let latest = await job(id)
  if (signal.aborted) return
  watcher.changed(latest)
  if (hasEnded(latest.state)) return
  await follow(
    `/v1/jobs/${id}/events`,
    (event) => {
      if (signal.aborted) return
      if (event.event === 'progress') watcher.progress(JSON.parse(event.data) as JobProgress)
      if (event.event !== 'state') return
      const { state } = JSON.parse(event.data) as { state: JobState }
      if (hasEnded(state)) return // told below, with its results
      latest = { ...latest, state, queue_position: state === 'QUEUED' ? latest.queue_position : null }
      watcher.changed(latest)
    },
    signal,
  )
  if (signal.aborted) return
  watcher.changed(await job(id))
}
