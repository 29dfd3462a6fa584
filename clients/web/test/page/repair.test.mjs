import assert from 'node:assert/strict'
import { readFileSync, writeFileSync } from 'node:fs'
import { join } from 'node:path'
import { test } from 'node:test'
import { namedPoint, openBefore, page, service, settled } from './page.mjs'

openBefore('repair', {}, () => page.locator('[data-part=labels] [data-part=leak]').first().waitFor())

const leak = () => page.locator('[data-part=measures] tr', { hasText: 'Leak' }).locator('td').allTextContents()
const answered = () => page.locator('[data-part=answer]', { hasText: 'Closed and measured' }).waitFor()
const steps = () => page.locator('[data-part=steps] [data-part=step]').allTextContents()

test('a ring of the own shape makes the leak smaller, as the service says', async () => {
  await page.getByRole('button', { name: 'Ring' }).click()
  await answered()
  const plan = { schema: 'coapt.plan/1', steps: [{ step: 'annuloplasty', shape: 'own', sizes_below: 2 }] }
  const body = JSON.stringify({ valve: 'human-functional-mr', plan })
  const expected = await (await fetch(`${service.url}/v1/scenes`, { method: 'POST', body })).json()
  const [value, error] = (await leak())[1].split(' ± ').map(Number.parseFloat)
  assert.ok(Math.abs(value - expected.closure.leak_mm2) <= 0.5, `${value}`)
  assert.ok(Math.abs(error - expected.closure.leak.error_mm2) <= 0.5, `${error}`)
  assert.ok(Number.parseFloat((await leak())[1]) < Number.parseFloat((await leak())[0]))
})

