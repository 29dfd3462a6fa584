import { expect, test } from 'vitest'
import type { LiveEngine } from '../../src/engine/module'
import { type LiveCommand, LiveLoop, type LiveReply } from '../../src/engine/live_loop'
import { readPicture } from '../../src/engine/picture'
import { requireSimd } from '../../src/engine/thread'
import { LiveClient, type LiveThread } from '../../src/live/client'
import { Pictures, Rate } from '../../src/live/rates'
import { edgeOf, highlighted, prolapse } from '../../src/live/surface'
import { stateWords } from '../../src/live/state_words'
import { pyramid } from './scenes'

const bytes = (text: string) => new TextEncoder().encode(text) as Uint8Array<ArrayBuffer>

/// A loop with an engine that takes 1 ms for 30 steps and is at rest `rest` steps after the last command.
/// Hook 0 holds tissue at `spot`.
function loop(rest: number, spot = [0, 0, 0]) {
  let clock_ms = 0
  let left = 0
  const calls: string[] = []
  const sent: LiveReply[] = []
  const tasks: (() => void)[] = []
  const answer = { status: 200, body: bytes('{}') }
  const touched = (call: string): typeof answer => {
    calls.push(call)
    left = rest
    return answer
  }
  const engine: LiveEngine = {
    start: () => touched('start'),
    change: () => touched('change'),
    pressure: (mmhg) => touched(`pressure ${mmhg}`),
    grab: (hook, vertex) => touched(`grab ${hook} ${vertex}`),
    grabCable: (hook, cable, share) => touched(`cable ${hook} ${cable} ${share}`),
    move: (hook, ...to) => touched(`move ${hook} ${to.join(' ')}`),
    release: (hook) => touched(`release ${hook}`),
    advance(steps) {
      clock_ms += 1
      left -= steps
    },
    isAtRest: () => left <= 0,
    picture: () => Float32Array.from([100, 0, 0, 0, 0, 1, ...spot, ...Array<number>(16).fill(0)]),
    vertices: () => bytes(''),
  }
  const live = new LiveLoop(engine, {
    send: (reply) => sent.push(reply),
    later: (does) => tasks.push(does),
    now: () => clock_ms,
  })
  return { take: (command: LiveCommand) => live.take(command), next: () => tasks.shift()?.(), calls, sent, tasks }
}
const pictures = (sent: LiveReply[]) => sent.flatMap((reply) => (reply.live === 'picture' ? [reply] : []))

test('a valve runs in short batches until it is at rest, then sleeps', () => {
  const { take, next, tasks, sent } = loop(300)
  take({ live: 'start', body: '', id: 7 })
  expect(sent).toEqual([{ live: 'started', id: 7, status: 200, body: bytes('{}') }])
  let batches = 0
  for (; tasks.length > 0; ++batches) {
    expect(tasks.length).toBe(1)
    next()
  }
  expect(batches).toBe(3) // 300 steps are 10 ms
  take({ live: 'pressure', mmhg: 60 })
  take({ live: 'pressure', mmhg: 70 })
  expect(tasks.length).toBe(1)
})

test('pictures do not pile up: one for each that is asked for, and none where nothing is new', () => {
  const { take, next, tasks, sent } = loop(300)
  take({ live: 'picture' })
  take({ live: 'start', body: '', id: 1 })
  while (tasks.length > 0) next()
  expect(pictures(sent).length).toBe(1)
  take({ live: 'picture' })
  expect(pictures(sent).length).toBe(2)
  expect(pictures(sent)[1]).toMatchObject({ steps: 300, running_ms: 10 })
  take({ live: 'picture' })
  expect(pictures(sent).length).toBe(2)
})

test('a picture tells of a move once the valve has felt it', () => {
  const { take, next, sent, calls } = loop(300)
  take({ live: 'start', body: '', id: 1 })
  next()
  take({ live: 'grab', hook: 1, vertex: 5, at_mm: null })
  take({ live: 'move', hook: 1, to_mm: [1, 2, 3], asked_ms: 42 })
  take({ live: 'picture' })
  expect(pictures(sent)).toEqual([])
  next()
  expect(pictures(sent)[0]?.asked_ms).toBe(42)
  take({ live: 'picture' })
  next()
  expect(pictures(sent)[1]?.asked_ms).toBeNull()
  take({ live: 'grab cable', hook: 0, cable: 2, share: 0.5, at_mm: null })
  take({ live: 'release', hook: 1 })
  expect(calls.slice(1)).toEqual(['grab 1 5', 'move 1 1 2 3', 'cable 0 2 0.5', 'release 1'])
})

test('moves go from where the tissue that is held is, not from where the hand took hold', () => {
  const { take, calls } = loop(300, [1, 2, 3])
  take({ live: 'grab', hook: 0, vertex: 5, at_mm: [1, 1, 3] })
  take({ live: 'move', hook: 0, to_mm: [4, 1, 3], asked_ms: 0 })
  expect(calls.at(-1)).toBe('move 0 4 2 3')
})

