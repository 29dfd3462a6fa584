// Where kept plans lie: on the service, or in this browser where the service keeps none.
import { ApiError, getJson, postJson, request } from '../api/http'
import type { Plan } from '../api/types'
import { HAS_SERVICE } from '../mode'
import { store, stored } from './stored'

export interface KeptPlan {
  id: string
  name: string
  valve: string // a preset's name or a stored valve's id
  plan: Plan
}

export interface Shelf {
  list(): Promise<KeptPlan[]> // newest first
  add(kept: Omit<KeptPlan, 'id'>): Promise<KeptPlan>
  rename(id: string, name: string): Promise<void>
  remove(id: string): Promise<void>
}

const PATH = '/v1/kept-plans'
const NAME_BYTES = 200
const KEY = 'coapt-kept-plans'

interface Answer extends Omit<KeptPlan, 'id'> {
  kept_plan: string
}
const read = ({ kept_plan, name, valve, plan }: Answer): KeptPlan => ({ id: kept_plan, name, valve, plan })

export const serviceShelf: Shelf = {
  async list() {
    const found: KeptPlan[] = []
    let token = ''
    do {
      const page = await getJson<{ kept_plans: Answer[]; next_page_token?: string }>(`${PATH}?page_size=100${token}`)
      found.push(...page.kept_plans.map(read))
      token = page.next_page_token ? `&page_token=${encodeURIComponent(page.next_page_token)}` : ''
    } while (token !== '')
    return found
  },
  add: async (kept) => read(await postJson<Answer>(PATH, kept)),
  async rename(id, name) {
    await request('PATCH', `${PATH}/${id}`, { name })
  },
  async remove(id) {
    await request('DELETE', `${PATH}/${id}`)
  },
}

export const browserShelf: Shelf = {
  list: () => Promise.resolve(stored<KeptPlan[]>(KEY, [])),
  add(kept) {
    const added = { ...kept, id: crypto.randomUUID() }
    store(KEY, [added, ...stored<KeptPlan[]>(KEY, [])])
    return Promise.resolve(added)
  },
  rename(id, name) {
    store(
      KEY,
      stored<KeptPlan[]>(KEY, []).map((kept) => (kept.id === id ? { ...kept, name } : kept)),
    )
    return Promise.resolve()
  },
  remove(id) {
    store(
      KEY,
      stored<KeptPlan[]>(KEY, []).filter((kept) => kept.id !== id),
    )
    return Promise.resolve()
  },
}

/// As long as a plan's name may be; what is cut off ends in "…".
export function fittingName(name: string): string {
  const size = (text: string): number => new TextEncoder().encode(text).length
  if (size(name) <= NAME_BYTES) return name
  const letters = Array.from(name)
  while (size(`${letters.join('')}…`) > NAME_BYTES) letters.pop()
  return `${letters.join('').trimEnd()}…`
}

/// The service's, or the browser's where the service has no such thing.
export function shelf(): Shelf {
  let chosen: Shelf = HAS_SERVICE ? serviceShelf : browserShelf
  const first = async <T>(use: (shelf: Shelf) => Promise<T>): Promise<T> => {
    try {
      return await use(chosen)
    } catch (error) {
      const isMissing = error instanceof ApiError && (error.status === 404 || error.status === 405)
      if (chosen === browserShelf || !isMissing || !(await serviceKeepsNone())) throw error
      chosen = browserShelf
      return use(chosen)
    }
  }
  return {
    list: () => first((at) => at.list()),
    add: (kept) => first((at) => at.add(kept)),
    rename: (id, name) => first((at) => at.rename(id, name)),
    remove: (id) => first((at) => at.remove(id)),
  }
}

/// A single plan may be gone from a service that keeps others.
async function serviceKeepsNone(): Promise<boolean> {
  return getJson(`${PATH}?page_size=1`).then(
    () => false,
    (error: unknown) => error instanceof ApiError && (error.status === 404 || error.status === 405),
  )
}
