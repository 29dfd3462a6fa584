// Jobs of the service: searches and studies.
import { getJson, postJson, request } from '../api/http'
import type { Job, JobFile } from '../api/types'

const PAGE_SIZE = 100

/// Of one kind, newest first; of the newest hundred of all jobs.
export async function jobsOf(kind: Job['kind']): Promise<Job[]> {
  const { jobs } = await getJson<{ jobs: Job[] }>(`/v1/jobs?page_size=${PAGE_SIZE}`)
  return jobs.filter((job) => job.kind === kind)
}

export function job(id: string): Promise<Job> {
  return getJson(`/v1/jobs/${id}`)
}

export function cancelJob(id: string): Promise<Job> {
  return postJson(`/v1/jobs/${id}:cancel`, {})
}

export async function removeJob(id: string): Promise<void> {
  await request('DELETE', `/v1/jobs/${id}`)
}

export async function filesOf(id: string): Promise<JobFile[]> {
  return (await getJson<{ files: JobFile[] }>(`/v1/jobs/${id}/files`)).files
}

export function hasEnded(state: Job['state']): boolean {
  return state === 'SUCCEEDED' || state === 'FAILED' || state === 'CANCELLED'
}
