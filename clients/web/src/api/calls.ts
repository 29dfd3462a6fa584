// What the page asks of the service.
import { getJson, postJson, request } from './http'
import type {
  Closure,
  Evaluations,
  Farm,
  FileLookedAt,
  FileToImport,
  ImportRequest,
  Information,
  Observed,
  Job,
  Opening,
  Physiology,
  Plan,
  Preference,
  PreferenceAnswer,
  PreferenceCase,
  Problem,
  Rings,
  Scene,
  ValveDocument,
} from './types'

/// `valve`: a preset's name, a stored valve's id, or its document. `frames`: states of the closing, at most.
export function drawScene(
  valve: string | ValveDocument,
  plan: Plan | null,
  frames: number,
  signal?: AbortSignal,
): Promise<Scene> {
  return postJson('/v1/scenes', { valve, frames, ...(plan ? { plan } : {}) }, signal)
}

/// What is measured of it alone.
export function close(valve: string, plan: Plan | null, signal?: AbortSignal): Promise<Closure> {
  return postJson('/v1/closures', { valve, ...(plan ? { plan } : {}) }, signal)
}

/// How much time its leak is worth: the mesh as it is, a finer one, or finer and finer ones until the leak settles.
export const CERTAINTIES = ['quick', 'sure', 'proof'] as const
export type Certainty = (typeof CERTAINTIES)[number]

export function closeWith(
  certainty: Certainty,
  valve: string,
  plan: Plan | null,
  signal: AbortSignal,
): Promise<Closure> {
  return postJson('/v1/closures', { valve, certainty, ...(plan ? { plan } : {}) }, signal)
}

/// The same valve in diastole. `frames`: states of the opening, at most.
export function openValve(valve: string, plan: Plan | null, frames: number): Promise<Opening> {
  return postJson('/v1/openings', { valve, frames, ...(plan ? { plan } : {}) })
}

/// What is known of its leak over draws of tissue and chordae, and which measurement would tell most of it.
export function valueInformation(
  valve: string,
  plan: Plan | null,
  draws: number,
  signal: AbortSignal,
): Promise<Information> {
  return postJson('/v1/information', { valve, draws, ...(plan ? { plan } : {}) }, signal)
}

/// The document of the valve with these figures in place of those that were observed before.
export async function observeValve(valve: string, observed: Observed): Promise<string> {
  const isEmpty = Object.keys(observed).length === 0
  const asked = { valve, forget: true, ...(isEmpty ? {} : { observed }) }
  return (await request('POST', '/v1/valves:observe', asked)).text()
}

/// What it does beside what was measured in hearts: seconds of computing.
export function comparePhysiology(valve: string, signal: AbortSignal): Promise<Physiology> {
  return postJson('/v1/physiology', { valve }, signal)
}

export async function presets(): Promise<string[]> {
  const { presets } = await getJson<{ presets: { name: string }[] }>('/v1/presets')
  return presets.map((preset) => preset.name)
}

export function rings(): Promise<Rings> {
  return getJson('/v1/rings')
}

export function preset(name: string): Promise<ValveDocument> {
  return getJson(`/v1/presets/${encodeURIComponent(name)}`)
}

/// The id of a valve given as the text of its file.
export async function storeValve(text: string): Promise<string> {
  return (await postJson<{ id: string }>('/v1/valves', text)).id
}

/// What files of a segmentation tool hold.
export async function lookAtFiles(files: FileToImport[], signal: AbortSignal): Promise<FileLookedAt[]> {
  return (await postJson<{ files: FileLookedAt[] }>('/v1/imports:preview', { files }, signal)).files
}

/// A job that makes a valve of files.
export function startImport(files: ImportRequest): Promise<Job> {
  return postJson('/v1/imports', files)
}

export async function problemsOfValve(text: string): Promise<Problem[]> {
  return (await postJson<{ problems: Problem[] }>('/v1/valves:validate', text)).problems
}

export function evaluate(valve: string, plans: Plan[], region_points: number): Promise<Evaluations> {
  return postJson('/v1/evaluations', { valve, plans, region_points })
}

/// What the answers on plans of one search say of the weights, and the next question.
export function learnPreference(
  of: PreferenceCase,
  answers: PreferenceAnswer[],
  hide_figures: boolean,
  signal: AbortSignal,
): Promise<Preference> {
  return postJson('/v1/preferences', { cases: [of], answers, hide_figures }, signal)
}

/// One HTML page.
export async function report(valve: string, plans: Plan[], region_points: number, evidence: boolean): Promise<Blob> {
  return (await request('POST', '/v1/reports', { valve, plans, region_points, evidence })).blob()
}

/// The farm that the service hands its jobs to; ApiError 404 if it has none.
export function farm(): Promise<Farm> {
  return getJson('/v1/farm')
}

export function version(): Promise<{ version: string; farm: boolean; not_modelled: string[] }> {
  return getJson('/version')
}
