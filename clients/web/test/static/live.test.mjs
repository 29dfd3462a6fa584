// The valve that is pulled, in a browser: by mouse, fingers, keys and scripts.
import assert from 'node:assert/strict'
import { copyFileSync, cpSync, mkdtempSync, readFileSync, rmSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { after, before, test } from 'node:test'
import { accessProblems, namedPoint, openView, ROOT, startBrowser, startService } from '../page/page.mjs'
import { startInNode } from './bits.mjs'
import { startFiles } from './files.mjs'

const STATIC = join(ROOT, 'build/static')
const VALVE = 'human-functional-mr'

let files, browser, page, complaints, cold
before(async () => {
  files = await startFiles(STATIC)
  browser = await startBrowser()
  ;({ page, complaints } = await openView(browser, files.url, 'live'))
  await atRest()
  cold = await closedVertices()
})
after(async () => {
  await browser.close()
  await files.stop()
  assert.deepEqual(complaints, [])
})

const state = () => page.evaluate(() => globalThis.coapt.live.state())
const force = (hook = 0) => page.evaluate((h) => globalThis.coapt.live.forceN(h), hook)
const vertices = () => page.evaluate(() => globalThis.coapt.live.vertices())
const atRest = (of = page) => of.waitForFunction(() => globalThis.coapt?.live?.state()?.at_rest)
const isHeld = (hook) => page.waitForFunction((h) => globalThis.coapt.live.state(h).spot !== null, hook)
const isFree = (hook) => page.waitForFunction((h) => globalThis.coapt.live.state(h).spot === null, hook)

/// Root mean square of the distances, mm.
function rms(a, b) {
  assert.equal(a.length, b.length)
  return Math.sqrt(a.reduce((sum, x, i) => sum + (x - b[i]) ** 2, 0) / (a.length / 3))
}

/// What close_valve makes of it.
async function closedVertices() {
  const engine = await startInNode(join(STATIC, 'coapt-engine.wasm'))
  engine.answer('/v1/closures', `{"valve":${readFileSync(join(STATIC, `presets/${VALVE}.json`), 'utf8')}}`)
  return [...new Float64Array(engine.closed().buffer)]
}

/// A place of the picture, as shares of it; without them the posterior leaflet's belly in the atrial view.
async function tissue(across = 0.5, down = 0.72) {
  const { x, y, width, height } = await page.locator('[data-part=live] canvas').boundingBox()
  return { x: x + width * across, y: y + height * down }
}

test('it closes as a closure does', async () => {
  assert.ok(rms(await vertices(), cold) <= 0.1)
  await page.locator('[data-part=live-state]', { hasText: 'At rest under 120 mmHg' }).waitFor()
})

test('the mouse grabs tissue, pulls it with a force, and lets it go: the valve beats and closes as before', async () => {
  const { x, y } = await tissue()
  const first = await vertices()
  await page.mouse.move(x, y)
  await page.mouse.down()
  await isHeld(0)
  for (let i = 1; i <= 8; ++i) {
    await page.mouse.move(x, y - 10 * i)
    assert.ok((await vertices()).every(Number.isFinite))
  }
  await page.waitForFunction(() => globalThis.coapt.live.forceN() > 0.5)
  await page.mouse.wheel(0, -400)
  await page.locator('[data-part=live-state]', { hasText: 'Pulled by one hook' }).waitFor()
  await page.locator('[data-part=hook] [data-part=force]', { hasText: /[1-9].* N/ }).waitFor()
  assert.ok(rms(await vertices(), first) > 0.2)
  assert.ok((await state()).latency_ms > 0)
  await page.mouse.up()
  await isFree(0)
  await atRest()
  assert.ok(rms(await vertices(), cold) <= 0.1)
  assert.ok((await page.evaluate(() => globalThis.coapt.live.stepsPerSecond)) > 0)
})

test('a hook that is pinned stays, and the next press is the other one', async () => {
  const { x, y } = await tissue()
  await page.getByLabel('Keep hooks in place after release').check()
  await page.mouse.move(x, y)
  await page.mouse.down()
  await page.mouse.move(x, y - 30)
  await page.mouse.up()
  await isHeld(0)
  const other = await tissue(0.62)
  await page.mouse.move(other.x, other.y)
  await page.mouse.down()
  await page.mouse.move(other.x, other.y - 40)
  await page.mouse.up()
  await isHeld(1)
  await page.waitForFunction(() => globalThis.coapt.live.forceN(0) > 0 && globalThis.coapt.live.forceN(1) > 0)
  await page.locator('[data-part=live-state]', { hasText: 'Pulled by two hooks' }).waitFor()
  assert.deepEqual(await accessProblems(page), [])
  await page.getByRole('button', { name: 'Let go of hook 1' }).click()
  await isFree(0)
  assert.ok((await force(1)) > 0)
  await page.getByRole('button', { name: 'Let go of hook 2' }).click()
  await page.getByLabel('Keep hooks in place after release').uncheck()
  await atRest()
})

test('two fingers are two hooks', async () => {
  const session = await page.context().newCDPSession(page)
  await session.send('Emulation.setTouchEmulationEnabled', { enabled: true, maxTouchPoints: 2 })
  const touch = (type, ...touchPoints) => session.send('Input.dispatchTouchEvent', { type, touchPoints })
  const [a, b] = [await tissue(0.42), await tissue(0.62)]
  await touch('touchStart', { ...a, id: 1 }, { ...b, id: 2 })
  for (let i = 1; i <= 4; ++i)
    await touch('touchMove', { ...a, y: a.y - 10 * i, id: 1 }, { ...b, y: b.y - 10 * i, id: 2 })
  await page.waitForFunction(() => globalThis.coapt.live.forceN(0) > 0 && globalThis.coapt.live.forceN(1) > 0)
  await touch('touchEnd')
  await isFree(0)
  await isFree(1)
  await session.send('Emulation.setTouchEmulationEnabled', { enabled: false })
  await atRest()
})

test('keys grab, move and let go', async () => {
  await page.getByRole('button', { name: 'P2', exact: true }).click()
  await isHeld(0)
  const first = (await state()).hand
  for (let i = 0; i < 4; ++i) await page.keyboard.press('Shift+ArrowUp')
  await page.keyboard.press('PageUp')
  await page.waitForFunction((from) => {
    const { hand } = globalThis.coapt.live.state()
    return hand[1] > from[1] + 7 && hand[2] > from[2] + 0.4 // anterior, and towards the atrium
  }, first)
  await page.keyboard.press('Escape')
  await isFree(0)
  await page.keyboard.press('Enter') // the canvas has the focus again
  await isHeld(0)
  await page.keyboard.press('Escape')
  await isFree(0)
  await atRest()
})

test('without pressure it hangs open, and pressed again it closes as before', async () => {
  await page.getByRole('slider', { name: 'Pressure, mmHg' }).fill('0')
  await page.locator('[data-part=live-state]', { hasText: 'At rest, flaccid' }).waitFor()
  assert.equal((await state()).pressure_mmhg, 0)
  assert.ok(rms(await vertices(), cold) > 1)
  await page.getByRole('button', { name: 'Systole' }).click()
  await page.locator('[data-part=live-state]', { hasText: 'At rest under 120 mmHg' }).waitFor()
  assert.ok(rms(await vertices(), cold) <= 0.1)
})

test('scripts pull at a vertex', async () => {
  await page.evaluate(() => {
    const { live } = globalThis.coapt
    live.grab(361)
    const [x, y, z] = live.vertices().slice(3 * 361)
    live.moveTo(x, y, z + 8)
  })
  await page.waitForFunction(() => globalThis.coapt.live.forceN() > 0.5)
  await page.evaluate(() => globalThis.coapt.live.release())
  await isFree(0)
  await atRest()
})

test('a ring is put in while it is pressed, and kept', async () => {
  await page.getByRole('button', { name: 'Ring' }).click()
  await page.waitForFunction(
    ([x]) => Math.abs(globalThis.coapt.live.vertices()[0] - x) > 0.3, // the first vertex is the annulus's
    cold,
  )
  await atRest()
  const ringed = await vertices()
  await page.getByRole('slider', { name: 'Undersized by, sizes' }).fill('5')
  await page.waitForFunction(([x]) => Math.abs(globalThis.coapt.live.vertices()[0] - x) > 0.3, ringed)
  await page.getByRole('button', { name: 'Keep this repair' }).click()
  await page.getByText('Kept as “plan 1”.').waitFor()
  await page.getByRole('button', { name: 'Remove step 1' }).click()
  await atRest()
})

test('a cut, the annular plane and a distance are shown', async () => {
  await page.getByLabel('Annular plane').check()
  await page.getByRole('slider', { name: 'Position of the cut' }).fill('0.2')
  await page.locator('[data-part=labels]').getByText('P1', { exact: true }).waitFor({ state: 'hidden' }) // with its half
  await page.getByRole('button', { name: 'Measure a distance' }).click()
  const { x, y } = await namedPoint(page.locator('[data-part=live]'), 'P3') // of the half that is left
  await page.mouse.click(x, y)
  await page.mouse.click(x + 20, y)
  await page.locator('[data-part=labels] [data-part=distance]', { hasText: /mm/ }).waitFor()
  assert.deepEqual(await accessProblems(page), [])
})

test('where browser or engine is missing the page says what', async () => {
  const context = await browser.newContext()
  const other = await context.newPage()
  await other.addInitScript(() => (WebAssembly.validate = () => false))
  await other.goto(`${files.url}/#live`)
  await other.getByText('This view requires WebAssembly with SIMD').waitFor()
  await context.close()
})

test('coapt-server hands it out under a policy that lets it run; without the engine the page says how to get it', async () => {
  const web = mkdtempSync(join(tmpdir(), 'coapt-web-'))
  cpSync(join(ROOT, 'build/web'), web, { recursive: true })
  copyFileSync(join(STATIC, 'coapt-engine.wasm'), join(web, 'coapt-engine.wasm'))
  const service = await startService([], { web })
  const { page: served, complaints: others } = await openView(browser, service.url, 'live')
  await atRest(served)
  assert.deepEqual(others, [])
  await served.route('**/coapt-engine.wasm', (route) => route.fulfill({ status: 404 }))
  await served.reload()
  await served.getByText('make wasm').first().waitFor()
  await served.context().close()
  await service.stop()
  rmSync(web, { recursive: true })
})
