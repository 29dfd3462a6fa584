// The page without a service, from a plain web server in a folder of it; then without any server.
import assert from 'node:assert/strict'
import { execFileSync } from 'node:child_process'
import { mkdtempSync, readdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { after, before, test } from 'node:test'
import { gzipSync } from 'node:zlib'
import { COAPT, native } from '../native.mjs'
import { accessProblems, openView, ROOT, startBrowser } from '../page/page.mjs'
import { tell } from '../page/telling.mjs'
import { engineScript, hash } from './bits.mjs'
import { startFiles } from './files.mjs'

const MOST_BYTES = 1_200_000 // compressed, without the presets and the module that searches, which has as many
const PATIENCE_MS = 1_200_000

let files, browser, page, complaints, folder
before(async () => {
  folder = mkdtempSync(join(tmpdir(), 'coapt-static-'))
  files = await startFiles(join(ROOT, 'build'))
  browser = await startBrowser()
  ;({ page, complaints } = await openView(browser, `${files.url}/static`, 'valve'))
  page.on('requestfailed', (request) => complaints.push(`failed ${request.url()}`))
  page.on(
    'response',
    (response) => response.status() >= 400 && complaints.push(`${response.status()} ${response.url()}`),
  )
})
after(async () => {
  await browser.close()
  await files.stop()
  rmSync(folder, { recursive: true, force: true })
  assert.deepEqual(complaints, [])
})

const opened = (name) => page.locator('[data-part=open-valve]', { hasText: name }).waitFor()
const headline = () => page.locator('[data-part=headline]').first().textContent()
const leak = () => page.locator('[data-part=measures] tr', { hasText: 'Leak' }).locator('td').allTextContents()
const number = (text) => Number.parseFloat(text)

test('a preset is closed as natively, and its leak stands there', async () => {
  await opened('human-functional-mr')
  await page.getByLabel('Preset').selectOption('human-p2-prolapse')
  await opened('human-p2-prolapse')
  await page.waitForFunction(() => /mm²/.test(document.querySelector('[data-part=headline]')?.textContent ?? ''))
  const expected = native('close', 'human-p2-prolapse')
  assert.ok(Math.abs(number((await leak())[0]) - expected.leak_mm2) <= 0.5, `${await leak()}, not ${expected.leak_mm2}`)
})

test('it is opened in diastole', async () => {
  await page.getByRole('button', { name: 'Open', exact: true }).click()
  assert.equal(await page.getByLabel('Open to closed').inputValue(), '-1')
  await page.locator('[data-part=diastole]', { hasText: 'mean gradient' }).waitFor()
})

test('a ring closes it again', async () => {
  await page.getByRole('link', { name: 'Repair' }).click()
  await page.getByRole('button', { name: 'Ring' }).click()
  await page.locator('[data-part=answer]', { hasText: 'Closed and measured' }).waitFor()
  const plan = join(folder, 'ring.json')
  const steps = [{ step: 'annuloplasty', shape: 'own', sizes_below: 2 }]
  writeFileSync(plan, JSON.stringify({ schema: 'coapt.plan/1', steps }))
  const expected = native('close', 'human-p2-prolapse', '--plan', plan)
  assert.ok(Math.abs(number((await leak())[1]) - expected.leak_mm2) <= 0.5, `${await leak()}, not ${expected.leak_mm2}`)
  assert.match(await headline(), /→/)
})

test('a story is told to its end by the engine alone', async () => {
  await tell(page, 'flail-p2', { pictures: false })
  await opened('fibroelastic-flail')
})

test('a repair is kept by the browser', async () => {
  await page.getByRole('button', { name: 'Keep this repair' }).click()
  await page.getByText('Kept as “plan 1”.').waitFor()
})

test('what needs coapt-server is not there, or says so', async () => {
  assert.equal(await page.getByRole('button', { name: 'Report' }).count(), 0)
  assert.equal(await page.getByRole('button', { name: 'Save file' }).count(), 0)
  await page.getByRole('link', { name: 'Studies' }).click()
  await page.getByText('Studies of a valve require coapt-server.').waitFor()
  assert.deepEqual(await accessProblems(page), [])
})

test('a kept repair is scored by the module that searches', async () => {
  await page.getByRole('link', { name: 'Repair' }).click()
  await page.getByRole('button', { name: 'Score plans' }).click()
  await page.getByText(/below 5 mm² in/).waitFor({ timeout: PATIENCE_MS })
})

const set = (label, value) => page.locator('[data-part=form]').getByLabel(label).first().fill(value)
async function startSearch(closures) {
  await page.locator('[data-part=form] details', { hasText: 'Optimiser' }).evaluate((fold) => (fold.open = true))
  await set('Closures', closures)
  await page.getByRole('button', { name: 'Start the search' }).click()
}

test('a search finds the plans of coapt plan', async () => {
  const file = join(folder, 'small.json')
  execFileSync(COAPT, ['valve', 'make', 'human-functional-mr', '--triangles', '200', '-o', file])
  await page.getByRole('link', { name: 'Valve' }).click()
  await page.getByLabel('Your file').setInputFiles(file)
  await opened('small.json')
  await page.getByRole('link', { name: 'Search' }).click()
  await set('Plans to show', '2')
  await page.locator('[data-part=form] details', { hasText: 'Optimiser' }).evaluate((fold) => (fold.open = true))
  await set('Region points', '5')
  await set('Mesh refined', '0')
  await set('Tissue variants', '0')
  await page.getByLabel('Evidence').uncheck()
  await startSearch('40')
  await page.locator('[data-part=plan]').nth(1).waitFor({ timeout: PATIENCE_MS })
  const options = [
    '--evaluations',
    '40',
    '--region-points',
    '5',
    '--plans',
    '2',
    '--fine-levels',
    '0',
    '--model-draws',
    '0',
  ]
  const { plans } = native('plan', file, ...options, '--no-evidence')
  const expected = plans.flatMap(({ description }) => description)
  assert.deepEqual(await page.locator('[data-part=plan] [data-part=steps] li').allTextContents(), expected)
  assert.deepEqual(await accessProblems(page), [])
})

test('a search that is refused says so, and one that is cancelled ends', async () => {
  await startSearch('0')
  await page.getByText('Closures is 0').waitFor()
  await startSearch('100000')
  await page.getByRole('progressbar').waitFor()
  await page.getByRole('button', { name: 'Cancel' }).click()
  await page.getByText('The search was cancelled before it found a plan.').waitFor()
  assert.deepEqual(await accessProblems(page), [])
})

test('a file is opened and found again after a reload; one that is wrong is not', async () => {
  await page.getByRole('link', { name: 'Valve' }).click()
  const valve = readFileSync(join(ROOT, 'build/static/presets/porcine-1.json'), 'utf8')
  const file = join(folder, 'mine.json')
  writeFileSync(file, valve.replace(/"pressure_kpa": *[\d.]+/, '"pressure_kpa": -3'))
  await page.getByLabel('Your file').setInputFiles(file)
  await page.locator('[data-part=problems] li', { hasText: 'Pressure: is -3' }).waitFor()
  writeFileSync(file, valve)
  await page.getByLabel('Your file').setInputFiles(file)
  await opened('mine.json')
  await page.reload()
  await opened('mine.json')
  assert.match(page.url(), /valve=[0-9a-f]{64}/)
})

test('a preset closes to the bits that it has in node', async () => {
  const script = await engineScript()
  const built = join(ROOT, 'build/static')
  const { startEngine } = new Function(`${script}; return coaptEngine`)()
  const engine = await startEngine(await WebAssembly.compile(readFileSync(join(built, 'coapt-engine.wasm'))))
  engine.answer('/v1/closures', `{"valve":${readFileSync(join(built, 'presets/barlow.json'), 'utf8')}}`)
  const bits = await page.evaluate(`(async () => {
    ${script}
    ${hash}
    const engine = await coaptEngine.startEngine(
      await WebAssembly.compile(await (await fetch('coapt-engine.wasm')).arrayBuffer()))
    engine.answer('/v1/closures', '{"valve": ' + (await (await fetch('presets/barlow.json')).text()) + '}')
    return hash(engine.closed())
  })()`)
  assert.equal(bits, hash(engine.closed())) // for all presets those of the native program: engine.test.mjs
})

test('without any server it is loaded and closes valves all the same', async () => {
  await page.evaluate(() => navigator.serviceWorker.ready)
  await page.waitForFunction(() => navigator.serviceWorker.controller !== null)
  await files.stop()
  await page.reload()
  await opened('mine.json')
  await page.getByLabel('Preset').selectOption('barlow')
  await opened('barlow')
  await page.getByRole('link', { name: 'Repair' }).click()
  await page.getByRole('button', { name: 'Ring' }).click()
  await page.locator('[data-part=answer]', { hasText: 'Closed and measured' }).waitFor()
})

test('from the second visit on threads search together, and a search that is cancelled keeps its best plans', async () => {
  assert.ok(await page.evaluate(() => globalThis.crossOriginIsolated))
  await page.getByRole('link', { name: 'Valve' }).click()
  await page.getByLabel('Your file').setInputFiles(join(folder, 'small.json'))
  await opened('small.json')
  await page.getByRole('link', { name: 'Search' }).click()
  await startSearch('100000')
  await page.locator('[data-part=leading] dd').first().waitFor({ timeout: PATIENCE_MS })
  const threads = page.workers().length
  const cores = await page.evaluate(() => navigator.hardwareConcurrency)
  assert.ok(threads > Math.min(cores, 8), `${threads} threads on ${cores} cores`) // beside that of closures
  await page.getByRole('button', { name: 'Cancel' }).click()
  await page.getByText('these are the best plans so far').waitFor({ timeout: PATIENCE_MS })
  assert.ok((await page.locator('[data-part=plan]').count()) > 0)
})

test('it can be loaded over a slow line', () => {
  const built = join(ROOT, 'build/static')
  const compressed = (name) => gzipSync(readFileSync(join(built, name))).length
  const names = readdirSync(built, { recursive: true }).filter((name) => /\.(html|js|css|svg|wasm)$/.test(name))
  const first = names.filter((name) => name !== 'coapt-planner.wasm') // which is loaded by the first search
  const bytes = first.map(compressed).reduce((sum, size) => sum + size)
  console.log(`the page without a service: ${bytes} bytes compressed, ${compressed('coapt-planner.wasm')} to search`)
  assert.ok(bytes < MOST_BYTES)
  assert.ok(compressed('coapt-planner.wasm') < MOST_BYTES)
})
