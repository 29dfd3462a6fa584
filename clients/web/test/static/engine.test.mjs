// The engine as browsers run it, against the native program.
import { execFileSync } from 'node:child_process'
import { mkdtempSync, readFileSync, writeFileSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { fileURLToPath } from 'node:url'
import { beforeAll, expect, test } from 'vitest'
import { startEngine } from '../../src/engine/module'

const ROOT = fileURLToPath(new URL('../../../../', import.meta.url))
const COAPT = process.env.COAPT_PROGRAM ?? join(ROOT, 'build/release/bin/coapt')
const PATIENCE_MS = 300_000
const RING = { schema: 'coapt.plan/1', steps: [{ step: 'annuloplasty', shape: 'own', sizes_below: 2 }] }

let engine
beforeAll(async () => {
  engine = await startEngine(await WebAssembly.compile(readFileSync(join(ROOT, 'build/wasm/bin/coapt-engine.wasm'))))
})

function preset(name) {
  return JSON.parse(readFileSync(join(ROOT, `build/static/presets/${name}.json`), 'utf8'))
}

function ask(path, body) {
  const { status, body: bytes } = engine(path, typeof body === 'string' ? body : JSON.stringify(body))
  return { status, answer: JSON.parse(new TextDecoder().decode(bytes)) }
}

function native(...args) {
  return JSON.parse(execFileSync(COAPT, [...args, '--json'], { encoding: 'utf8' }))
}

function expectSame(answer, expected) {
  expect(answer.status).toBe(expected.status)
  expect(answer.coaptation.height_mean_mm).toBeCloseTo(expected.coaptation.height_mean_mm, 1)
  expect(answer.tension_max_n).toBeCloseTo(expected.tension_max_n, 2)
  expect(answer.leak_mm2).toBeCloseTo(expected.leak_mm2, 1)
  expect(answer.orifice_area_mm2).toBeCloseTo(expected.orifice_area_mm2, 1)
}

for (const name of ['human-functional-mr', 'human-normal', 'barlow'])
  test(`${name} closes as natively`, { timeout: PATIENCE_MS }, () => {
    const { status, answer } = ask('/v1/closures', { valve: preset(name) })
    expect(status).toBe(200)
    expectSame(answer, native('close', name))
  })

test('a ring is applied as natively', { timeout: PATIENCE_MS }, () => {
  const plan = join(mkdtempSync(join(tmpdir(), 'coapt-static-')), 'ring.json')
  writeFileSync(plan, JSON.stringify(RING))
  const { answer } = ask('/v1/closures', { valve: preset('human-functional-mr'), plan: RING })
  expectSame(answer, native('close', 'human-functional-mr', '--plan', plan))
})

test('a scene has as many states of the closing as are asked for, at most, and the closure itself', () => {
  const { answer } = ask('/v1/scenes', { valve: preset('human-functional-mr'), frames: 5 })
  expect(answer.motion_mm.length).toBeGreaterThan(1)
  expect(answer.motion_mm.length).toBeLessThanOrEqual(5)
  expect(answer.closure.status).toBe('converged')
})

test('a valve opens as natively', { timeout: PATIENCE_MS }, () => {
  const { answer } = ask('/v1/openings', { valve: preset('human-normal'), frames: 0 })
  expect(answer.gradient_mmhg).toBeCloseTo(native('open', 'human-normal').gradient_mmhg, 2)
})

test('rings and the version are there without a body', () => {
  expect(ask('/v1/rings', '').status).toBe(200)
  expect(ask('/version', '').answer.version).toMatch(/^\d+\.\d+/)
})

test('what is wrong is answered with its place', () => {
  const wrong = { ...preset('human-normal'), pressure_kpa: -3 }
  const { status, answer } = ask('/v1/closures', { valve: wrong })
  expect(status).toBe(422)
  expect(answer.problems.map(({ path }) => path)).toEqual(['/valve/pressure_kpa'])
  expect(ask('/v1/closures', 'no JSON').status).toBe(400)
  expect(ask('/v1/jobs', '').status).toBe(404)
})
