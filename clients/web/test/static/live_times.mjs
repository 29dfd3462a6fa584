// How fast the valve that is pulled is here: `node live_times.mjs [PRESET]`, after make static. Steps a second in node and in
// Chromium over wall time of running; from a move of the mouse (its event's time) until the commands that draw a picture in
// which the valve has felt it are given, and the same with nothing drawn; draw calls and bytes a picture. Figures are of this machine, without a graphics card.
import { readFileSync } from 'node:fs'
import { join } from 'node:path'
import { countFrames, frameWords } from '../page/frames.mjs'
import { drawNothing } from '../page/looks.mjs'
import { openView, ROOT, startBrowser } from '../page/page.mjs'
import { startInNode } from './bits.mjs'
import { startFiles } from './files.mjs'

const STATIC = join(ROOT, 'build/static')
const STEPS = 30_000
const name = process.argv[2] ?? 'human-normal'
const share = (values, at) => [...values].sort((a, b) => a - b)[Math.floor(at * (values.length - 1))]

const { live } = await startInNode(join(STATIC, 'coapt-engine.wasm'))
live.start(`{"valve":${readFileSync(join(STATIC, `presets/${name}.json`), 'utf8')}}`)
live.advance(3000) // closes, and is compiled
live.grab(0, 361)
const [began, cpu] = [performance.now(), process.cpuUsage()]
for (let done = 0; done < STEPS; done += 300) {
  live.move(0, 0, -5, -6 + 3 * Math.sin(done / 600))
  live.advance(300)
}
const seconds = (performance.now() - began) / 1000
const busy = process.cpuUsage(cpu).user / 1e6
console.log(
  `node, ${name}: ${Math.round(STEPS / seconds)} steps per second of wall time, ${Math.round(STEPS / busy)} of processor time`,
)

const files = await startFiles(STATIC)
const browser = await startBrowser()
for (const [width, height, scripts] of [
  [1280, 800, [countFrames]],
  [700, 500, [countFrames]],
  [1280, 800, [countFrames, drawNothing]], // all that a picture takes beside being drawn
]) {
  const { page } = await openView(browser, files.url, 'studies', { width, height })
  for (const script of scripts) await page.addInitScript(script)
  await page.goto(`${files.url}/#/live?valve=${name}`)
  await page.reload()
  await page.waitForFunction(() => globalThis.coapt?.live?.state()?.at_rest)
  const box = await page.locator('[data-part=live] canvas').boundingBox()
  const [x, y] = [box.x + box.width / 2, box.y + 0.68 * box.height]
  await page.evaluate(() => {
    const seen = []
    let last = null
    globalThis.before = { ...globalThis.frames }
    const look = () => {
      const { latency_ms } = globalThis.coapt.live.state()
      if (latency_ms !== null && latency_ms !== last) seen.push(latency_ms)
      last = latency_ms
      requestAnimationFrame(look)
    }
    look()
    globalThis.seen = seen
  })
  await page.mouse.move(x, y)
  await page.mouse.down()
  for (let i = 0; i < 300; ++i) {
    await page.mouse.move(x + 20 * Math.sin(i / 10), y - 40 - 30 * Math.cos(i / 10))
    await page.waitForTimeout(16)
  }
  const { rate, pictures, seen, frames, before } = await page.evaluate(() => ({
    rate: globalThis.coapt.live.stepsPerSecond,
    pictures: globalThis.coapt.live.state().pictures_per_second,
    seen: globalThis.seen,
    frames: globalThis.frames,
    before: globalThis.before,
  }))
  await page.mouse.up()
  console.log(
    `Chromium, canvas ${Math.round(box.width)} x ${Math.round(box.height)}: ${Math.round(rate)} steps per second, ${Math.round(pictures)} frames per second; ` +
      `latency ${Math.round(share(seen, 0.5))} ms median, ${Math.round(share(seen, 0.95))} ms 95th percentile, ${Math.round(share(seen, 0))} ms least, of ${seen.length}; ` +
      (scripts.includes(drawNothing) ? 'nothing drawn' : frameWords(frames, before)),
  )
  await page.close()
}
await browser.close()
await files.stop()
