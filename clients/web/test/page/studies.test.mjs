import assert from 'node:assert/strict'
import { readFileSync } from 'node:fs'
import { test } from 'node:test'
import { accessProblems, openBefore, page } from './page.mjs'

openBefore('studies', {}, () => page.locator('[data-part=form] h2', { hasText: 'human-functional-mr' }).waitFor())

const start = () => page.getByRole('button', { name: 'Start the study' }).click()

test('what the service says against an option stands at it', async () => {
  await page.locator('[data-part=form] select').first().selectOption('approximation')
  await page.getByLabel('Region points').fill('3')
  await start()
  await page.locator('[data-part=problems] code', { hasText: '/study/region_points' }).waitFor({ state: 'attached' })
})

test('a study draws its figure, beside the thesis, with a table of the same values', async () => {
  await page.locator('[data-part=form] select').first().selectOption('annulus')
  await start()
  const figure = page.locator('figure', { hasText: 'Orifice of a dilated and flattened annulus' })
  await figure.locator('canvas').waitFor()
  await figure.getByRole('button', { name: 'thesis, height 100 %' }).waitFor()
  const [download] = await Promise.all([
    page.waitForEvent('download'),
    page.getByRole('button', { name: 'annulus.csv' }).first().click(),
  ])
  const first = readFileSync(await download.path(), 'utf8')
    .split('\n')[1]
    .split(',')
    .map(Number)
  await figure.getByText('Show as table').click()
  const shown = await figure.locator('tbody tr').first().locator('td').first().textContent()
  assert.ok(Math.abs(Number(shown) - first[2]) < 0.06)
})

test('each finding says whether it agrees', async () => {
  const verdicts = await page.locator('[data-part=verdict]').allTextContents()
  assert.equal(verdicts.length, 5)
  for (const verdict of verdicts) assert.match(verdict, /agrees|differs/)
})

test('it has nothing against it, in both themes, also on a tablet', async () => {
  for (const [theme, width] of [
    ['dark', 820],
    ['light', 1280],
  ]) {
    await page.emulateMedia({ colorScheme: theme })
    await page.setViewportSize({ width, height: 900 })
    assert.deepEqual(await accessProblems(page), [])
  }
})
