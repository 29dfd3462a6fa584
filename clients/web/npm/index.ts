/**
 * coapt: closes mitral valves, measures what leaks, and searches for repairs, in this process: nothing leaves the machine.
 * Research software, not a medical device; not for clinical decisions.
 */
import type { components } from '../src/api/openapi.js'
import type {
  Closure,
  Evaluations,
  Opening,
  Plan,
  Scene,
  SearchProgress,
  SearchResult,
  ValveDocument,
} from '../src/api/types.js'
import { Threads } from '../src/engine/threads'
import { startThread } from './start'

export type { Closure, Evaluations, Opening, Plan, Scene, SearchProgress, ValveDocument }
type Schemas = components['schemas']
export type Material = Schemas['Material']
export type Search = Schemas['Search']
export type Diagnosis = Schemas['DiagnosisDocument']
export type Plans = SearchResult
export type Observations = NonNullable<ValveDocument['observed']>
export type Problem = Schemas['Fault']

/** What was refused, and every reason with its place in the request. */
export class CoaptError extends Error {
  override readonly name = 'CoaptError'

  constructor(
    /** As of HTTP: 422 for what a request says, 400 for what is no JSON, 404 for a path that is unknown. */
    readonly status: number,
    readonly problems: readonly Problem[],
  ) {
    super(problems.map(({ path, message }) => (path ? `${path}: ${message}` : message)).join('\n'))
  }
}

/** Of any request. */
export interface Waiting {
  /** Ends the computing at once; the promise rejects with the signal's reason. */
  signal?: AbortSignal
}

export interface Searching extends Waiting {
  /** Of closures; `planned` may grow and shrink while plans are dropped. `now`: stage, best plan so far and its leak. */
  progress?: (done: number, planned: number, now: SearchProgress) => void
  /** Ends a search with the best plans so far; on pages that are not cross-origin isolated as `signal` does. */
  finish?: AbortSignal
}

/** A repair before what is asked for, and the material in place of the valve's own. */
export interface Repaired {
  plan?: Plan
  material?: Material
}

export interface CloseOptions extends Repaired {
  method?: 'fast' | 'thesis'
  membrane?: 'continuum' | 'springs'
  /** Largest error of the leak, mm²: refines the mesh and chooses the tolerances. */
  accuracy_mm2?: number
  /** Closes on finer and finer meshes until the leak settles. */
  converge?: { within_mm2?: number; most_vertices?: number }
  /** Also opens the valve as in diastole. */
  open?: boolean
}

export interface OpenOptions extends Repaired {
  /** Of the atrium over the ventricle at the peak of filling, [1, 30]; left out: what the flow needs. */
  pressure_mmhg?: number
  /** Mean flow of filling at rest, [10, 1000]. */
  flow_ml_s?: number
  /** Flow at exercise over that at rest, [1, 5]. */
  exercise?: number
  /** States on the way, [0, 60]. */
  frames?: number
}

export interface LoadOptions {
  /**
   * Requests that are computed at the same time, each by a thread of its own; others wait. A search takes all that are idle, but in
   * browsers on pages that are not cross-origin isolated, and has the same plans with any number. Default: 2.
   */
  threads?: number
}

/** Loads the module beside this file. */
export async function load({ threads = 2 }: LoadOptions = {}): Promise<Coapt> {
  if (!Number.isInteger(threads) || threads < 1) throw new RangeError('threads: must be an integer from 1')
  const module = await WebAssembly.compile(await bytesOf('coapt-planner.wasm'))
  const names = JSON.parse(new TextDecoder().decode(await bytesOf('presets/index.json'))) as string[]
  return new Coapt(new Threads(async () => module, threads, startThread), names)
}

async function bytesOf(file: string): Promise<Uint8Array<ArrayBuffer>> {
  const address = new URL(file, import.meta.url)
  if (address.protocol === 'file:') {
    const { readFile } = await import('node:fs/promises')
    return new Uint8Array(await readFile(address))
  }
  const response = await fetch(address)
  if (!response.ok) throw new Error(`${address} cannot be loaded (${response.status})`)
  return new Uint8Array(await response.arrayBuffer())
}