function client() {
  const posted: unknown[] = []
  const thread: LiveThread = {
    postMessage: (message) => posted.push(message),
    onmessage: null,
    onerror: null,
    terminate: () => {},
  }
  const live = new LiveClient(thread)
  const reply = (data: LiveReply): void => thread.onmessage?.({ data } as MessageEvent<LiveReply>)
  return { live, posted, reply }
}

test('a valve goes to the engine as the text that it is', async () => {
  const { live, posted, reply } = client()
  const started = live.start('{"x": -0.0}', null, 0)
  const changed = live.change('{"x": -0.0}', { schema: 'coapt.plan/1', steps: [] })
  expect(posted).toEqual([
    { live: 'start', body: '{"valve":{"x": -0.0},"pressure_mmhg":0}', id: 1 },
    { live: 'change', body: '{"valve":{"x": -0.0},"plan":{"schema":"coapt.plan/1","steps":[]}}', id: 2 },
  ])
  reply({ live: 'started', id: 1, status: 200, body: bytes('{"systole_mmhg": 100}') })
  expect((await started).systole_mmhg).toBe(100)
  reply({ live: 'started', id: 2, status: 422, body: bytes('{"detail": "no", "problems": [{"path": "/plan"}]}') })
  await expect(changed).rejects.toMatchObject({ status: 422, message: 'no', problems: [{ path: '/plan' }] })
})

test('where there is no engine the page says how to get it', async () => {
  const { live, reply } = client()
  const told: string[] = []
  live.onFailure = (message) => told.push(message)
  const started = live.start('{}', null)
  reply({ live: 'failed', message: 'http://x/coapt-engine.wasm cannot be loaded (404)' })
  await expect(started).rejects.toThrow('make wasm')
  expect(told.length).toBe(1)
})

test('this engine runs SIMD', () => expect(requireSimd).not.toThrow())

test('a picture is read as the engine writes it', () => {
  const hook = [1, 1, 2, 3, 4, 5, 6, 3, 0, 4]
  const none = Array<number>(10).fill(0)
  const nodes = [1, 2, 3, 4, 5, 6]
  const picture = readPicture(Float32Array.from([120, 1, 0, 2, 0.5, ...hook, ...none, ...nodes, 0.25, 0.125]), 1)
  expect(picture).toMatchObject({ pressure_mmhg: 120, at_rest: true, beats: false, returns: 2, longest_move_mm: 0.5 })
  expect(picture.hooks).toEqual([{ spot_mm: [1, 2, 3], hand_mm: [4, 5, 6], force: [3, 0, 4], force_n: 5 }, null])
  expect([...picture.nodes]).toEqual(nodes)
  expect([...picture.cables]).toEqual([0.25, 0.125])
})

test('the state is told in words', () => {
  const picture = readPicture(Float32Array.from([119.9, 1, 0, 0, 0, ...Array<number>(20).fill(0)]), 0)
  expect(stateWords(picture)).toMatch(/^At rest under 120 mmHg\. Press a leaflet/)
  expect(stateWords({ ...picture, pressure_mmhg: 0 })).toMatch(/^At rest, flaccid\. Press a leaflet/)
  expect(stateWords({ ...picture, at_rest: false, beats: true })).toMatch(/beats/)
})

test('steps per second are of the last second in which the valve moved', () => {
  const rate = new Rate()
  expect(rate.aSecond).toBe(0)
  rate.add(0, 0)
  rate.add(500, 100)
  expect(rate.aSecond).toBe(5000)
  for (let ms = 200; ms <= 2000; ms += 100) rate.add(500 + ms, ms)
  expect(rate.aSecond).toBe(1000)
})

test('a pause is no slow picture', () => {
  const pictures = new Pictures()
  for (let ms = 0; ms <= 200; ms += 20) pictures.drawn(ms)
  expect(pictures.aSecond).toBeCloseTo(50)
  for (let ms = 10_000; ms <= 10_200; ms += 20) pictures.drawn(ms)
  expect(pictures.aSecond).toBeCloseTo(50)
})

test('tissue prolapses 2 mm above the annular plane and the line between its hinges', () => {
  const scene = pyramid() // the annulus at 0; vertex 4 is the free edge, above the middle
  const at = (z: number) => [...scene.rest_mm.slice(0, 14), z]
  expect(prolapse(scene, at(1.9))).toEqual([false, false, false, false, false])
  expect(prolapse(scene, at(2.1))).toEqual([false, false, false, false, true])
  const saddle = at(4.9)
  saddle[5] = 6 // its peak in front of the middle: the line is at 3 there
  expect(prolapse(scene, saddle)[4]).toBe(false)
  saddle[14] = 5.1
  expect(prolapse(scene, saddle)).toEqual([false, false, false, false, true])
  const colours = highlighted(scene, new Float32Array(36), [false, false, false, false, true])
  expect([...colours.slice(0, 6)].every((part) => part === 0)).toBe(true)
  expect([...colours.slice(6, 9)].every((part) => part > 0)).toBe(true)
})

test('the middle of a free edge is found', () => {
  const scene = pyramid()
  expect(edgeOf(scene, 'A3')).toBe(4)
  expect(edgeOf(scene, 'P2')).toBe(-1)
})
