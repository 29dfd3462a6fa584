// That axe-core finds what is wrong, and the way of the keyboard through the views. All states: states.test.mjs.
import assert from 'node:assert/strict'
import { after, before, test } from 'node:test'
import { accessProblems, openView, startBrowser, startService } from './page.mjs'

let service, browser
before(async () => {
  service = await startService()
  browser = await startBrowser()
})
after(async () => {
  await browser.close()
  await service.stop()
})

test('what is wrong is found', async () => {
  const { page } = await openView(browser, service.url, 'studies')
  await page.evaluate(() => document.querySelector('main').append(document.createElement('button')))
  assert.match((await accessProblems(page)).join(), /button-name/)
  await page.context().close()
})

test('views and steps can be reached with the keyboard alone', async () => {
  const { page } = await openView(browser, service.url, 'studies')
  await page.locator('[data-part=open-valve]', { hasText: 'human-functional-mr' }).waitFor()
  await page.keyboard.press('Tab')
  assert.equal(await page.evaluate(() => document.activeElement?.textContent), 'Skip to content')
  for (let i = 0; i < 3; ++i) await page.keyboard.press('Tab')
  await page.keyboard.press('Tab')
  assert.equal(
    await page.evaluate(() => document.activeElement?.getAttribute('href')),
    '#/search?valve=human-functional-mr',
  )
  await page.keyboard.press('Enter')
  await page.locator('nav [aria-current]', { hasText: 'Search' }).waitFor()
  await page.context().close()
})
