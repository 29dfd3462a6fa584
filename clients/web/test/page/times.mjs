// How fast the page is here: the first view, a repair from letting go to its picture, frames per second and what each costs while a fine
// valve closes; what is sent, and without a service (make static) from the load to the first closure. `node times.mjs`; figures are of this machine, without a graphics card.
import { existsSync, readdirSync, readFileSync } from 'node:fs'
import { join } from 'node:path'
import { fileURLToPath } from 'node:url'
import { brotliCompressSync, gzipSync } from 'node:zlib'
import { countFrames, frameWords } from './frames.mjs'
import { openView, ROOT, startBrowser, startService } from './page.mjs'
import { startFiles } from '../static/files.mjs'

const FINE = fileURLToPath(new URL('../../../../examples/valves/bodyparts3d-2600.json', import.meta.url))
const RUNS = 7

const service = await startService()
const browser = await startBrowser()
const middle = (values) => values.sort((a, b) => a - b)[Math.floor(values.length / 2)]
const told = (values) =>
  `${Math.round(middle([...values]))} ms (${Math.round(Math.min(...values))} to ${Math.round(Math.max(...values))}, ${values.length} runs)`

const first = []
for (let i = 0; i < RUNS; ++i) {
  const { page } = await openView(browser, service.url, 'valve')
  await page.locator('[data-part=labels] [data-part=leak]').first().waitFor()
  first.push(await page.evaluate(() => performance.getEntriesByName('first valve')[0].startTime))
  await page.close()
}
console.log(`first view, from asking for the page to the drawn valve: ${told(first)}`)

const { page } = await openView(browser, service.url, 'repair')
await page.locator('[data-part=labels] [data-part=leak]').first().waitFor()
await page.getByRole('button', { name: 'Suture PM' }).click()
const answers = []
const slider = page.getByRole('slider', { name: 'Suture, mm' })
for (let i = 0; i < 3 * RUNS; ++i) {
  const length = Number(await slider.inputValue()) + (i % 2 === 0 ? -0.5 : 0.5)
  answers.push(
    await slider.evaluate(
      (input, value) =>
        new Promise((resolve) => {
          const start = performance.now()
          const seen = new MutationObserver(() => {
            if (!/Closed/.test(document.querySelector('[data-part=answer]').textContent)) return
            seen.disconnect()
            requestAnimationFrame(() => resolve(performance.now() - start))
          })
          seen.observe(document.querySelector('[data-part=answer]'), {
            childList: true,
            characterData: true,
            subtree: true,
          })
          input.value = String(value)
          input.dispatchEvent(new Event('change'))
        }),
      length,
    ),
  )
}
console.log(`a repair by hand, from letting go to its picture (650 triangles): ${told(answers)}`)
await page.close()

const fine = (await openView(browser, service.url, 'valve')).page
await fine.addInitScript(countFrames)
await fine.reload()
await fine.locator('[data-part=labels] [data-part=leak]').first().waitFor()
await fine
  .getByLabel('Your file')
  .setInputFiles({ name: 'fine.json', mimeType: 'application/json', buffer: readFileSync(FINE) })
await fine.locator('[data-part=open-valve]', { hasText: 'fine.json' }).waitFor()
const before = await fine.evaluate(() => ({ ...globalThis.frames }))
const frames = await fine.evaluate(
  () =>
    new Promise((resolve) => {
      const times = []
      const play = [...document.querySelectorAll('button')].find(
        (button) => button.textContent.trim() === 'Play the closing',
      )
      play.click()
      const step = (now) => {
        times.push(now)
        if (play.textContent.trim() === 'Stop') requestAnimationFrame(step)
        else resolve(times)
      }
      requestAnimationFrame(step)
    }),
)
const between = frames.slice(1).map((time, i) => time - frames[i])
console.log(
  `2,600 triangles closing, software rendering at 1280 x 800: ${(1000 / middle(between)).toFixed(0)} frames per second; ` +
    frameWords(await fine.evaluate(() => globalThis.frames), before),
)

for (const folder of ['web', 'static']) {
  const built = join(ROOT, 'build', folder)
  if (!existsSync(built)) continue
  const assets = readdirSync(join(built, 'assets')).map((name) => `assets/${name}`)
  const wasm = readdirSync(built).filter((name) => name.endsWith('.wasm'))
  for (const [what, names] of [
    ['page', ['index.html', 'favicon.svg', ...assets]],
    ...wasm.map((name) => [name, [name]]),
  ]) {
    const files = names.map((name) => readFileSync(join(built, name)))
    const kb = (pack) => Math.round(files.reduce((sum, file) => sum + pack(file).length, 0) / 1000)
    console.log(
      `build/${folder}, ${what}: ${kb((file) => file)} kB, gzip ${kb((file) => gzipSync(file))}, brotli ${kb((file) => brotliCompressSync(file))}`,
    )
  }
}
if (existsSync(join(ROOT, 'build/static'))) {
  const files = await startFiles(join(ROOT, 'build/static'))
  const loads = []
  for (let i = 0; i < RUNS; ++i) {
    const { page } = await openView(browser, files.url, 'valve')
    await page.locator('[data-part=labels] [data-part=leak]').first().waitFor()
    loads.push(await page.evaluate(() => performance.getEntriesByName('first valve')[0].startTime))
    await page.context().close()
  }
  console.log(`without a service, from asking for the page to the first valve, closed in the browser: ${told(loads)}`)
  await files.stop()
}

await browser.close()
await service.stop()
