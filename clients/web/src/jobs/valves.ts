// Which valve a job is about. Jobs name it by its content; this page opened it by another name.
import { preset, presets } from '../api/calls'
import { getJson } from '../api/http'
import type { Job, ValveDocument } from '../api/types'
import type { ValveSource, Workspace } from '../workspace'

const STORED = 'coapt-valves-of-jobs'
const asked = new Map<string, Promise<ValveSource>>()

function known(): Record<string, ValveSource> {
  try {
    return JSON.parse(localStorage.getItem(STORED) ?? '{}') as Record<string, ValveSource>
  } catch {
    return {}
  }
}

/// After a job was started for `source`.
export function rememberValve(id: string, source: ValveSource): void {
  localStorage.setItem(STORED, JSON.stringify({ ...known(), [id]: source }))
}

/// By what a job's valve is opened, and what it is called.
export function valveOf(job: Job): Promise<ValveSource> {
  const before = known()[job.valve]
  if (before) return Promise.resolve(before)
  const answer = asked.get(job.valve) ?? nameOf(job.valve)
  asked.set(job.valve, answer)
  return answer
}

async function nameOf(id: string): Promise<ValveSource> {
  const short = `valve ${id.slice(0, 8)}`
  try {
    const document = await getJson<ValveDocument>(`/v1/valves/${id}`)
    const { name } = document
    const isPreset = name !== undefined && (await presets()).includes(name) && sameValve(document, await preset(name))
    return { reference: isPreset ? name : id, label: name || short }
  } catch {
    return { reference: id, label: short }
  }
}

function sameValve(a: ValveDocument, b: ValveDocument): boolean {
  return JSON.stringify({ ...a, notice: null }) === JSON.stringify({ ...b, notice: null })
}

/// Makes a job's valve the page's, if it is another.
export async function openValveOf(job: Job, workspace: Workspace): Promise<void> {
  const source = await valveOf(job)
  if (workspace.valve?.reference !== source.reference && workspace.valve?.reference !== job.valve)
    await workspace.open(source)
}
