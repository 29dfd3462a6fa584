import { expect, test, vi } from 'vitest'
import { EventReader } from '../../src/api/events'
import type { KeptValve, ValveShelf } from '../../src/engine/kept_valves'
import { localJobs } from '../../src/engine/local_jobs'
import { localService } from '../../src/engine/local_service'
import type { EngineReply, EngineRequest } from '../../src/engine/messages'
import type { EngineAnswer } from '../../src/engine/module'
import { Member, Team } from '../../src/engine/team'
import { type Asked, type Thread, Threads } from '../../src/engine/threads'
import { wasi } from '../../src/engine/wasi'
import { presetWords } from '../../src/valve/presets'

const bytes = (text: string) => new TextEncoder().encode(text) as Uint8Array<ArrayBuffer>
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
  const searches: Asked[] = []
  const search = { answer: (_: EngineAnswer) => {}, fail: (_: Error) => {} } // of the last
  const files: Record<string, string> = { 'presets/index.json': '["barlow"]', 'presets/barlow.json': VALVE }
  const ask = localService({
    scoring: ({ path, body }) => {
      scored.push({ path, body })
      return Promise.resolve({ status: 200, body: bytes('{}') })
    },
    jobs: localJobs((asked) => {
      searches.push(asked)
      return new Promise((resolve, reject) => Object.assign(search, { answer: resolve, fail: reject }))
    }),
    engine: ({ path, body }) => {
      asked.push({ path, body })
      const problems = body.includes('name') ? [] : [{ code: 'missing', path: '/name', message: 'is missing' }]
      const judged = JSON.stringify({ valid: problems.length === 0, problems })
      return Promise.resolve({ status: 200, body: bytes(path.endsWith(':validate') ? judged : '{}') })
    },
    file: (path) => Promise.resolve(new Response(files[path] ?? '', { status: path in files ? 200 : 404 })),
    valves: shelf(),
  })
  return { ask, asked, scored, searches, search, files }
}

/// Threads that are told nothing but what a test says.
function startedThreads(most: number) {
  const started: { sent: EngineRequest[]; ended: boolean; say(reply: EngineReply): void; die(why: Error): void }[] = []
  const start = async (): Promise<Thread> => {
    const one = { sent: [] as EngineRequest[], ended: false, say: (_: EngineReply) => {}, die: (_: Error) => {} }
    started.push(one)
    return {
      postMessage: (message) => 'path' in message && one.sent.push(message),
      terminate() {
        one.ended = true
      },
      listen: (heard, died) => Object.assign(one, { say: heard, die: died }),
      hold() {},
    }
  }
  const module = new WebAssembly.Module(Uint8Array.from([0, 97, 115, 109, 1, 0, 0, 0]))
  return { started, threads: new Threads(async () => module, most, start) }
}
const answered = (text: string): EngineReply => ({ status: 200, body: bytes(text) })
const NOW = { stage: 'searching', best_leak_mm2: null, best_cost: null, random_cost: null } as const

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

test('a thread is asked one request after the other; what is aborted while it waits, not at all', async () => {
  const { started, threads } = startedThreads(1)
  const given_up = new AbortController()
  const first = threads.ask({ path: '/1', body: '' })
  const second = threads.ask({ path: '/2', body: '', signal: given_up.signal })
  const third = threads.ask({ path: '/3', body: '' })
  await vi.waitFor(() => expect(started[0]?.sent).toEqual([{ path: '/1', body: '' }]))
  given_up.abort()
  await expect(second).rejects.toThrow(/abort/i)
  started[0]?.say(answered('one'))
  await vi.waitFor(() => expect(started[0]?.sent.slice(1)).toEqual([{ path: '/3', body: '' }]))
  started[0]?.say(answered('three'))
  expect(new TextDecoder().decode((await first).body)).toBe('one')
  expect(new TextDecoder().decode((await third).body)).toBe('three')
  expect(started.length).toBe(1)
})

test('a thread that goes on with what is aborted is ended', async () => {
  const { started, threads } = startedThreads(1)
  const stop = new AbortController()
  const first = threads.ask({ path: '/1', body: '', signal: stop.signal })
  const second = threads.ask({ path: '/2', body: '' })
  await vi.waitFor(() => expect(started[0]?.sent.length).toBe(1))
  stop.abort()
  await expect(first).rejects.toThrow(/abort/i)
  await vi.waitFor(() => expect(started[1]?.sent).toEqual([{ path: '/2', body: '' }]))
  expect(started[0]?.ended).toBe(true)
  started[1]?.say(answered(''))
  expect((await second).status).toBe(200)
})

test('an engine that aborts fails its request alone, a thread that dies, too', async () => {
  const { started, threads } = startedThreads(1)
  const asked = [1, 2, 3].map((number) => threads.ask({ path: `/${number}`, body: '' }))
  await vi.waitFor(() => expect(started[0]?.sent.length).toBe(1))
  started[0]?.say({ failed: 'unreachable' })
  await expect(asked[0]).rejects.toThrow('unreachable')
  await vi.waitFor(() => expect(started[0]?.sent.length).toBe(2))
  started[0]?.die(new Error('no such script'))
  await expect(asked[1]).rejects.toThrow('no such script')
  await vi.waitFor(() => expect(started[1]?.sent.length).toBe(1))
  started[1]?.say(answered(''))
  expect((await asked[2])?.status).toBe(200)
})