export class Coapt {
  /** @internal */
  constructor(
    private readonly threads: Threads,
    /** Names of the valves that come with the package. */
    readonly presets: readonly string[],
  ) {}

  /** One of `presets`. */
  async preset(name: string): Promise<Valve> {
    if (!this.presets.includes(name))
      throw new RangeError(`there is no preset ${JSON.stringify(name)}; there are ${this.presets.join(', ')}`)
    return this.valve(new TextDecoder().decode(await bytesOf(`presets/${name}.json`)))
  }

  /** A coapt.valve/1 or /2, as an object or the text of its file. Rejects with a CoaptError that names every problem of it. */
  async valve(document: ValveDocument | string): Promise<Valve> {
    const text = typeof document === 'string' ? document : JSON.stringify(document)
    const { problems } = await this.ask<{ problems: Problem[] }>('/v1/valves:validate', text)
    if (problems.length > 0) throw new CoaptError(422, problems)
    return new Valve(this, text)
  }

  /** Version and what it does not model. */
  version(): Promise<{ version: string; not_modelled: string[] }> {
    return this.ask('/version', '')
  }

  /** The service's answer to a request of its document (openapi.json), for what has no method here. */
  async ask<Answer>(path: string, body: string | object, searching: Searching = {}): Promise<Answer> {
    const { signal, finish, progress } = searching
    const answer = await this.threads.ask({
      path,
      body: typeof body === 'string' ? body : JSON.stringify(body),
      signal,
      finish,
      progress: (now) => progress?.(now.closures, now.closures_planned, now),
    })
    const said = JSON.parse(new TextDecoder().decode(answer.body))
    if (answer.status >= 400) throw new CoaptError(answer.status, said.problems ?? [{ path: '', message: said.detail }])
    return said as Answer
  }

  /** Ends the threads; requests that wait or are computed reject. */
  close(): void {
    this.threads.end()
  }
}

export class Valve {
  /** @internal */
  constructor(
    private readonly coapt: Coapt,
    private readonly text: string,
  ) {}

  /** A copy. */
  get document(): ValveDocument {
    return JSON.parse(this.text)
  }

  /** Leak, coaptation, tensions under systolic pressure: 30 ms to some seconds. */
  close(options: CloseOptions = {}, waiting: Waiting = {}): Promise<Closure> {
    return this.ask('/v1/closures', options, waiting)
  }

  /** Opening and gradient in diastole. */
  open(options: OpenOptions = {}, waiting: Waiting = {}): Promise<Opening> {
    return this.ask('/v1/openings', options, waiting)
  }

  /** Why it leaks, segment by segment. */
  diagnose(options: Repaired = {}, waiting: Waiting = {}): Promise<Diagnosis> {
    return this.ask('/v1/diagnoses', options, waiting)
  }

  /** All that is drawn of it, with `frames` states of its closing. */
  scene(options: Repaired & { frames?: number } = {}, waiting: Waiting = {}): Promise<Scene> {
    return this.ask('/v1/scenes', options, waiting)
  }

  /** Scores and ranks plans of one's own. */
  evaluate(plans: Plan[], options: { region_points?: number } = {}, searching: Searching = {}): Promise<Evaluations> {
    return this.ask('/v1/evaluations', { plans, ...options }, searching)
  }

  /** Searches for repair plans and ranks them, the best first: the plans of `coapt plan`. */
  plan(search: Search = {}, searching: Searching = {}): Promise<Plans> {
    return this.ask('/v1/plans', { search }, searching)
  }

  /** The valve with figures that images show of it. */
  async observe(observed: Observations, waiting: Waiting = {}): Promise<Valve> {
    return this.coapt.valve(await this.ask<ValveDocument>('/v1/valves:observe', { observed }, waiting))
  }

  private ask<Answer>(path: string, options: object, searching: Searching): Promise<Answer> {
    const more = JSON.stringify(options).slice(1, -1)
    return this.coapt.ask(path, `{"valve":${this.text}${more ? `,${more}` : ''}}`, searching)
  }
}
