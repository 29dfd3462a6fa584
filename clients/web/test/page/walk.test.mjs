// What a surgeon does from the first look to the report, and what is seen at each step, with a service that dies on the way.
import assert from 'node:assert/strict'
import { after, before, test } from 'node:test'
import { openView, resize, startBrowser, startService } from './page.mjs'

let service, browser, page
before(async () => {
  service = await startService()
  browser = await startBrowser()
  ;({ page } = await openView(browser, service.url, 'valve', { width: 1440, height: 900 })) // it complains while the service is away
})
after(async () => {
  await browser.close()
  await service.stop()
})

const headline = () => page.locator('[data-part=headline]:visible').first().textContent()
const leaks = () => page.evaluate(() => globalThis.coapt.state().leak_mm2)
const answered = () => page.locator('[data-part=answer]', { hasText: 'Closed and measured' }).waitFor()
const view = (name) => page.getByRole('link', { name, exact: true }).click()
const notice = (page_) => page_.locator('[data-part=notices]').getByText('The service does not respond')
const jobOf = () => page.evaluate(() => new URLSearchParams(location.hash.split('?')[1]).get('job'))
/// Repair's panel as it is meant to be: steps one below the other, a slider that is wide enough to be dragged.
async function panelIsWhole() {
  const region = page.getByRole('region', { name: 'The plan' })
  const panel = await region.boundingBox()
  for (const step of await page.locator('[data-part=steps] > li').all()) {
    const box = await step.boundingBox()
    assert.ok(box.width > 0.8 * panel.width, `a step of ${box.width} px in a panel of ${panel.width} px`)
  }
  const slider = region.getByRole('slider').first()
  if (await slider.count()) assert.ok((await slider.boundingBox()).width > 150)
}

test('the valve fills the stage at every size, and its leak is the largest text', async () => {
  await page.getByRole('button', { name: 'Not now' }).click() // what the first visit is offered
  for (const [width, height, least] of [
    [1440, 900, 0.5],
    [1280, 800, 0.5],
    [820, 1180, 0.45],
    [390, 844, 0.4],
  ]) {
    await resize(width, height, page)
    const canvas = await page.locator('[data-part=viewer] canvas').first().boundingBox()
    const seen = Math.min(canvas.y + canvas.height, height) - canvas.y
    assert.ok((canvas.width * seen) / (width * height) > least, `${width}: ${canvas.width} x ${seen}`)
    assert.match(await headline(), /^58 (± \d mm²|mm² \(\d+ to \d+\))/)
    assert.equal(await page.evaluate(() => document.documentElement.scrollWidth - innerWidth), 0)
  }
  await resize(1440, 900, page)
  await page.locator('[data-part=headline]', { hasText: /^58 mm² \(\d+ to \d+\).*tissue.*measure first/ }).waitFor()
})

test('a word explains itself', async () => {
  await page.getByRole('button', { name: 'Tenting area, mm²' }).click()
  await page.locator('[data-part=help]', { hasText: 'count as negative' }).waitFor()
  await page.keyboard.press('Escape')
  await page.locator('[data-part=help]').waitFor({ state: 'hidden' })
})

test('a repair is tried and kept', async () => {
  await view('Repair')
  await page.getByRole('button', { name: 'Ring' }).click()
  await answered()
  assert.match(await headline(), /^58 → [\d.]+ (± [\d.]+ mm²|mm² \([\d.]+ to [\d.]+\))/)
  await panelIsWhole()
  await page.getByRole('button', { name: 'Keep this repair' }).click()
  await page.getByRole('textbox', { name: 'Name of plan 1' }).waitFor()
})

test('a service that dies in a search is said to be away, and all goes on when it is back', async () => {
  await view('Search')
  await page.getByRole('button', { name: 'Start the search' }).click()
  await page.locator('[data-part=progress] dl', { hasText: /of \d/ }).waitFor()
  await service.kill()
  await notice(page).waitFor()
  await view('Repair')
  await page.getByRole('button', { name: 'Suture AL' }).click()
  assert.ok(await notice(page).isVisible())
  assert.ok(await page.evaluate(() => document.documentElement.hasAttribute('data-away')))
  const { port } = new URL(service.url)
  service = await startService([], { port, folder: service.folder })
  await notice(page).waitFor({ state: 'hidden' })
  await answered() // the suture, that nobody could close
  await view('Search')
  await page.locator('[data-part=progress]').waitFor()
})

test('what was found is tried by hand in a panel that is whole, and back leads to the search', async () => {
  await page.locator('[data-part=leading] dl div').first().waitFor() // a search that is cancelled before has no plan
  await page.getByRole('button', { name: 'Cancel' }).click()
  await page.locator('[data-part=plan]').first().waitFor()
  const job = await jobOf()
  await page.locator('[data-part=plan]').first().getByRole('button', { name: 'Try by hand' }).click()
  await page.waitForFunction(() => location.hash.startsWith('#/repair?'))
  await answered()
  await page.locator('[data-part=steps] [data-part=step]').first().click()
  await panelIsWhole()
  const leak = await leaks()
  await page.reload()
  await answered()
  assert.deepEqual(await leaks(), leak)
  await page.goBack()
  await page.locator('[data-part=plan]').first().waitFor()
  assert.equal(await jobOf(), job)
})

test('a report is made of what was kept', async () => {
  await view('Repair')
  const [report] = await Promise.all([
    page.waitForEvent('download'),
    page.getByRole('button', { name: 'Report on plan 1' }).click(),
  ])
  assert.equal(report.suggestedFilename(), 'plan 1.html')
})
