// The address holds what the page shows: reload, link, back and a second tab show the same.
import assert from 'node:assert/strict'
import { test } from 'node:test'
import { openBefore, page, service } from './page.mjs'

openBefore('repair', {}, () => page.locator('[data-part=open-valve]', { hasText: 'human-functional-mr' }).waitFor())

const valve = (of, name) => of.locator('[data-part=open-valve]', { hasText: name }).waitFor()
const view = (of, name) => of.locator('nav [aria-current]', { hasText: name }).waitFor()
const leak = async (of) => {
  await of.locator('[data-part=answer]', { hasText: 'Closed' }).waitFor()
  return of.locator('[data-part=measures] tr', { hasText: 'Leak' }).locator('td').last().textContent()
}

test('a reload and a second tab show the valve and its repair', async () => {
  await page.getByRole('button', { name: 'Ring' }).click()
  const before = await leak(page)
  await page.reload()
  assert.equal(await leak(page), before)
  const second = await page.context().newPage()
  await second.goto(page.url())
  assert.equal(await leak(second), before)
  await second.close()
})

test('back and forward go through valves and views', async () => {
  await page.getByRole('link', { name: 'Valve', exact: true }).click()
  await view(page, 'Valve')
  await page.getByLabel('Preset').selectOption('human-normal')
  await valve(page, 'human-normal')
  await page.goBack()
  await valve(page, 'human-functional-mr')
  await page.goBack()
  await view(page, 'Repair')
  await page.getByText('undersized by 2 sizes').waitFor()
  await page.goForward()
  await page.goForward()
  await valve(page, 'human-normal')
})

test('a plan that is kept in one tab is listed in the other, by its new name, and gone when it is removed', async () => {
  const second = await page.context().newPage()
  await second.goto(`${service.url}/#/repair?valve=human-functional-mr`)
  await valve(second, 'human-functional-mr')
  await page.goto(`${service.url}/#/repair?valve=human-functional-mr`)
  await page.getByRole('button', { name: 'Ring' }).click()
  await leak(page)
  await page.getByRole('button', { name: 'Keep this repair' }).click()
  const name = second.getByRole('textbox', { name: 'Name of plan 1' })
  await name.fill('small ring')
  await name.press('Enter')
  await page.getByRole('textbox', { name: 'Name of small ring' }).waitFor()
  await page.reload()
  await page.getByRole('button', { name: 'Remove small ring' }).click()
  await second.getByText('Keep a repair to compare and score it here').waitFor()
  await second.close()
})

test('an address that names nothing says so', async () => {
  for (const [address, words] of [
    ['nowhere?valve=human-normal', 'There is no view named “nowhere”.'],
    ['repair?valve=nobody', 'There is no valve “nobody” here.'],
    ['repair?valve=human-normal&plan=%21', 'The plan in the address cannot be read.'],
  ]) {
    await page.goto(`${service.url}/#/${address}`)
    await page.getByText(words).waitFor()
  }
  await page.goto(`${service.url}/#/valve?valve=human-normal`)
  await page.getByText('The plan in the address cannot be read.').waitFor({ state: 'hidden' })
})

test('Ctrl+Z takes a step back, Ctrl+Shift+Z forth', async () => {
  await page.goto(`${service.url}/#/repair?valve=human-normal`)
  await valve(page, 'human-normal')
  await page.getByRole('button', { name: 'Ring' }).click()
  await page.getByText('undersized by 2 sizes').waitFor()
  await page.keyboard.press('Control+z')
  await page.getByText('No steps yet').waitFor()
  await page.keyboard.press('Control+Shift+Z')
  await page.getByText('undersized by 2 sizes').waitFor()
})

test('Ctrl+K finds a valve by its plain name and opens it', async () => {
  await page.keyboard.press('Control+k')
  await page.getByRole('combobox', { name: 'Find a command' }).fill('prolapse')
  await page.getByRole('option', { name: /P2 prolapse/ }).waitFor()
  await page.keyboard.press('Enter')
  await valve(page, 'human-p2-prolapse')
})