test('a search takes the idle threads, which leave it when something else waits', async () => {
  const { started, threads } = startedThreads(2)
  const finish = new AbortController()
  const search = threads.ask({ path: '/v1/plans', body: '{}', finish: finish.signal })
  await vi.waitFor(() => expect(started.map(({ sent }) => sent.length)).toEqual([1, 1]))
  const [first, second] = started.map(({ sent }) => new Member(sent[0]?.place as NonNullable<EngineRequest['place']>))
  expect([first?.workers, second?.workers]).toEqual([2, 2])
  const other = threads.ask({ path: '/other', body: '' })
  expect([first?.ended(), second?.ended()]).toEqual([false, true])
  started[1]?.say(answered('of no use'))
  await vi.waitFor(() => expect(started[1]?.sent[1]?.path).toBe('/other'))
  finish.abort()
  expect(first?.ended()).toBe(true)
  started[0]?.say(answered('plans'))
  started[1]?.say(answered(''))
  expect(new TextDecoder().decode((await search).body)).toBe('plans')
  expect((await other).status).toBe(200)
})

test('workers share calls of loops, what they give, and the time', () => {
  const team = new Team(2)
  const [one, other] = [0, 1].map((number) => new Member(team.place(number))) as [Member, Member]
  expect([one.begin(3), other.begin(3)]).toEqual([true, true])
  expect(one.begin(5)).toBe(false) // within the first
  expect([one.take(), other.take(), one.take()]).toEqual([0, 1, 2])
  const key = Int32Array.of(1, 2, 3, 4)
  expect(other.find(key)).toBe(-1)
  one.keep(key, bytes('closed'))
  expect(other.find(key)).toBe(6)
  expect(other.takeFound()).toEqual(bytes('closed'))
  expect(other.find(Int32Array.of(1, 2, 3, 5))).toBe(-1)
  expect([one.now(5n), other.now(7n)]).toEqual([5n, 5n])
  team.lose() // of a worker that has died nothing is waited for
  expect(one.take()).toBe(-1)
  expect(other.take()).toBe(-1)
})

test('what was kept long ago makes room', () => {
  const [one] = [new Member(new Team(2).place(0))]
  const large = new Uint8Array(8 << 20)
  for (let i = 0; i < 9; ++i) one.keep(Int32Array.of(i, 0, 0, 0), large.fill(i))
  expect(one.find(Int32Array.of(0, 0, 0, 0))).toBe(-1)
  expect(one.find(Int32Array.of(4, 0, 0, 0))).toBe(large.length)
  expect(one.takeFound()[0]).toBe(4)
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

test.each(['/v1/information', '/v1/comparisons', '/v1/valves:observe'])('the engine answers %s', async (path) => {
  const { ask, asked } = service()
  expect((await ask('POST', path, { valve: 'barlow' })).status).toBe(200)
  expect(asked).toEqual([{ path, body: `{"valve":${VALVE}}` }])
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
    expect(await answer.json()).toMatchObject({ detail: 'this request requires coapt-server', problems: [] })
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
  const { ask, searches, search } = service()
  const started = ask('POST', '/v1/plans', { valve: 'barlow', search: { evaluations: 9 } })
  await Promise.resolve()
  await vi.waitFor(() => expect(searches.length).toBe(1))
  expect(searches[0]).toMatchObject({ path: '/v1/plans', body: `{"valve":${VALVE},"search":{"evaluations":9}}` })
  searches[0]?.progress?.({ ...NOW, closures: 1, closures_planned: 9 })
  const response = await started
  expect(response.status).toBe(202)
  const { id, valve, links } = await response.json()
  expect(valve).toBe('barlow')
  expect((await ask('POST', '/v1/plans', { valve: 'barlow' })).status).toBe(409)
  expect((await ask('GET', `${links.self}/result`)).status).toBe(501)

  const first = await ask('GET', `${links.events}?last_event_id=0`)
  const events = (await ask('GET', `${links.events}?last_event_id=0`)).text()
  const same = first.text() // two may follow it
  searches[0]?.progress?.({ ...NOW, closures: 5, closures_planned: 9 })
  search.answer({ status: 200, body: bytes('{"plans":[{"rank":1}]}') })
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

test('a search that is refused is no job; one that is cancelled has what it found; one may fail', async () => {
  const { ask, searches, search } = service()
  const begun = async (closures: number) => {
    const count = searches.length
    const answer = ask('POST', '/v1/plans', { valve: 'barlow' })
    await vi.waitFor(() => expect(searches.length).toBe(count + 1))
    if (closures > 0) searches[count]?.progress?.({ ...NOW, closures, closures_planned: 9 })
    return answer
  }
  const refused = begun(0)
  await vi.waitFor(() => expect(searches.length).toBe(1))
  search.answer({ status: 422, body: bytes('{"detail":"is no option"}') })
  expect((await refused).status).toBe(422)

  const { links } = await (await begun(1)).json()
  const events = (await ask('GET', links.events)).text()
  expect(await (await ask('POST', links.cancel)).json()).toMatchObject({ state: 'RUNNING', cancel_requested: true })
  expect(searches[1]?.finish?.aborted).toBe(true)
  search.answer({ status: 200, body: bytes('{"stop":"cancelled","plans":[{"rank":1}]}') })
  expect(await events).toContain('"state":"CANCELLED"')
  const job = await (await ask('GET', links.self)).json()
  expect(await (await ask('GET', job.links.result)).json()).toMatchObject({ plans: [{ rank: 1 }] })

  const dropped = await (await begun(1)).json()
  expect((await ask('DELETE', dropped.links.self)).status).toBe(204)
  expect(searches[2]?.signal?.aborted).toBe(true)

  const failed = await (await begun(1)).json()
  search.fail(new Error('out of memory'))
  await vi.waitFor(async () =>
    expect(await (await ask('GET', failed.links.self)).json()).toMatchObject({
      state: 'FAILED',
      problems: [{ message: 'out of memory' }],
    }),
  )
})
