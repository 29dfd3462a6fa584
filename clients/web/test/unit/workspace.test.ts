import { afterEach, beforeEach, expect, test, vi } from 'vitest'
import type { Scene, Step } from '../../src/api/types'
import { Workspace } from '../../src/workspace'
import { pyramid } from './scenes'

const ring = (sizes_below: number): Step => ({ step: 'annuloplasty', shape: 'own', sizes_below })
/// What the service was asked, and how each is answered.
let asked: { body: { valve: string; plan?: { steps: Step[] } }; answer: (scene: Scene | Error) => void }[]

beforeEach(() => {
  asked = []
  vi.stubGlobal('sessionStorage', { getItem: () => null })
  vi.stubGlobal(
    'fetch',
    (_: string, { body }: { body: string }) =>
      new Promise((resolve, reject) => {
        const answer = (scene: Scene | Error): void =>
          scene instanceof Error ? reject(scene) : resolve({ ok: true, json: () => Promise.resolve(scene) })
        asked.push({ body: JSON.parse(body), answer })
      }),
  )
})
afterEach(() => vi.unstubAllGlobals())

const settle = () => new Promise((resolve) => setTimeout(resolve, 0))

async function opened(): Promise<Workspace> {
  const workspace = new Workspace()
  const opening = workspace.open({ reference: 'a', label: 'a' })
  asked.pop()?.answer(pyramid())
  await opening
  return workspace
}

test('of two valves that are asked for the last one is opened, whichever is answered first', async () => {
  const workspace = new Workspace()
  const slow = workspace.open({ reference: 'slow', label: 'slow' })
  const fast = workspace.open({ reference: 'fast', label: 'fast' })
  asked[1]?.answer(pyramid())
  await fast
  asked[0]?.answer(pyramid())
  await slow
  expect(workspace.valve?.label).toBe('fast')
})

test('a drag is undone at once', async () => {
  const workspace = await opened()
  void workspace.setPlan([ring(1)])
  for (const size of [2, 3, 4]) void workspace.setPlan([ring(size)], true)
  void workspace.setPlan([ring(4)])
  expect(workspace.plan.steps).toEqual([ring(4)])
  void workspace.undo()
  expect(workspace.plan.steps).toEqual([ring(1)])
  void workspace.undo()
  expect(workspace.plan.steps).toEqual([])
  expect(workspace.canUndo).toBe(false)
  void workspace.redo()
  void workspace.redo()
  expect(workspace.plan.steps).toEqual([ring(4)])
})

test('one closure at a time, and the last plan is the one that is answered', async () => {
  const workspace = await opened()
  for (const size of [1, 2, 3]) void workspace.setPlan([ring(size)], true)
  expect(asked).toHaveLength(1)
  expect(workspace.isAnswered).toBe(false)
  asked[0]?.answer({ ...pyramid(), thickness_mm: 1 })
  await settle()
  expect(asked.map(({ body }) => body.plan?.steps)).toEqual([[ring(1)], [ring(3)]])
  expect(workspace.isAnswered).toBe(false)
  asked[1]?.answer({ ...pyramid(), thickness_mm: 3 })
  await settle()
  expect(workspace.isAnswered).toBe(true)
  expect(workspace.after?.thickness_mm).toBe(3)
})

test('a plan that cannot be closed leaves no figures of another one', async () => {
  const workspace = await opened()
  void workspace.setPlan([ring(1)])
  asked[0]?.answer(pyramid())
  await settle()
  expect(workspace.after).not.toBeNull()
  void workspace.setPlan([ring(2)])
  asked[1]?.answer(new Error('gone'))
  await settle()
  expect(workspace.isAnswered).toBe(true)
  expect(workspace.after).toBeNull()
  expect(workspace.answer_ms).toBeNull()
  expect(workspace.problems[0]?.message).toBe('gone')
})

test('an answer for a valve that is not open any more is left out', async () => {
  const workspace = await opened()
  void workspace.setPlan([ring(1)])
  void workspace.open({ reference: 'b', label: 'b' })
  asked[1]?.answer(pyramid())
  await settle()
  asked[0]?.answer(pyramid())
  await settle()
  expect(workspace.valve?.label).toBe('b')
  expect(workspace.after).toBeNull()
  expect(workspace.isAnswered).toBe(true)
})
