import { afterEach, beforeEach, expect, test, vi } from 'vitest'
import type { Plan } from '../../src/api/types'
import { fittingName, shelf, type KeptPlan, type Shelf } from '../../src/state/kept_plans'
import { bestOf } from '../../src/repair/scores'
import type { RankedPlan } from '../../src/api/types'
import { Workspace } from '../../src/workspace'

const plan = (sizes_below: number): Plan => ({
  schema: 'coapt.plan/1',
  steps: [{ step: 'annuloplasty', shape: 'own', sizes_below }],
})
const valve = { reference: 'human-normal', label: 'human-normal' }
let kept: Map<string, string>

beforeEach(() => {
  kept = new Map()
  vi.stubGlobal('sessionStorage', { getItem: () => null })
  vi.stubGlobal('localStorage', {
    getItem: (key: string) => kept.get(key) ?? null,
    setItem: (key: string, value: string) => kept.set(key, value),
  })
})
afterEach(() => vi.unstubAllGlobals())

function memory(): Shelf {
  let plans: KeptPlan[] = []
  return {
    list: () => Promise.resolve(plans),
    add(added) {
      plans = [{ ...added, id: String(plans.length) }, ...plans]
      return Promise.resolve(plans[0] as KeptPlan)
    },
    rename: () => Promise.resolve(),
    remove(id) {
      plans = plans.filter((one) => one.id !== id)
      return Promise.resolve()
    },
  }
}

test('a plan that is kept twice for one valve is kept once', async () => {
  const workspace = new Workspace(memory())
  expect((await workspace.keep('a', plan(1), valve)).isNew).toBe(true)
  const again = await workspace.keep('b', plan(1), valve)
  expect([again.isNew, again.kept.name]).toEqual([false, 'a'])
  await workspace.keep('c', plan(2), valve)
  await workspace.keep('d', plan(1), { reference: 'other', label: 'other' })
  expect(workspace.kept.map(({ name }) => name)).toEqual(['a', 'c', 'd'])
})

test('what is kept is renamed and removed', async () => {
  const workspace = new Workspace(memory())
  const { kept: first } = await workspace.keep('a', plan(1), valve)
  await workspace.rename(first, 'b')
  expect(workspace.kept[0]?.name).toBe('b')
  await workspace.forget(workspace.kept[0] as KeptPlan)
  expect(workspace.kept).toEqual([])
})

test('a service that keeps no plans leaves them to the browser', async () => {
  vi.stubGlobal('fetch', () => Promise.resolve({ ok: false, status: 404, json: () => Promise.resolve({}) }))
  const plans = shelf()
  expect(await plans.list()).toEqual([])
  const added = await plans.add({ name: 'a', valve: 'human-normal', plan: plan(1) })
  await plans.rename(added.id, 'b')
  expect((await plans.list()).map(({ name }) => name)).toEqual(['b'])
  await plans.remove(added.id)
  expect(await plans.list()).toEqual([])
})

test('all pages of the service are read', async () => {
  const asked: string[] = []
  vi.stubGlobal('fetch', (path: string) => {
    asked.push(path)
    const page = asked.length
    const kept_plans = [{ kept_plan: `k${page}`, name: `n${page}`, valve: 'v', plan: plan(1) }]
    const answer = page === 1 ? { kept_plans, next_page_token: 'a b' } : { kept_plans }
    return Promise.resolve({ ok: true, json: () => Promise.resolve(answer) })
  })
  expect((await shelf().list()).map(({ id }) => id)).toEqual(['k1', 'k2'])
  expect(asked[1]).toMatch(/page_token=a%20b$/)
})

test('the plan that costs least is the best; plans without a cost are none', () => {
  const costing = (cost: number | null) => ({ cost }) as RankedPlan
  expect(bestOf([costing(2), costing(null), costing(1), null, undefined])).toBe(2)
  expect(bestOf([null, costing(null)])).toBeNull()
})

test('a name that is too long is cut to what the service takes', () => {
  expect(fittingName('Rank 1: ring')).toBe('Rank 1: ring')
  for (const letter of ['a', 'é', '📐']) {
    const cut = fittingName(letter.repeat(300))
    expect(new TextEncoder().encode(cut).length).toBeLessThanOrEqual(200)
    expect(new TextEncoder().encode(cut).length).toBeGreaterThan(190)
    expect(cut.replace('…', '')).toBe(letter.repeat(Array.from(cut).length - 1))
  }
})
