// The views Search and Studies in a browser: a small search, two plans compared, a small study, what is wrong said at its
// option; axe-core in both themes and on a tablet's width.
//   node test/browser/search_and_studies.mjs http://127.0.0.1:8080 [folder for screenshots]
import assert from 'node:assert/strict'
import { readFileSync } from 'node:fs'
import { chromium } from 'playwright-core'

const [base = 'http://127.0.0.1:8080', shots] = process.argv.slice(2)
const axe = readFileSync(new URL('../../node_modules/axe-core/axe.min.js', import.meta.url), 'utf8')
const LONG_MS = 300_000 // a search on a busy machine
const browser = await chromium.launch({
  executablePath: process.env.CHROMIUM ?? '/usr/bin/chromium',
  args: ['--no-sandbox'],
})
const page = await browser.newPage({ viewport: { width: 1280, height: 900 } })
const errors = []
page.on('pageerror', (error) => errors.push(error.message))
page.on('console', (message) => message.text().includes('Content Security Policy') && errors.push(message.text()))

/// In both themes and widths: nothing that axe knows to be wrong, nothing that sticks out.
async function check(name) {
  for (const colorScheme of ['light', 'dark'])
    for (const width of [1280, 820]) {
      await page.emulateMedia({ colorScheme })
      await page.setViewportSize({ width, height: 900 })
      await page.evaluate(axe)
      const found = await page.evaluate(async () =>
        (await window.axe.run(document)).violations.map(
          ({ id, nodes }) => `${id}: ${nodes.map(({ target }) => target.join(' ')).join(', ')}`,
        ),
      )
      assert.deepEqual(found, [], `${name}, ${colorScheme}, ${width} px`)
      assert.equal(
        await page.evaluate(() => document.documentElement.scrollWidth - innerWidth),
        0,
        `${name}: wider than ${width} px`,
      )
      if (shots) await page.screenshot({ path: `${shots}/${name}-${colorScheme}-${width}.png`, fullPage: true })
    }
  await page.emulateMedia({ colorScheme: 'light' })
  await page.setViewportSize({ width: 1280, height: 900 })
}

const set = (label, value) => page.getByLabel(label, { exact: true }).fill(value)

await page.goto(`${base}/#search`)
await page.waitForSelector('.search-form strong:text("human-functional-mr")')
await set('Ranked plans', '0')
await page.click('text=Start the search')
await page.waitForSelector('.option:has-text("Ranked plans") .problems')
await check('search-refused')

await page.click('text=Defaults')
await set('Closures', '60')
await set('Ranked plans', '2')
await set('Region points', '33')
await page.getByLabel('Evidence').uncheck()
const asked = page.waitForResponse((response) => response.status() === 202)
await page.click('text=Start the search')
const { id } = await (await asked).json()
await page.waitForFunction((job) => sessionStorage.getItem('coapt-open-plans') === job, id)
await page.reload() // a search survives it
await page.waitForSelector('.plan img[src]', { timeout: LONG_MS })
assert.equal(await page.locator('.plan').count(), 2)
await page.locator('.compare input').nth(0).check()
await page.locator('.compare input').nth(1).check()
await page.waitForSelector('.comparison .heat')
await page.locator('.plan > details > summary').first().click()
await check('search-compared')
const saved = page.waitForEvent('download')
await page.click('text=Plan (JSON)')
assert.equal(JSON.parse(readFileSync(await (await saved).path(), 'utf8')).schema, 'coapt.plan/1')

await page.goto(`${base}/#studies`)
await page.waitForSelector('.study-form strong:text("human-functional-mr")')
await page.click('text=Start the study')
await page.waitForSelector('.plot canvas', { timeout: LONG_MS })
await page.locator('.plot').first().focus()
await page.keyboard.press('ArrowRight')
assert.notEqual(await page.locator('.legend .value').first().textContent(), '')
await page.locator('.legend button').first().click()
assert.equal(await page.locator('.legend button').first().getAttribute('aria-pressed'), 'false')
await page.locator('.as-table summary').first().click()
assert.ok((await page.locator('.as-table tbody tr').count()) > 3)
await check('study')

await page.goto(`${base}/#search`)
await page.waitForSelector('.plan')
await page.click('text=Try by hand')
await page.waitForFunction(() => location.hash === '#repair')
assert.deepEqual(errors, [])
await browser.close()
console.log('The views Search and Studies work.')
