// The package for npm as its users get it: packed, installed into an empty project, in Node.js and in Chromium.
import assert from 'node:assert/strict'
import { execFileSync } from 'node:child_process'
import { mkdtempSync, rmSync, writeFileSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { after, before, test } from 'node:test'
import { pathToFileURL } from 'node:url'
import { COAPT, native } from '../native.mjs'
import { ROOT, startBrowser } from '../page/page.mjs'
import { startFiles } from '../static/files.mjs'

const PACKAGE = join(ROOT, 'build/npm')
const SEARCH = { evaluations: 30, region_points: 5, plans: 2, fine_levels: 0, model_draws: 0, evidence: false }
const PATIENCE_MS = 1_200_000
const RING = { schema: 'coapt.plan/1', steps: [{ step: 'annuloplasty', shape: 'own', sizes_below: 2 }] }

const folder = mkdtempSync(join(tmpdir(), 'coapt-npm-'))
let api, coapt, small
before(async () => {
  const [{ filename }] = JSON.parse(
    execFileSync('npm', ['pack', PACKAGE, '--json', '--pack-destination', folder], { encoding: 'utf8', cwd: folder }),
  )
  writeFileSync(join(folder, 'package.json'), JSON.stringify({ name: 'empty', private: true, type: 'module' }))
  execFileSync('npm', ['install', '--offline', '--no-audit', '--no-fund', join(folder, filename)], { cwd: folder })
  api = await import(pathToFileURL(join(folder, 'node_modules/coapt/index.js')))
  coapt = await api.load()
  const text = execFileSync(COAPT, ['valve', 'make', 'human-functional-mr', '--triangles', '200', '-o', '-'], {
    encoding: 'utf8',
  })
  small = await coapt.valve(text)
})
after(() => {
  coapt.close()
  rmSync(folder, { recursive: true, force: true })
})

const planOf = ({ plans }) => plans.map(({ plan, class: kind }) => ({ plan, kind }))

test('presets close as natively, several at a time', async () => {
  assert.equal(coapt.presets.length, native('presets').presets.length)
  const names = coapt.presets.slice(0, 4)
  const leaks = await Promise.all(names.map(async (name) => (await (await coapt.preset(name)).close()).leak.area_mm2))
  assert.deepEqual(
    leaks,
    names.map((name) => native('close', name).leak.area_mm2),
  )
})

test('a repaired valve opens, is diagnosed and observed', async () => {
  const valve = await coapt.preset('human-functional-mr')
  const [bare, ringed] = await Promise.all([valve.open(), valve.open({ plan: RING })])
  assert.ok(ringed.opening_area_mm2 < bare.opening_area_mm2)
  assert.equal((await valve.diagnose()).type, 'IIIb')
  const seen = await valve.observe({ leak_mm2: { value: 30, sd: 8, source: 'echo' } })
  assert.equal(seen.document.observed.leak_mm2.value, 30)
  assert.equal(valve.document.observed, undefined)
})

test('a search tells how far it is and finds the plans of coapt plan', { timeout: PATIENCE_MS }, async () => {
  const file = join(folder, 'small.json')
  writeFileSync(file, JSON.stringify(small.document))
  const told = []
  const leading = []
  const progress = (done, planned, { best }) => {
    told.push([done, planned])
    if (best) leading.push(best)
  }
  const found = await small.plan(SEARCH, { progress })
  const options = ['--evaluations', '30', '--region-points', '5', '--plans', '2', '--fine-levels', '0']
  const expected = native('plan', file, ...options, '--model-draws', '0', '--no-evidence')
  assert.deepEqual(planOf(found), planOf(expected))
  assert.ok(told.length > 2, `${told}`)
  assert.ok(told.every(([done, planned]) => done <= planned))
  assert.ok(leading.at(-1).description.length > 0)
  const scored = await small.evaluate([RING], { region_points: 5 })
  assert.equal(scored.plans.length, 1)
})

test('a search has the same bits with any number of threads, also if one leaves it', {
  timeout: PATIENCE_MS,
}, async () => {
  const found = []
  for (const threads of [1, 2, 3]) {
    const other = await api.load({ threads })
    const valve = await other.valve(small.document)
    let closed = threads === 2 && null // is asked for once the search has begun
    const progress = (done) => {
      if (closed === null && done > 10) closed = valve.close()
    }
    const { seconds, ...plans } = await valve.plan(SEARCH, { progress })
    assert.ok(seconds > 0)
    if (closed) assert.equal((await closed).status, 'converged')
    found.push(plans)
    other.close()
  }
  assert.deepEqual(found[1], found[0])
  assert.deepEqual(found[2], found[0])
})

test('a search that is to finish has its best plans so far', { timeout: PATIENCE_MS }, async () => {
  const stop = new AbortController()
  const progress = (done) => done > 30 && stop.abort()
  const {
    stop: why,
    plans,
    closures,
  } = await small.plan({ ...SEARCH, evaluations: 100_000 }, { finish: stop.signal, progress })
  assert.equal(why, 'cancelled')
  assert.ok(plans.length > 0)
  assert.ok(closures < 1000, `${closures}`)
})

test('a search that is aborted ends, and others go on', { timeout: PATIENCE_MS }, async () => {
  const stop = new AbortController()
  const begun = Date.now()
  const search = small.plan({ evaluations: 100_000 }, { signal: stop.signal, progress: () => stop.abort() })
  await assert.rejects(search, { name: 'AbortError' })
  assert.equal((await small.diagnose()).competent, false)
  await assert.rejects(small.close({}, { signal: AbortSignal.abort() }), { name: 'AbortError' })
  assert.ok(Date.now() > begun)
})

test('after close() nothing goes on', async () => {
  const other = await api.load({ threads: 1 })
  const valve = await other.valve(small.document)
  const asked = [valve.plan({ evaluations: 100_000 }), valve.diagnose(), valve.close()]
  setTimeout(() => other.close(), 200)
  for (const { status, reason } of await Promise.allSettled(asked)) {
    assert.equal(status, 'rejected')
    assert.match(reason.message, /closed/)
  }
  await assert.rejects(valve.close(), /closed/)
})

test('what is refused says where and why', async () => {
  await assert.rejects(coapt.preset('no-such-valve'), RangeError)
  await assert.rejects(coapt.valve('{'), api.CoaptError)
  await assert.rejects(coapt.valve({}), ({ problems, status }) => status === 422 && problems.length > 3)
  await assert.rejects(small.plan({ evaluatoins: 5 }), ({ problems }) => /evaluatoins/.test(problems[0].path))
  await assert.rejects(api.load({ threads: 0 }), RangeError)
})

test('a program that has its answer ends', () => {
  const script = "import { load } from 'coapt'; console.log((await load()).presets.length)"
  const asks =
    "import { load } from 'coapt'; const v = await (await load()).preset('human-normal'); console.log((await v.close()).status)"
  for (const [program, said] of [
    [script, String(coapt.presets.length)],
    [asks, 'converged'],
  ]) {
    const answer = execFileSync('node', ['--input-type=module', '-e', program], { cwd: folder, timeout: PATIENCE_MS })
    assert.equal(String(answer).trim(), said)
  }
})

test('a program in TypeScript sees what it misspells', () => {
  writeFileSync(
    join(folder, 'program.ts'),
    `import { load } from 'coapt'
const valve = await (await load()).preset('human-normal')
const area: number | null = (await valve.close()).leak.area_mm2
await valve.plan({ evaluations: 5 })
// @ts-expect-error: no such option
await valve.plan({ evaluatoins: 5 })
console.log(area)
`,
  )
  const options = [
    '--noEmit',
    '--strict',
    '--target',
    'es2022',
    '--module',
    'nodenext',
    '--moduleResolution',
    'nodenext',
  ]
  execFileSync(join(ROOT, 'clients/web/node_modules/.bin/tsc'), [...options, '--lib', 'es2022,dom', 'program.ts'], {
    cwd: folder,
    stdio: 'inherit',
  })
})

test('a browser searches, too', { timeout: PATIENCE_MS }, async () => {
  const files = await startFiles(join(folder, 'node_modules/coapt'))
  const browser = await startBrowser()
  try {
    const page = await browser.newPage()
    await page.goto(`${files.url}/README.md`)
    const found = await page.evaluate(
      async ([text, search]) => {
        const { load } = await import('/index.js')
        const coapt = await load()
        const leak = (await (await coapt.preset('barlow')).close()).leak.area_mm2
        return { leak, plans: await (await coapt.valve(text)).plan(search) }
      },
      [JSON.stringify(small.document), SEARCH],
    )
    assert.equal(found.leak, native('close', 'barlow').leak.area_mm2)
    assert.deepEqual(planOf(found.plans), planOf(await small.plan(SEARCH)))
  } finally {
    await browser.close()
    await files.stop()
  }
})