test('time is traded for certainty of the repaired leak, until the plan is another', async () => {
  const panel = page.locator('[data-part=certainty]')
  await panel.getByRole('button', { name: 'sure' }).click()
  await panel.getByText(/^The leak is [\d.]+ ± [\d.]+ mm² \([\d.]+ and [\d.]+ on 648 and 2,592 triangles/).waitFor()
  const [said] = (await panel.textContent()).match(/leak is [\d.]+/)
  assert.ok(Math.abs(Number.parseFloat(said.slice(8)) - Number.parseFloat((await leak())[1])) < 2, said)
  await page.getByRole('button', { name: 'Undo' }).click()
  await panel.waitFor({ state: 'hidden' })
  await page.getByRole('button', { name: 'Ring' }).click()
  await answered()
  assert.ok(!(await panel.textContent()).includes('The leak is'))
})

test('letting a slider go closes the valve anew', async () => {
  const before = (await leak())[1]
  await page.getByRole('slider', { name: 'Undersized by, sizes', exact: true }).fill('0')
  await page.waitForFunction(
    (old) => document.querySelector('[data-part=measures] tr:nth-child(2) td:last-child')?.textContent !== old,
    before,
  )
  assert.match((await steps())[0], /not undersized/)
})

test('a number can be typed beside the slider, and the title follows it', async () => {
  await page.getByRole('spinbutton', { name: 'Undersized by, sizes as a number' }).fill('3')
  await page.keyboard.press('Enter')
  await page.waitForFunction(() => /by 3 sizes/.test(document.querySelector('[data-part=steps]')?.textContent ?? ''))
  assert.equal(await page.getByRole('slider', { name: 'Undersized by, sizes', exact: true }).inputValue(), '3')
  await page.getByRole('slider', { name: 'Undersized by, sizes', exact: true }).fill('0')
  await page.waitForFunction(() =>
    /not undersized/.test(document.querySelector('[data-part=steps]')?.textContent ?? ''),
  )
  await page.locator('[aria-busy=false]').waitFor()
})

test('a slider that is dragged slowly stays under the pointer; one undo takes the whole drag back', async () => {
  const box = await page.getByRole('slider', { name: 'Undersized by, sizes', exact: true }).boundingBox()
  const at = (share) => [box.x + share * box.width, box.y + box.height / 2]
  await page.mouse.move(...at(0.02))
  await page.mouse.down()
  for (const [share, sizes] of [
    [0.3, 2],
    [0.6, 4],
    [0.98, 6],
  ]) {
    await page.mouse.move(...at(share))
    await page.locator('[data-part=steps]', { hasText: `undersized by ${sizes} sizes` }).waitFor() // while it is held, too
    await page.locator('[aria-busy=false]').waitFor()
  }
  await page.mouse.up()
  await page.waitForFunction(() =>
    /undersized by 6 sizes/.test(document.querySelector('[data-part=steps]')?.textContent ?? ''),
  )
  await page.getByRole('button', { name: 'Undo' }).click()
  await page.waitForFunction(() =>
    /not undersized/.test(document.querySelector('[data-part=steps]')?.textContent ?? ''),
  )
})

test('a suture can be tied to a point that is picked on the annulus', async () => {
  await page.getByRole('button', { name: 'Suture PM' }).click()
  await page.getByRole('combobox', { name: 'Anchor' }).selectOption('annulus_point')
  await page.getByRole('button', { name: 'Pick on the annulus' }).click()
  const peak = await namedPoint(page.locator('figure').first(), 'saddle peak')
  await page.mouse.click(peak.x, peak.y)
  await page.waitForFunction(() =>
    /annulus at (7|8|9|10)\d?°/.test(document.querySelector('[data-part=steps]')?.textContent ?? ''),
  )
  assert.match((await steps())[1], /Posteromedial papillary muscle to the annulus/)
})

test('a neochorda is placed by clicking the leaflet and a papillary head', async () => {
  await page.getByRole('button', { name: 'Neochorda' }).click()
  const first = page.locator('figure').first()
  const { x, y } = await namedPoint(first, 'P2')
  // Turning the valve to see better picks nothing.
  await page.mouse.move(x + 40, y)
  await page.mouse.down()
  await page.mouse.move(x, y, { steps: 4 })
  await page.mouse.up()
  await page.getByRole('button', { name: 'From the atrium' }).click()
  await settled()
  assert.match(await page.locator('[data-part=picking]').textContent(), /Click the insertion of the neochorda/)
  await page.mouse.click(x, y)
  await page.locator('[data-part=picking]', { hasText: 'papillary head' }).waitFor()
  await page.getByRole('button', { name: 'From the ventricle' }).click()
  await settled()
  const head = await namedPoint(first, 'AL3')
  await page.mouse.click(head.x, head.y)
  await page.waitForFunction(() =>
    /Neochorda from \w+ to P2/.test(document.querySelector('[data-part=steps]')?.textContent ?? ''),
  )
  await page.getByRole('button', { name: 'From the atrium' }).click()
})

test('nothing is applied before something is picked, and Escape leaves nothing behind', async () => {
  const before = await steps()
  for (const name of ['Neochorda', 'Chorda']) {
    await page.getByRole('button', { name, exact: true }).click()
    await page.locator('[data-part=picking]').waitFor()
    assert.deepEqual(await steps(), before)
    await page.keyboard.press('Escape')
    await page.locator('[data-part=picking]').waitFor({ state: 'hidden' })
    assert.deepEqual(await steps(), before)
  }
})

test('a chorda can be chosen by its name, cut, shortened and moved', async () => {
  await page.getByRole('button', { name: 'Chorda', exact: true }).click()
  await page.getByLabel('or choose it').selectOption({ index: 3 })
  await page.getByLabel('Action').selectOption('chordal_excision')
  await page.waitForFunction(() =>
    /Chorda \S+ cut/.test(document.querySelector('[data-part=steps]')?.textContent ?? ''),
  )
  await page.getByLabel('Action').selectOption('chordal_transfer')
  await page.waitForFunction(() =>
    /Chorda \S+ transferred to P2/.test(document.querySelector('[data-part=steps]')?.textContent ?? ''),
  )
})

test('undo goes back step by step, redo forth', async () => {
  const count = (await steps()).length
  await page.getByRole('button', { name: 'Undo' }).click()
  await page.getByRole('button', { name: 'Undo' }).click()
  await page.getByRole('button', { name: 'Undo' }).click()
  await page.waitForFunction(
    (most) => document.querySelectorAll('[data-part=steps] [data-part=step]').length < most,
    count,
  )
  await page.getByRole('button', { name: 'Redo' }).click()
  await page.getByRole('button', { name: 'Clear' }).click()
  await page.getByText('No steps yet').waitFor()
})

test('accepted plans are kept, scored, saved and loaded', async () => {
  await page.getByRole('button', { name: 'Ring' }).click()
  await answered()
  await page.getByRole('button', { name: 'Keep this repair' }).click()
  await page.getByText('Kept as “plan 1”.').waitFor()
  await page.getByRole('button', { name: 'Keep this repair' }).click()
  await page.getByText('This repair is already kept').waitFor()
  assert.equal(await page.getByRole('textbox', { name: /^Name of/ }).count(), 1)
  await page.getByRole('button', { name: 'Score plans' }).click()
  await page.getByText(/Best: plan 1\. Leak/).waitFor()
  const [report] = await Promise.all([
    page.waitForEvent('download'),
    page.getByRole('button', { name: 'Report on plan 1' }).click(),
  ])
  assert.equal(report.suggestedFilename(), 'plan 1.html')
  await report.saveAs(join(service.folder, 'report.html'))
  const content = readFileSync(join(service.folder, 'report.html'), 'utf8')
  for (const words of [/How the plans were scored/, /With further remodelling/]) assert.match(content, words)
  const [saved] = await Promise.all([
    page.waitForEvent('download'),
    page.getByRole('button', { name: 'Save plans' }).click(),
  ])
  assert.equal(saved.suggestedFilename(), 'plans.json')
  await saved.saveAs(join(service.folder, 'plans.json'))
  await page.getByLabel('Plans to load').setInputFiles(join(service.folder, 'plans.json'))
  await page.getByText('1 plan loaded from plans.json.').waitFor()
  writeFileSync(join(service.folder, 'no-plan.json'), '{"a": 1}')
  await page.getByLabel('Plans to load').setInputFiles(join(service.folder, 'no-plan.json'))
  await page.getByText('the file contains no plan').waitFor()
})

test('what is repaired is saved as other programs read it', async () => {
  await page.getByLabel('File format').selectOption('csv')
  const [saved] = await Promise.all([
    page.waitForEvent('download'),
    page.getByRole('button', { name: 'Save file' }).click(),
  ])
  assert.equal(saved.suggestedFilename(), 'repaired.csv')
})

test('a plan that is not possible says why, with its place', async () => {
  const plan = {
    schema: 'coapt.plan/1',
    steps: [{ step: 'papillary_approximation', side: 'anterolateral', anchor: 'saddle_peak', suture_length_mm: 99 }],
  }
  writeFileSync(join(service.folder, 'long.json'), JSON.stringify(plan))
  await page.getByLabel('Plans to load').setInputFiles(join(service.folder, 'long.json'))
  await page
    .locator('[data-part=problems] code', { hasText: '/plan/steps/0/suture_length_mm' })
    .waitFor({ state: 'attached' })
  await page.getByText(/Steps 1, suture length:/).waitFor()
})
