// Requests to the service, or to what answers in its place in a page without one (src/engine). The token, where it asks for one, is kept for this tab alone.
import { fetchKnowing } from './health'
import type { Problem } from './types'

const TOKEN = 'coapt-token'

/// What the service says against a request; `problems` point into what was sent.
export class ApiError extends Error {
  constructor(
    readonly status: number,
    message: string,
    readonly problems: Problem[],
  ) {
    super(message)
  }
}

/// Asked for a token; null if the person gives none. Set once by the page.
let askForToken: () => Promise<string | null> = () => Promise.resolve(null)
export function onTokenNeeded(ask: typeof askForToken): void {
  askForToken = ask
}

/// Takes the token out of the address `#token=TOKEN`, which coapt-server prints.
export function takeTokenFromAddress(): void {
  const token = /^#token=(.+)$/.exec(location.hash)?.[1]
  if (token === undefined) return
  sessionStorage.setItem(TOKEN, token)
  history.replaceState(null, '', '#')
}

export function hasToken(): boolean {
  return sessionStorage.getItem(TOKEN) !== null
}

export async function request(method: string, path: string, body?: unknown, signal?: AbortSignal): Promise<Response> {
  if (import.meta.env.MODE === 'static') {
    const { pageService } = await import('../engine/page_service')
    const response = await pageService(method, path, body, signal)
    if (response.ok) return response
    throw await errorOf(response)
  }
  const headers: Record<string, string> = {}
  const token = sessionStorage.getItem(TOKEN)
  if (token !== null) headers.Authorization = `Bearer ${token}`
  if (body !== undefined) headers['Content-Type'] = 'application/json'
  const response = await fetchKnowing(path, {
    method,
    headers,
    ...(body === undefined ? {} : { body: typeof body === 'string' ? body : JSON.stringify(body) }),
    ...(signal ? { signal } : {}),
  })
  if (response.ok) return response
  if (response.status === 401) {
    const given = await askForToken()
    if (given !== null) {
      sessionStorage.setItem(TOKEN, given)
      return request(method, path, body, signal)
    }
  }
  throw await errorOf(response)
}

async function errorOf(response: Response): Promise<ApiError> {
  try {
    return refusal(response.status, await response.json())
  } catch {
    return new ApiError(response.status, `the service answered ${response.status}`, [])
  }
}

/// `said`: the answer's document.
export function refusal(status: number, said: unknown): ApiError {
  const { detail, title, problems } = said as { detail?: string; title?: string; problems?: Problem[] }
  return new ApiError(status, detail ?? title ?? '', problems ?? [])
}

export async function getJson<T>(path: string, signal?: AbortSignal): Promise<T> {
  return (await (await request('GET', path, undefined, signal)).json()) as T
}

/// `body`: a value, or JSON as text.
export async function postJson<T>(path: string, body: unknown, signal?: AbortSignal): Promise<T> {
  return (await (await request('POST', path, body, signal)).json()) as T
}

export async function getBlob(path: string): Promise<Blob> {
  return (await request('GET', path)).blob()
}
