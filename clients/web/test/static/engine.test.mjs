// The engine as browsers run it, against the native programs.
import { execFileSync } from 'node:child_process'
import { mkdtempSync, readFileSync, rmSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { fileURLToPath } from 'node:url'
import { afterAll, beforeAll, expect, test } from 'vitest'
import { readPicture } from '../../src/engine/picture'
import { native } from '../native.mjs'
import { hash, startInNode } from './bits.mjs'

const ROOT = fileURLToPath(new URL('../../../../', import.meta.url))
const BIN = join(ROOT, 'build/release/bin')
const MODULE = join(ROOT, 'build/wasm/bin/coapt-engine.wasm')
const PATIENCE_MS = 1_200_000
const RING = { schema: 'coapt.plan/1', steps: [{ step: 'annuloplasty', shape: 'own', sizes_below: 2 }] }

const folder = mkdtempSync(join(tmpdir(), 'coapt-presets-'))
const presets = execFileSync(join(BIN, 'closed_presets'), [folder], { encoding: 'utf8' })
  .trim()
  .split('\n')
  .map((line) => line.split(' ')) // name, steps, bits
let engine, planner
beforeAll(async () => {
  engine = await startInNode(MODULE)
  planner = await startInNode(MODULE.replace('engine', 'planner'))
})
afterAll(() => rmSync(folder, { recursive: true }))

const textOf = (name) => readFileSync(join(folder, `${name}.json`), 'utf8')
const read = ({ status, body }) => ({ status, answer: JSON.parse(new TextDecoder().decode(body)) })

/// `valve`: a preset's name.
function ask(path, valve, more = {}, of = engine) {
  const fields = Object.entries(more).map(([name, value]) => `,${JSON.stringify(name)}:${JSON.stringify(value)}`)
  return read(of.answer(path, `{"valve":${textOf(valve)}${fields.join('')}}`))
}

/// An unsigned LEB128 number of a module at `place`.
function number(bytes, place) {
  let value = 0
  let shift = 0
  for (let at = place; ; at++, shift += 7) {
    value += (bytes[at] & 127) * 2 ** shift
    if (bytes[at] < 128) return { value, next: at + 1 }
  }
}

test('the stack is the first 4 MiB of memory, below which an overflow traps', () => {
  const bytes = readFileSync(MODULE)
  const GLOBALS = 6
  let at = 8 // behind magic and version
  while (bytes[at] !== GLOBALS) {
    const size = number(bytes, at + 1)
    at = size.next + size.value
  }
  // The first one is the stack pointer: an i32 that changes, from a constant on.
  const first = number(bytes, number(bytes, at + 1).next).next
  expect([...bytes.subarray(first, first + 3)]).toEqual([0x7f, 1, 0x41])
  expect(number(bytes, first + 3).value).toBe(4 * 1024 * 1024)
})

test.each(presets)("%s closes to the native program's bits", { timeout: PATIENCE_MS }, (name, steps, bits) => {
  const { status, answer } = ask('/v1/closures', name)
  expect(status).toBe(200)
  expect(answer.steps).toBe(Number(steps))
  expect(hash(engine.closed())).toBe(bits)
})

test('leaks are those of the native program to 0.01 mm²', { timeout: PATIENCE_MS }, () => {
  for (const name of ['human-functional-mr', 'barlow']) {
    const { answer } = ask('/v1/closures', name)
    const closed = native('close', join(folder, `${name}.json`))
    expect(Math.abs(answer.leak_mm2 - closed.leak_mm2)).toBeLessThanOrEqual(0.01)
    expect(answer.leak.openings.map(({ segments }) => segments)).toEqual(
      closed.leak.openings.map(({ segments }) => segments),
    )
  }
})

test('a scene has as many states of the closing as are asked for, at most, and the closure itself', () => {
  const { answer } = ask('/v1/scenes', 'human-functional-mr', { frames: 5 })
  expect(answer.motion_mm.length).toBeGreaterThan(1)
  expect(answer.motion_mm.length).toBeLessThanOrEqual(5)
  expect(answer.closure.status).toBe('converged')
})

test('a valve opens as natively', { timeout: PATIENCE_MS }, () => {
  const { answer } = ask('/v1/openings', 'human-normal', { frames: 0 })
  expect(answer.gradient_mmhg).toBeCloseTo(native('open', 'human-normal').gradient_mmhg, 2)
})

test('a valve leaks for the reason that the native program names', { timeout: PATIENCE_MS }, () => {
  for (const name of ['human-normal', 'barlow', 'human-functional-mr']) {
    const { answer } = ask('/v1/diagnoses', name)
    const told = native('diagnose', name)
    expect(answer.type).toBe(told.type)
    expect(answer.segments.map(({ finding }) => finding)).toEqual(told.segments.map(({ finding }) => finding))
  }
})

test('what coapt says that browsers do, the module that searches does', () => {
  for (const { path, doors } of native('operations').operations) {
    const refused = read(planner.answer(path ?? '/nowhere', '{}'))
    expect(refused.status === 404, path ?? '').toBe(!doors.includes('browser'))
  }
})

test('a closure on finer meshes is that of the native program', { timeout: PATIENCE_MS }, () => {
  const { answer } = ask('/v1/closures', 'porcine-1', { accuracy_mm2: 20, open: true })
  const told = native('close', join(folder, 'porcine-1.json'), '--accuracy', '20', '--open')
  expect(answer.accuracy).toEqual(told.accuracy)
  expect(answer.leak_mm2).toBeCloseTo(told.leak_mm2, 1)
  expect(answer.opening.opening_area_mm2).toBeCloseTo(told.opening.opening_area_mm2, 0)
})

test('a search tries and ranks the plans of the native program', { timeout: PATIENCE_MS }, () => {
  const options = ['--evaluations', '40', '--region-points', '5', '--plans', '2', '--fine-levels', '0']
  const file = join(folder, 'small.json')
  execFileSync(join(BIN, 'coapt'), ['valve', 'make', 'human-p2-prolapse', '--triangles', '200', '-o', file])
  const told = native('plan', file, ...options, '--model-draws', '0', '--no-evidence')
  const search = { evaluations: 40, region_points: 5, plans: 2, fine_levels: 0, model_draws: 0, evidence: false }
  const { status, answer } = ask('/v1/plans', 'small', { search }, planner)
  expect(status).toBe(200)
  const shown = ({ plans_tried, closures, plans }) => ({
    plans_tried,
    closures,
    plans: plans.map(({ plan, class: kind }) => ({ plan, kind })),
  })
  expect(shown(answer)).toEqual(shown(told))
  for (const [i, { cost }] of told.plans.entries()) expect(answer.plans[i].cost).toBeCloseTo(cost, 6)
})

test('rings and the version are there without a body', () => {
  expect(engine.answer('/v1/rings', '').status).toBe(200)
  expect(read(engine.answer('/version', '')).answer.version).toMatch(/^\d+\.\d+/)
})

test('what is wrong is answered with its place', () => {
  const { status, answer } = ask('/v1/scenes', 'barlow', { frames: -1, plan: {} })
  expect(status).toBe(422)
  expect(answer.problems.map(({ path }) => path).sort()).toEqual(['/frames', '/plan/schema', '/plan/steps'])
  expect(engine.answer('/v1/closures', '{').status).toBe(400)
  expect(engine.answer('/v1/jobs', '').status).toBe(404)
})

const pull = (vertex) => `advance 600
hash
grab 0 ${vertex}
move 0 0 -2 4
advance 300
cable 1 3 0.5
move 1 -5 2 -12.5
advance 300
hash
change ${JSON.stringify(RING)}
advance 300
pressure 60
advance 300
hash
release 0
release 1
advance 600
hash`

/// As tests/engine/live_pull.cpp does it.
function follow(script, valve) {
  const { live } = engine
  const hashes = []
  expect(live.start(`{"valve":${valve}}`).status).toBe(200)
  for (const line of script.split('\n')) {
    const [what, ...words] = line.split(' ')
    const [hook, ...numbers] = words.map(Number)
    if (what === 'change') expect(live.change(`{"valve":${valve},"plan":${words.join(' ')}}`).status).toBe(200)
    if (what === 'pressure') live.pressure(hook)
    if (what === 'grab') live.grab(hook, ...numbers)
    if (what === 'cable') live.grabCable(hook, ...numbers)
    if (what === 'move') live.move(hook, ...numbers)
    if (what === 'release') live.release(hook)
    if (what === 'advance') live.advance(hook)
    if (what === 'hash') hashes.push(hash(live.vertices()))
  }
  return hashes
}

test('a valve that is pulled, pressed and repaired has the bits of the native program', {
  timeout: PATIENCE_MS,
}, () => {
  for (const name of ['human-normal', 'barlow']) {
    const script = pull(361)
    const file = join(folder, `${name}.json`)
    const expected = execFileSync(join(BIN, 'live_pull'), [file, script], { encoding: 'utf8' }).trim().split('\n')
    expect(expected.length).toBe(4)
    expect(follow(script, textOf(name))).toEqual(expected)
  }
})

test('what makes no sense leaves the valve as it is', () => {
  const { live } = engine
  live.start(`{"valve":${textOf('human-normal')}}`)
  const before = hash(live.vertices())
  live.grab(2, 0)
  live.grab(0, -1)
  live.grab(0, 1_000_000)
  live.grabCable(0, 1_000_000, 0.5)
  live.grabCable(0, 0, Number.NaN)
  live.move(0, 0, 0, 0)
  live.pressure(Number.NaN)
  live.pressure(1e6)
  live.release(-1)
  const { hooks, pressure_mmhg } = readPicture(live.picture(), 0)
  expect(hooks).toEqual([null, null])
  expect(pressure_mmhg).toBeCloseTo(120, 0)
  expect(hash(live.vertices())).toBe(before)
  live.grab(0, 361)
  live.move(0, 0, Number.POSITIVE_INFINITY, 0)
  live.advance(60)
  expect([...live.picture()].every(Number.isFinite)).toBe(true)
})
