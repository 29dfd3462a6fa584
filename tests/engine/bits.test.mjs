// The engine as WebAssembly against the native one: node --test tests/engine/bits.test.mjs, after make build and make wasm.
import assert from 'node:assert/strict'
import { execFileSync } from 'node:child_process'
import { mkdtempSync, readFileSync, rmSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { after, test } from 'node:test'
import { hash, module } from './module.mjs'

const build = join(import.meta.dirname ?? new URL('.', import.meta.url).pathname, '../../build')
const folder = mkdtempSync(join(tmpdir(), 'coapt-presets-'))
after(() => rmSync(folder, { recursive: true }))
const native = execFileSync(join(build, 'release/bin/closed_presets'), [folder], { encoding: 'utf8' })
const engine = await module(readFileSync(join(build, 'wasm/bin/coapt-engine.wasm')))
const valve = (name) => readFileSync(join(folder, `${name}.json`), 'utf8')

for (const line of native.trim().split('\n')) {
  const [name, steps, bits] = line.split(' ')
  test(`${name} closes to the native program's bits`, () => {
    const { status, json } = engine.answer('/v1/closures', `{"valve": ${valve(name)}}`)
    assert.equal(status, 200)
    assert.equal(json.steps, Number(steps))
    assert.equal(hash(engine.closed()), bits)
  })
}

test('leaks are those of the native program to 0.01 mm2', () => {
  for (const name of ['human-functional-mr', 'barlow']) {
    const { json } = engine.answer('/v1/closures', `{"valve": ${valve(name)}}`)
    const closed = JSON.parse(run('close', join(folder, `${name}.json`), '--json'))
    for (const area of ['orifice_area_mm2', 'orifice_area_raw_mm2', 'leak_mm2'])
      assert.ok(Math.abs(json[area] - closed[area]) <= 0.01, `${name}: ${area} ${json[area]}, native ${closed[area]}`)
  }
})

test('what is wrong with a request is told with its place', () => {
  const { status, json } = engine.answer('/v1/scenes', `{"valve": ${valve('barlow')}, "frames": -1, "plan": {}}`)
  assert.equal(status, 422)
  assert.deepEqual(json.problems.map(({ path }) => path).sort(), ['/frames', '/plan/schema', '/plan/steps'])
  assert.equal(engine.answer('/v1/closures', '{').status, 400)
  assert.equal(engine.answer('/v1/jobs', '').status, 404)
})

/// coapt's exit code says whether a valve leaks; its words come either way.
function run(...words) {
  try {
    return execFileSync(join(build, 'release/bin/coapt'), words, { encoding: 'utf8', stdio: ['ignore', 'pipe', 'ignore'] })
  } catch (leaks) {
    return leaks.stdout
  }
}
