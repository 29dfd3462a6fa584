// Many valves: a folder that is dropped, and the searches that one button starts.
import assert from 'node:assert/strict'
import { mkdirSync, mkdtempSync, rmSync, writeFileSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { after, test } from 'node:test'
import { accessProblems, openBefore, page, service } from './page.mjs'

const folder = mkdtempSync(join(tmpdir(), 'coapt-cohort-'))
after(() => rmSync(folder, { recursive: true }))

openBefore('cohort', {}, () => page.locator('[data-part=cohort-valve]').first().waitFor())

const state = () => page.locator('[data-part=cohort-state]')
const rowOf = (name) => page.locator('[data-part=cohort-valve]', { hasText: name })

/// As from the desktop: Playwright itself drops no folders.
async function drop(path) {
  const { x, y, width } = await page.locator('main').boundingBox()
  const browser = await page.context().newCDPSession(page)
  const data = { items: [], files: [path], dragOperationsMask: 1 }
  for (const type of ['dragEnter', 'dragOver', 'drop'])
    await browser.send('Input.dispatchDragEvent', { type, x: x + width / 2, y: y + 100, data })
  await browser.detach()
}

test('the valves of a dropped folder stand in the table, what is none is named', async () => {
  const within = join(folder, 'members', 'second half')
  mkdirSync(within, { recursive: true })
  for (const [place, preset, name] of [
    [join(folder, 'members'), 'human-normal', 'member-1'],
    [within, 'human-functional-mr', 'member-2'],
  ]) {
    const valve = await (await fetch(`${service.url}/v1/presets/${preset}`)).json()
    writeFileSync(join(place, `${name}.json`), JSON.stringify({ ...valve, name }))
  }
  writeFileSync(join(within, 'notes.txt'), 'no valve')
  writeFileSync(join(within, 'summary.json'), '{}')
  await drop(join(folder, 'members'))
  await page.locator('[data-part=problems]', { hasText: 'summary.json is not a valve file' }).waitFor()
  assert.equal(await page.locator('[data-part=problems]', { hasText: 'notes' }).count(), 0)
  await page.getByLabel('Filter').fill('member-')
  await page.locator('[data-part=cohort-state]', { hasText: '2 valves, 2 closed; 1 of them leaks.' }).waitFor()
  await rowOf('member-1').getByText('Competent').waitFor()
  await rowOf('member-2').getByText('Type IIIb').waitFor()
  assert.deepEqual(await accessProblems(page), [])
})

test('one button starts the searches that are missing, and their first plans come into the table', async () => {
  const asked = []
  await page.route('**/v1/plans', async (route) => {
    const request = route.request().postDataJSON()
    asked.push(request)
    const small = { evaluations: 40, plans: 1, region_points: 5, fine_levels: 0, model_draws: 0, evidence: false }
    await route.continue({ postData: JSON.stringify({ ...request, search: small }) })
  })
  const search = page.getByRole('button', { name: 'Search for plans' })
  await search.click()
  await rowOf('member-2')
    .getByText(/searching|[Rr]ing|[Ss]uture/)
    .first()
    .waitFor()
  assert.equal(asked.length, 1) // the other one is competent
  assert.deepEqual(asked[0].search, {}) // as searches are by default
  const plan = rowOf('member-2').getByRole('link').nth(1)
  await plan.waitFor()
  assert.ok(await search.isDisabled()) // none is missing any more
  await page.getByLabel('Filter').fill('')
  await page.getByLabel('Filter').fill('member-')
  assert.match(await state().textContent(), /^2 valves/)
  const steps = await plan.textContent()
  await plan.click()
  await page.locator('nav [aria-current]', { hasText: 'Repair' }).waitFor()
  await page.locator('[data-part=open-valve]', { hasText: 'member-2' }).waitFor()
  await page
    .locator('[data-part=steps]')
    .getByText(steps.split(';')[0].slice(0, 12), { exact: false })
    .first()
    .waitFor()
})
