// A film of one pull for docs/images: `node live_pictures.mjs FOLDER`, after make static.
import { join } from 'node:path'
import { openView, ROOT, startBrowser } from '../page/page.mjs'
import { startFiles } from './files.mjs'

const EDGE = 361 // a vertex of P2's free edge
const COLUMNS = 4
const folder = process.argv[2] ?? '.'
const files = await startFiles(join(ROOT, 'build/static'))
const browser = await startBrowser()
const { page } = await openView(browser, files.url, 'live?valve=human-p2-prolapse', { width: 1010, height: 760 })
const state = () => page.evaluate(() => globalThis.coapt.live.state())
const until = (holds) => page.waitForFunction(holds, null, { polling: 'raf' })
const frames = []
async function frame(words) {
  const png = await page.locator('[data-part=live]').screenshot()
  frames.push({ words, png: `data:image/png;base64,${png.toString('base64')}` })
}

await until(() => globalThis.coapt?.live?.state()?.at_rest)
await page.getByRole('button', { name: 'Oblique' }).click()
await page.getByLabel('Annular plane').check()
await page.locator('[data-part=rates]').evaluate((rates) => (rates.hidden = true))
await page.waitForTimeout(500)
await page.evaluate(() => globalThis.coapt.live.pressure(0))
await until(() => globalThis.coapt.live.state().at_rest && globalThis.coapt.live.state().pressure_mmhg === 0)
await frame('flaccid, 0 mmHg')
await page.evaluate((vertex) => globalThis.coapt.live.grab(vertex), EDGE)
await until(() => globalThis.coapt.live.state().hand)
const [x, y, z] = (await state()).hand
const force = async () => `${(await page.evaluate(() => globalThis.coapt.live.forceN())).toFixed(2)} N`
for (const [i, way] of [5, 10, 15].entries()) {
  await page.evaluate(([x, y, z]) => globalThis.coapt.live.moveTo(x, y, z), [x, y, z + way])
  await page.waitForFunction(
    (z) => globalThis.coapt.live.state().at_rest && Math.abs(globalThis.coapt.live.state().hand[2] - z) < 0.01,
    z + way,
  )
  await frame(`${i === 0 ? 'hook at P2, ' : ''}${way} mm up: ${await force()}`)
}
for (const mmhg of [40, 120]) {
  await page.evaluate((mmhg) => globalThis.coapt.live.pressure(mmhg), mmhg)
  await page.waitForFunction((mmhg) => {
    const { at_rest, pressure_mmhg } = globalThis.coapt.live.state()
    return at_rest && pressure_mmhg === mmhg
  }, mmhg)
  await frame(`held, ${mmhg} mmHg: ${await force()}`)
}
await page.evaluate(() => globalThis.coapt.live.release())
await until(() => globalThis.coapt.live.state().beats)
await frame('let go, it beats: opening')
await until(() => globalThis.coapt.live.state().at_rest)
await frame('closed, 120 mmHg')

const sheet = await browser.newPage({ viewport: { width: 1400, height: 600 } })
const cells = frames.map(
  ({ words, png }, i) => `<figure><img src="${png}"><figcaption>${i + 1}. ${words}</figcaption></figure>`,
)
await sheet.setContent(`<!doctype html><style>body { margin: 0; display: grid; grid-template-columns: repeat(${COLUMNS}, 1fr); gap: 6px; background: #fff }
  figure { margin: 0 } img { width: 100%; display: block } figcaption { font: 15px 'Liberation Sans', sans-serif; padding: 4px 2px }</style>${cells.join('')}`)
await sheet.locator('body').screenshot({ path: join(folder, 'live-pull.png') })
await browser.close()
await files.stop()
