import { afterEach, beforeEach, expect, test, vi } from 'vitest'
import type { ViewName } from '../../src/shell/views'
import type { StoryPlace } from '../../src/state/address'
import { router } from '../../src/state/router'
import { NO_PLAN, type ValveSource, type Workspace } from '../../src/workspace'

let hash = ''
let entries: string[] = []
let changed = () => {}
let arrived = () => {}
const shown: ViewName[] = []

const workspace = {
  valve: null as ValveSource | null,
  plan: NO_PLAN,
  jobs: { plans: null, study: null, import: null },
  isDragging: false,
  open: async (valve: ValveSource) => {
    workspace.valve = valve
  },
  setPlan: async () => {},
  story: null as StoryPlace | null,
  tell: (story: StoryPlace | null) => {
    workspace.story = story
  },
  lookAt: () => {},
  subscribe: (listener: () => void) => {
    changed = listener
  },
}

const page = { show: async (view: ViewName) => void shown.push(view), fail: () => {}, failed: () => {} }

beforeEach(async () => {
  hash = '#/repair?valve=a'
  entries = []
  vi.stubGlobal('location', {
    get hash() {
      return hash
    },
  })
  const write = (_state: unknown, _title: string, address: string) => {
    hash = address
    entries.push(address)
  }
  vi.stubGlobal('history', { pushState: write, replaceState: write })
  vi.stubGlobal('addEventListener', (_name: string, listener: () => void) => {
    arrived = listener
  })
  await router(workspace as unknown as Workspace, page).start()
})

afterEach(() => vi.unstubAllGlobals())

test('another valve is a new entry', async () => {
  await workspace.open({ reference: 'b', label: 'b' })
  changed()
  expect(entries).toEqual(['#/repair?valve=b'])
})

test('what changes while an address is on its way does not write over it', async () => {
  hash = '#/valve?valve=a' // back was pressed, hashchange has not come yet
  changed() // a closure was answered
  expect(hash).toBe('#/valve?valve=a')
  arrived()
  await vi.waitFor(() => expect(shown.at(-1)).toBe('valve'))
  expect(entries).toEqual([])
})
