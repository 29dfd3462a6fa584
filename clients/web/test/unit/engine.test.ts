import { expect, test, vi } from 'vitest'
import { EventReader } from '../../src/api/events'
import { engineClient } from '../../src/engine/client'
import type { KeptValve, ValveShelf } from '../../src/engine/kept_valves'
import { localJobs } from '../../src/engine/local_jobs'
import { localService } from '../../src/engine/local_service'
import type { EngineThread } from '../../src/engine/thread'
import { wasi } from '../../src/engine/wasi'
import type { EngineReply, EngineRequest } from '../../src/engine/worker'
import { presetWords } from '../../src/valve/presets'

const bytes = (text: string) => new TextEncoder().encode(text) as Uint8Array<ArrayBuffer>
type Thread = EngineThread<EngineRequest, EngineReply>
const VALVE = '{"name": "mine", "vertices_mm": [[0, 0, -0.0]], "faces": []}'

function shelf(): ValveShelf {
  const kept = new Map<string, KeptValve>()
  return {
    find: (id) => Promise.resolve(kept.get(id) ?? null),
    list: () => Promise.resolve([...kept.values()].reverse()),
    add: (valve) => Promise.resolve(void kept.set(valve.id, valve)),
    remove: (id) => Promise.resolve(void kept.delete(id)),
  }
}

/// A service whose engine answers with what it is asked, and finds each valve valid that has a name.
function service() {
  const asked: EngineRequest[] = []
  const scored: EngineRequest[] = []
  const threads: StartedThread[] = []
  const files: Record<string, string> = { 'presets/index.json': '["barlow"]', 'presets/barlow.json': VALVE }
  const ask = localService({
    scoring: (path, body) => {
      scored.push({ path, body })
      return Promise.resolve({ status: 200, body: bytes('{}') })
    },
    jobs: localJobs(() => {
      threads.push(startedThread())
      return threads.at(-1) as StartedThread
    }),
    engine: (path, body) => {
      asked.push({ path, body })
      const problems = body.includes('name') ? [] : [{ code: 'missing', path: '/name', message: 'is missing' }]
      const judged = JSON.stringify({ valid: problems.length === 0, problems })
      return Promise.resolve({ status: 200, body: bytes(path.endsWith(':validate') ? judged : '{}') })
    },
    file: (path) => Promise.resolve(new Response(files[path] ?? '', { status: path in files ? 200 : 404 })),
    valves: shelf(),
  })
  return { ask, asked, scored, threads, files }
}

type StartedThread = ReturnType<typeof startedThread>
function startedThread() {
  const thread = {
    sent: [] as EngineRequest[],
    ended: false,
    onmessage: null as ((event: MessageEvent<EngineReply>) => void) | null,
    onerror: null as ((event: ErrorEvent) => void) | null,
    postMessage: (message: EngineRequest) => void thread.sent.push(message),
    terminate: () => {
      thread.ended = true
    },
    say: (reply: EngineReply) => thread.onmessage?.({ data: reply } as MessageEvent<EngineReply>),
  }
  return thread
}

test('what a module writes is printed, and counted', () => {
  const memory = new WebAssembly.Memory({ initial: 1 })
  const view = new DataView(memory.buffer)
  new Uint8Array(memory.buffer).set(bytes('ab'), 100)
  new Uint8Array(memory.buffer).set(bytes('cde'), 200)
  for (const [i, value] of [100, 2, 200, 3].entries()) view.setUint32(4 * i, value, true)
  const printed: string[] = []
  const write = wasi(
    () => memory,
    (text) => printed.push(text),
  ).fd_write as (...args: number[]) => number
  expect(write(2, 0, 2, 300)).toBe(0)
  expect(printed).toEqual(['ab', 'cde'])
  expect(view.getUint32(300, true)).toBe(5)
})

test('the engine is asked one request after the other; what is aborted while it waits, not at all', async () => {
  const sent: unknown[] = []
  const thread: Thread = { postMessage: (message) => sent.push(message), onmessage: null, onerror: null }
  const reply = (text: string) => thread.onmessage?.({ data: { status: 200, body: bytes(text) } } as MessageEvent)
  const ask = engineClient(thread)
  const given_up = new AbortController()
  const first = ask('/1', '')
  const second = ask('/2', '', given_up.signal)
  const third = ask('/3', '')
  expect(sent).toEqual([{ path: '/1', body: '' }])
  given_up.abort()
  await expect(second).rejects.toThrow(/abort/i)
  reply('one')
  expect(sent.slice(1)).toEqual([{ path: '/3', body: '' }])
  reply('three')
  expect(new TextDecoder().decode((await first).body)).toBe('one')
  expect(new TextDecoder().decode((await third).body)).toBe('three')
})

