// The stories of examples/stories, each played to its end: the page's main flow from a valve to how exact its repair must be. Then one is
// written, and told from its link.
import assert from 'node:assert/strict'
import { test } from 'node:test'
import { browser, openBefore, openView, page, service } from './page.mjs'
import { STORIES, tell } from './telling.mjs'

openBefore('valve', { width: 1440, height: 900 }, () =>
  page.locator('[data-part=open-valve]', { hasText: 'human-functional-mr' }).waitFor(),
)

test('the first visit offers a story, and does so once', async () => {
  const offer = page.locator('[data-part=first-visit]')
  await offer.getByRole('link', { name: 'A flail P2', exact: true }).waitFor()
  await offer.getByRole('button', { name: 'Not now' }).click()
  await offer.waitFor({ state: 'hidden' })
  await page.reload()
  await page.locator('[data-part=headline]', { hasText: 'mm²' }).first().waitFor()
  assert.equal(await offer.count(), 0)
})

for (const name of STORIES) test(`${name} is told to its end`, () => tell(page, name))

test('a slide is a link, and a reload tells it again', async () => {
  await page.getByRole('link', { name: 'Valve', exact: true }).click()
  await page.getByRole('link', { name: 'A flail P2', exact: true }).click()
  await page.locator('[data-part=story][data-told="1"]').waitFor()
  await page.getByRole('button', { name: 'Next' }).click()
  await page.locator('[data-part=story][data-told="2"]').waitFor()
  await page.reload()
  await page.locator('[data-part=story][data-told="2"]').waitFor()
  await page.evaluate(() => (location.hash = '#/valve?valve=barlow&story=flail-p2&slide=2'))
  await page.locator('[data-part=open-valve]', { hasText: 'barlow' }).waitFor()
  await page.getByRole('button', { name: 'Show the slide again' }).click()
  await page.locator('[data-part=open-valve]', { hasText: 'fibroelastic-flail' }).waitFor()
  await page.evaluate(() => history.go(-3))
  await page.locator('[data-part=story][data-told="1"]').waitFor()
})

test('a story is written on the page and told from its link', async () => {
  await page.getByRole('button', { name: 'Edit' }).click()
  const editor = page.getByRole('group', { name: 'Write the story' })
  await page.getByRole('link', { name: 'Repair', exact: true }).click()
  await page.getByRole('button', { name: 'Ring', exact: true }).click()
  await page.locator('[data-part=answer]', { hasText: 'Closed and measured' }).waitFor()
  await page.getByRole('button', { name: 'From lateral' }).click()
  await page.locator('[data-part=viewer] canvas').first().press('ArrowLeft')
  await editor.getByRole('button', { name: 'Add a slide' }).click()
  await page.locator('[data-part=story-count]', { hasText: '2 of' }).waitFor()
  assert.equal(await editor.getByLabel('Seen from').inputValue(), 'recorded')
  const words = editor.getByRole('textbox', { name: 'Words of the slide' })
  await words.fill('A ring brings the leak to 12 mm².')
  await words.blur()
  await editor.locator('[data-part=problems]', { hasText: 'typed number 12' }).waitFor()
  await words.fill('A ring brings the leak from {leak_before} to {leak}.')
  await words.blur()
  await page
    .locator('[data-part=story-text]', { hasText: /A ring brings the leak from \d+ ± \d+ mm² to \d+/ })
    .waitFor()
  await page.waitForFunction(() => /story=~/.test(decodeURIComponent(location.hash)))
  const link = page.url()
  const pupil = await openView(browser, service.url, link.slice(link.indexOf('#') + 1))
  await pupil.page
    .locator('[data-part=story-text]', { hasText: /A ring brings the leak from \d+ ± \d+ mm² to \d+/ })
    .waitFor()
  const root = pupil.page.locator('[data-part=neighbour]').first() // seen from above alone
  await root.waitFor({ state: 'hidden' })
  assert.deepEqual(pupil.complaints, [])
  await pupil.page.context().close()
  await page.getByRole('button', { name: 'End the story' }).click()
})
