// Valves that were opened from files: listed by the service, or by this browser where the service lists none. Names that
// a person gives are this browser's.
import { ApiError, getJson, request } from '../api/http'
import { store, stored } from './stored'
import { tellTabs } from './tabs'

export interface OpenedValve {
  id: string
  name: string
  triangles: number | null // null: not known
}

const NAMES = 'coapt-valve-names'

export function nameOfValve(reference: string): string {
  return (
    stored<Record<string, string>>(NAMES, {})[reference] ??
    (isId(reference) ? `valve ${reference.slice(0, 8)}` : reference)
  )
}

export function nameValve(id: string, name: string): void {
  const names = stored<Record<string, string>>(NAMES, {})
  delete names[id] // the newest stands last
  store(NAMES, { ...names, [id]: name })
  tellTabs('valves')
}

/// Newest first.
export async function openedValves(): Promise<OpenedValve[]> {
  const names = stored<Record<string, string>>(NAMES, {})
  interface Page {
    valves: { valve: string; name: string; triangles: number }[]
    next_page_token?: string
  }
  try {
    const { valves } = await getJson<Page>('/v1/valves?page_size=100')
    return valves.map(({ valve, name, triangles }) => ({ id: valve, name: names[valve] ?? name, triangles }))
  } catch (error) {
    if (!(error instanceof ApiError) || (error.status !== 404 && error.status !== 405)) throw error
    return Object.entries(names)
      .filter(([id]) => isId(id))
      .reverse()
      .map(([id, name]) => ({ id, name, triangles: null }))
  }
}

export async function removeValve(id: string): Promise<void> {
  await request('DELETE', `/v1/valves/${id}`)
  const { [id]: _, ...others } = stored<Record<string, string>>(NAMES, {})
  store(NAMES, others)
  tellTabs('valves')
}

/// Its document, as the text that it is.
export async function valveText(reference: string): Promise<string> {
  const folder = isId(reference) ? 'valves' : 'presets'
  return (await request('GET', `/v1/${folder}/${encodeURIComponent(reference)}`)).text()
}

/// Else it is a preset's name.
function isId(reference: string): boolean {
  return /^[0-9a-f-]{16,}$/.test(reference)
}