test('an engine that aborts fails its request alone', async () => {
  const thread: Thread = { postMessage: () => {}, onmessage: null, onerror: null }
  const ask = engineClient(thread)
  const [first, second] = [ask('/1', ''), ask('/2', '')]
  thread.onmessage?.({ data: { failed: 'unreachable' } } as MessageEvent)
  thread.onmessage?.({ data: { status: 200, body: bytes('') } } as MessageEvent)
  await expect(first).rejects.toThrow('unreachable')
  expect((await second).status).toBe(200)
})

test('a thread that has died fails what waits for it, and what comes later', async () => {
  const thread: Thread = { postMessage: () => {}, onmessage: null, onerror: null }
  const ask = engineClient(thread)
  const asked = [ask('/1', ''), ask('/2', '')]
  thread.onerror?.({ message: 'no such script' } as ErrorEvent)
  for (const answer of [...asked, ask('/3', '')]) await expect(answer).rejects.toThrow('no such script')
})

test('a preset is listed, and closed as the text that it is', async () => {
  const { ask, asked } = service()
  expect(await (await ask('GET', '/v1/presets')).json()).toEqual({
    presets: [{ name: 'barlow', ...presetWords('barlow'), valve: '/v1/presets/barlow' }],
  })
  expect(await (await ask('GET', '/v1/presets/barlow')).text()).toBe(VALVE)
  await ask('POST', '/v1/scenes', { valve: 'barlow', frames: 3 })
  expect(asked).toEqual([{ path: '/v1/scenes', body: `{"valve":${VALVE},"frames":3}` }])
})

test('a valve given as a document is closed as such', async () => {
  const { ask, asked } = service()
  await ask('POST', '/v1/closures', `{"valve": ${VALVE}}`)
  expect(asked).toEqual([{ path: '/v1/closures', body: `{"valve": ${VALVE}}` }])
})

test('a valve that is stored is found by the SHA-256 of its text, listed, and removed', async () => {
  const { ask, asked } = service()
  const stored = await ask('POST', '/v1/valves', VALVE)
  expect(stored.status).toBe(201)
  const { id } = (await stored.json()) as { id: string }
  expect(id).toMatch(/^[0-9a-f]{64}$/)
  expect((await ask('POST', '/v1/valves', VALVE)).status).toBe(200)
  expect(await (await ask('GET', `/v1/valves/${id}`)).text()).toBe(VALVE)
  expect(await (await ask('GET', '/v1/valves?page_size=100')).json()).toEqual({
    valves: [{ valve: id, name: 'mine', vertices: 1, triangles: 0 }],
  })
  await ask('POST', '/v1/openings', { valve: id })
  expect(asked.at(-1)?.body).toBe(`{"valve":${VALVE}}`)
  expect((await ask('DELETE', `/v1/valves/${id}`)).status).toBe(204)
  expect((await ask('GET', `/v1/valves/${id}`)).status).toBe(404)
})

test('a valve that is not valid is not stored', async () => {
  const { ask } = service()
  const answer = await ask('POST', '/v1/valves', '{}')
  expect(answer.status).toBe(422)
  expect(await answer.json()).toMatchObject({ detail: 'is missing', problems: [{ path: '/name' }] })
  expect(await (await ask('GET', '/v1/valves?page_size=100')).json()).toEqual({ valves: [] })
})

test('a valve that nobody knows is said to be none', async () => {
  const { ask, asked } = service()
  const answer = await ask('POST', '/v1/scenes', { valve: 'nobody' })
  expect(answer.status).toBe(422)
  expect(await answer.json()).toMatchObject({ problems: [{ path: '/valve' }] })
  expect(asked).toEqual([])
})

test('all else needs coapt-server', async () => {
  const { ask } = service()
  for (const [method, path] of [
    ['POST', '/v1/jobs'],
    ['POST', '/v1/reports'],
    ['PUT', '/v1/valves'],
  ] as const) {
    const answer = await ask(method, path, '{}')
    expect(answer.status).toBe(501)
    expect(await answer.json()).toMatchObject({ detail: 'needs coapt-server', problems: [] })
  }
})

