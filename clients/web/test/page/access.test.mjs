// What everybody can use: axe-core over each view, in both themes, at both widths; and with the keyboard alone.
import assert from 'node:assert/strict'
import { writeFileSync } from 'node:fs'
import { join } from 'node:path'
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

for (const [theme, width] of [
  ['light', 1280],
  ['dark', 820],
])
  test(`no view has anything against it, ${theme}, ${width} px wide`, async () => {
    const { page, complaints } = await openView(browser, service.url, 'valve', { theme, width, height: 900 })
    await page.locator('[data-part=open-valve]', { hasText: 'human-functional-mr' }).waitFor()
    for (const view of ['Valve', 'Repair', 'Search', 'Studies']) {
      await page.getByRole('link', { name: view, exact: true }).click()
      await page.locator('main h1', { hasText: view }).waitFor({ state: 'attached' })
      if (view === 'Repair') await page.getByRole('button', { name: 'Suture AL' }).click()
      assert.deepEqual(await accessProblems(page), [], view)
      const overflow = await page.evaluate(
        () => document.documentElement.scrollWidth - document.documentElement.clientWidth,
      )
      assert.equal(overflow, 0, `${view}: nothing sticks out to the side`)
    }
    assert.deepEqual(complaints, [])
    await page.context().close()
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

test('a service with a token gives the page to everybody, and a valve to who knows it', async () => {
  const token = 'sixteen-or-more-characters'
  const file = join(service.folder, 'token')
  writeFileSync(file, token, { mode: 0o600 })
  const closed = await startService(['--token-file', file])
  try {
    const { page } = await openView(browser, closed.url, 'studies')
    const input = page.getByLabel('Token', { exact: true }).last()
    await input.fill(token)
    await page.getByRole('button', { name: 'Continue' }).click()
    await page.locator('[data-part=open-valve]', { hasText: 'human-functional-mr' }).waitFor()
    await page.context().close()

    const context = await browser.newContext()
    const invited = await context.newPage()
    await invited.goto(`${closed.url}/#token=${token}`) // as coapt-server prints it
    await invited.locator('[data-part=open-valve]', { hasText: 'human-functional-mr' }).waitFor()
    assert.ok(!invited.url().includes(token))
    await context.close()
  } finally {
    await closed.stop() // it would keep the run of all tests from ending
  }
})
