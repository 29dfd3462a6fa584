// Answers in place of coapt-server, for the page without one (make static): what is asked about one valve, evaluations and searches from
// the engine, presets from files beside the page, valves that were opened from this browser. All else needs coapt-server.
import { presetWords } from '../valve/presets'
import type { KeptValve, ValveShelf } from './kept_valves'
import type { LocalJobs } from './local_jobs'
import type { Ask } from './threads'

export interface LocalParts {
  engine: Ask
  scoring: Ask // the module that searches, too
  jobs: LocalJobs
  file(path: string): Promise<Response> // of the page, beside index.html
  valves: ValveShelf
}

/// `body`: a value, or JSON as text. Answers what is wrong as a service does; rejects if `signal` says so.
export type LocalService = (method: string, path: string, body?: unknown, signal?: AbortSignal) => Promise<Response>

const COMPUTED = [
  ...['/v1/closures', '/v1/scenes', '/v1/openings', '/v1/diagnoses'],
  ...['/v1/information', '/v1/comparisons', '/v1/valves:observe'],
]
const SCORED = '/v1/evaluations'
const SEARCHED = '/v1/plans'
const PRESETS = '/v1/presets'
const VALVES = '/v1/valves'

export function localService({ engine, scoring, jobs, file, valves }: LocalParts): LocalService {
  let names: Promise<string[]> | null = null // of presets
  const documents = new Map<string, string>() // of presets, by name

  async function answer(method: string, path: string, body: unknown, signal?: AbortSignal): Promise<Response> {
    const [place = '', id] = splitId(path)
    switch (`${method} ${place}`) {
      case 'GET /version':
      case 'GET /v1/rings':
        return ask(path, '', signal)
      case 'GET /v1/presets':
        if (id !== undefined) return textOrMissing(await preset(id))
        return json(200, {
          presets: (await presetNames()).map((name) => ({ name, ...presetWords(name), valve: `${PRESETS}/${name}` })),
        })
      case 'GET /v1/valves':
        if (id !== undefined) return textOrMissing((await valves.find(id))?.text)
        return json(200, { valves: (await valves.list()).map(summary) })
      case 'DELETE /v1/valves':
        await valves.remove(id ?? '')
        return new Response(null, { status: 204 })
      case 'POST /v1/valves':
        return keep(asText(body), signal)
      case 'POST /v1/valves:validate':
        return ask(path, asText(body), signal)
    }
    if (method === 'POST' && [...COMPUTED, SCORED, SEARCHED].includes(path)) return compute(path, asText(body), signal)
    return jobs.answer(method, path) ?? problem(501, 'this request requires coapt-server')
  }

  async function ask(path: string, body: string, signal?: AbortSignal): Promise<Response> {
    const answered = await (path === SCORED ? scoring : engine)({ path, body, signal })
    return new Response(answered.body, { status: answered.status, headers: { 'Content-Type': 'application/json' } })
  }

  /// The engine knows no valve by name: its document takes the place, as the text that it is, so that no number changes.
  async function compute(path: string, text: string, signal?: AbortSignal): Promise<Response> {
    const body = JSON.parse(text) as Record<string, unknown>
    const reference = body.valve
    if (typeof reference !== 'string') return path === SEARCHED ? jobs.start('', text) : ask(path, text, signal)
    const document = (await preset(reference)) ?? (await valves.find(reference))?.text
    if (document === undefined)
      return problem(422, 'is neither the id of a stored valve nor the name of a preset', '/valve')
    const fields = Object.entries(body).map(
      ([name, value]) => `${JSON.stringify(name)}:${name === 'valve' ? document : JSON.stringify(value)}`,
    )
    const whole = `{${fields.join(',')}}`
    return path === SEARCHED ? jobs.start(reference, whole) : ask(path, whole, signal)
  }

  async function keep(text: string, signal?: AbortSignal): Promise<Response> {
    const judged = await ask(`${VALVES}:validate`, text, signal)
    const { valid, problems } = (await judged.json()) as { valid: boolean; problems: { message: string }[] }
    if (!valid) return json(422, { status: 422, detail: problems[0]?.message, problems })
    const valve = await keptValve(text)
    const isNew = (await valves.find(valve.id)) === null
    await valves.add(valve)
    const { id, vertices, triangles } = valve
    return json(isNew ? 201 : 200, { id, vertices, triangles })
  }

  async function preset(name: string): Promise<string | undefined> {
    if (!(await presetNames()).includes(name)) return undefined
    const document = documents.get(name) ?? (await read(`presets/${name}.json`))
    documents.set(name, document)
    return document
  }

  async function presetNames(): Promise<string[]> {
    names ??= read('presets/index.json').then((text) => JSON.parse(text) as string[])
    names.catch(() => (names = null)) // asked for again
    return names
  }

  async function read(path: string): Promise<string> {
    const response = await file(path)
    if (!response.ok) throw new Error(`${path} cannot be loaded (${response.status})`)
    return response.text()
  }

  return async (method, path, body, signal) => {
    try {
      return await answer(method, path, body, signal)
    } catch (error) {
      signal?.throwIfAborted()
      return problem(500, error instanceof Error ? error.message : String(error))
    }
  }
}

/// "/v1/presets/barlow" -> ["/v1/presets", "barlow"]; no id where the path has none. A query is left out.
function splitId(path: string): string[] {
  const [whole = ''] = path.split('?', 1)
  const parent = [PRESETS, VALVES].find((folder) => whole.startsWith(`${folder}/`))
  return parent ? [parent, decodeURIComponent(whole.slice(parent.length + 1))] : [whole]
}

/// `text`: of a valid valve. Its id is the SHA-256 of it, in hexadecimal digits.
async function keptValve(text: string): Promise<KeptValve> {
  if (!globalThis.crypto.subtle) throw new Error('The browser stores valves only for pages from https:// or localhost.')
  const hash = await crypto.subtle.digest('SHA-256', new TextEncoder().encode(text))
  const id = [...new Uint8Array(hash)].map((byte) => byte.toString(16).padStart(2, '0')).join('')
  const { name, vertices_mm, faces } = JSON.parse(text) as { name: string; vertices_mm: unknown[]; faces: unknown[] }
  return { id, text, name, vertices: vertices_mm.length, triangles: faces.length, kept_ms: Date.now() }
}

function summary({ id, name, vertices, triangles }: KeptValve): object {
  return { valve: id, name, vertices, triangles }
}

function asText(body: unknown): string {
  return typeof body === 'string' ? body : JSON.stringify(body)
}

function json(status: number, value: object): Response {
  return new Response(JSON.stringify(value), { status, headers: { 'Content-Type': 'application/json' } })
}

function textOrMissing(text: string | undefined): Response {
  return text === undefined ? problem(404, 'there is no such valve') : new Response(text)
}

/// `path`: a JSON pointer into what was sent.
function problem(status: number, detail: string, path?: string): Response {
  const problems = path === undefined ? [] : [{ code: 'bad_reference', path, message: detail }]
  return json(status, { status, detail, problems })
}