test('presets that cannot be loaded are asked for again', async () => {
  const { ask, files } = service()
  const list = files['presets/index.json'] as string
  delete files['presets/index.json']
  expect((await ask('GET', '/v1/presets')).status).toBe(500)
  files['presets/index.json'] = list
  expect((await ask('GET', '/v1/presets')).status).toBe(200)
})

test('plans are scored by the module that searches', async () => {
  const { ask, asked, scored } = service()
  expect((await ask('POST', '/v1/evaluations', { valve: 'barlow', plans: [] })).status).toBe(200)
  expect(scored).toEqual([{ path: '/v1/evaluations', body: `{"valve":${VALVE},"plans":[]}` }])
  expect(asked).toEqual([])
})

test('a search is a job that tells its progress and keeps its result', async () => {
  const { ask, threads } = service()
  const started = ask('POST', '/v1/plans', { valve: 'barlow', search: { evaluations: 9 } })
  await Promise.resolve()
  await vi.waitFor(() => expect(threads[0]?.sent.length).toBe(1))
  const [thread] = threads as [StartedThread]
  expect(thread.sent[0]).toEqual({ path: '/v1/plans', body: `{"valve":${VALVE},"search":{"evaluations":9}}` })
  thread.say({ progress: [1, 9] })
  const response = await started
  expect(response.status).toBe(202)
  const { id, valve, links } = await response.json()
  expect(valve).toBe('barlow')
  expect((await ask('POST', '/v1/plans', { valve: 'barlow' })).status).toBe(409)
  expect((await ask('GET', `${links.self}/result`)).status).toBe(501)

  const first = await ask('GET', `${links.events}?last_event_id=0`)
  const events = (await ask('GET', `${links.events}?last_event_id=0`)).text()
  const same = first.text() // two may follow it
  thread.say({ progress: [5, 9] })
  thread.say({ status: 200, body: bytes('{"plans":[{"rank":1}]}') })
  expect(thread.ended).toBe(true)
  expect(await same).toBe(await events)
  const told = new EventReader().read(await events)
  expect(told.map(({ id, event }) => [id, event])).toEqual([
    ['1', 'progress'],
    ['2', 'progress'],
    ['3', 'state'],
  ])
  expect(JSON.parse(told[1]?.data ?? '')).toMatchObject({ closures: 5, closures_planned: 9 })
  const late = await ask('GET', `${links.events}?last_event_id=2`)
  expect(new EventReader().read(await late.text()).length).toBe(1)
  expect((await ask('GET', `${links.events}?last_event_id=3`)).status).toBe(204)

  const job = await (await ask('GET', links.self)).json()
  expect(job).toMatchObject({ id, state: 'SUCCEEDED', links: { result: `${links.self}/result` } })
  expect(await (await ask('GET', job.links.result)).json()).toEqual({ plans: [{ rank: 1 }] })
  expect(await (await ask('GET', `${links.self}/plans/1`)).json()).toEqual({ rank: 1 })
  expect((await ask('GET', `${links.self}/plans/2`)).status).toBe(404)
  expect(((await (await ask('GET', '/v1/jobs?page_size=100')).json()).jobs as unknown[]).length).toBe(1)
  expect((await ask('DELETE', links.self)).status).toBe(204)
  expect((await ask('GET', links.self)).status).toBe(404)
})

test('a search that is refused is no job; one that is cancelled or fails ends', async () => {
  const { ask, threads } = service()
  const begun = async () => {
    const count = threads.length
    const answer = ask('POST', '/v1/plans', { valve: 'barlow' })
    await vi.waitFor(() => expect(threads[count]?.sent.length).toBe(1))
    return { answer, thread: threads[count] as StartedThread }
  }
  const refused = await begun()
  refused.thread.say({ status: 422, body: bytes('{"detail":"is no option"}') })
  expect((await refused.answer).status).toBe(422)
  expect(refused.thread.ended).toBe(true)

  const cancelled = await begun()
  cancelled.thread.say({ progress: [1, 9] })
  const { links } = await (await cancelled.answer).json()
  const events = (await ask('GET', links.events)).text()
  expect(await (await ask('POST', links.cancel)).json()).toMatchObject({ state: 'CANCELLED', cancel_requested: true })
  expect(cancelled.thread.ended).toBe(true)
  expect(await events).toContain('"state":"CANCELLED"')

  const failed = await begun()
  failed.thread.say({ failed: 'out of memory' })
  const job = await (await failed.answer).json()
  expect(await (await ask('GET', job.links.self)).json()).toMatchObject({
    state: 'FAILED',
    problems: [{ message: 'out of memory' }],
  })
})
