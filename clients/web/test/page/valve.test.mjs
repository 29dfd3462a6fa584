import assert from 'node:assert/strict'
import { readFileSync, writeFileSync } from 'node:fs'
import { join } from 'node:path'
import { test } from 'node:test'
import { accessProblems, openBefore, page, resize, service, settled } from './page.mjs'

openBefore('valve')

const measure = (name) => page.locator('[data-part=measures] tr', { hasText: name }).first().locator('td').last()
/// How many colours a part of the view has: one where nothing is drawn.
async function colours() {
  const png = await page.locator('[data-part=viewer] canvas').screenshot()
  return new Set(png.toString('hex').match(/.{6}/g)).size
}

test('the first valve is closed and measured as the service says, and drawn', async () => {
  const expected = await (
    await fetch(`${service.url}/v1/closures`, { method: 'POST', body: '{"valve": "human-functional-mr"}' })
  ).json()
  await page.locator('[data-part=labels] [data-part=leak]').first().waitFor()
  const { area_mm2, error_mm2, openings } = expected.leak
  const [value, error, largest] = [area_mm2, error_mm2, openings[0].area_mm2].map((mm2) => mm2.toFixed(0))
  assert.equal(await measure('Leak').textContent(), `${value} ± ${error}`)
  assert.equal(await page.locator('[data-part=why]').textContent(), expected.diagnosis.summary)
  assert.equal(await page.locator('[data-part=labels] [data-part=leak]').first().textContent(), `${largest} mm²`)
  const row = page.getByRole('group', { name: 'Openings' }).locator('tbody tr').first()
  const cells = [`1. ${openings[0].segments.join(', ')}`, largest, openings[0].width_mm.toFixed(1)]
  assert.deepEqual(await row.locator('th, td').allTextContents(), cells)
  assert.ok((await colours()) > 500)
  for (const name of ['A2', 'P2', 'saddle peak', 'PM trigone'])
    assert.ok(await page.locator('[data-part=labels] span', { hasText: name }).first().isVisible(), name)
})

test('every preset can be read whole in the list', async () => {
  const ARROW_PX = 20
  const [needed, given] = await page.getByLabel('Preset').evaluate((list) => {
    const { font, paddingLeft, paddingRight } = getComputedStyle(list)
    const paper = document.createElement('canvas').getContext('2d')
    paper.font = font
    const widths = [...list.options].map((option) => paper.measureText(option.text).width)
    return [Math.max(...widths), list.clientWidth - parseFloat(paddingLeft) - parseFloat(paddingRight)]
  })
  assert.ok(needed + ARROW_PX <= given, `${needed} px of words in ${given} px`)
})

test('the cut tells the coaptation height where it is', async () => {
  const scene = await (
    await fetch(`${service.url}/v1/scenes`, { method: 'POST', body: '{"valve": "human-functional-mr"}' })
  ).json()
  for (const index of [4, 18]) {
    await page.getByLabel('Position of the cut').fill(String(index))
    const { contact, height_mm, distance_mm } = scene.sections[index]
    const words = contact
      ? `coaptation height ${height_mm.toFixed(1)} mm`
      : `leaflets ${distance_mm.toFixed(1)} mm apart`
    assert.ok((await page.locator('[data-part=looks] output').first().textContent()).includes(words), words)
    assert.ok(await page.locator('[data-part=section]').isVisible())
  }
})

test('the valve closes before the eyes: on the way nothing of its leak is drawn, closed it is', async () => {
  await page.getByLabel('Cut', { exact: true }).uncheck()
  await page.getByLabel('Open to closed').fill('0')
  assert.equal(await page.locator('[data-part=labels] [data-part=leak]').count(), 0)
  await page.getByRole('button', { name: 'Play the closing' }).click()
  await page.locator('[data-part=labels] [data-part=leak]').first().waitFor()
})

test('a whole beat is played: open with its area, closed with its leak, open again; the keyboard reaches all of it', async () => {
  const expected = await (
    await fetch(`${service.url}/v1/openings`, { method: 'POST', body: '{"valve": "human-functional-mr"}' })
  ).json()
  const area = `${(0.01 * expected.opening_area_mm2).toFixed(1)} cm²`
  await page.locator('[data-part=diastole]').waitFor()
  const words = await page.locator('[data-part=diastole]').textContent()
  assert.ok(words.includes(area), words)
  assert.ok(words.includes(`mean gradient ${expected.gradient_mmhg.toFixed(1)} mmHg at 151 ml/s`), words)
  assert.ok(await page.locator('[data-part=headline]').isVisible())
  const slider = page.getByLabel('Open to closed')
  const label = page.locator('[data-part=labels] [data-part=leak]')
  const open = page.getByRole('button', { name: 'Open', exact: true })
  await open.focus()
  await page.keyboard.press('Enter')
  assert.equal(await slider.inputValue(), '-1')
  assert.equal(await open.getAttribute('aria-pressed'), 'true')
  await label.first().waitFor()
  assert.deepEqual(
    await label.allTextContents(),
    expected.leak.openings
      .filter(({ area_mm2 }) => area_mm2 >= 5)
      .map(({ area_mm2 }) => `${(0.01 * area_mm2).toFixed(1)} cm²`),
  )
  await slider.focus()
  await page.keyboard.press('End')
  assert.equal(await slider.inputValue(), '1')
  await page.getByRole('button', { name: 'Play a beat' }).focus()
  await page.keyboard.press('Enter')
  await label.filter({ hasText: 'mm²' }).first().waitFor({ state: 'attached' })
  await label.filter({ hasText: 'cm²' }).first().waitFor({ state: 'attached' })
  await page.getByRole('button', { name: 'Play a beat' }).waitFor()
  assert.equal(await slider.inputValue(), '-1')
  await page.getByRole('button', { name: 'Closed', exact: true }).click()
  assert.equal(await slider.inputValue(), '1')
})

test('what the valve does stands beside what was measured in hearts, until another valve is open', async () => {
  const { rows } = await (
    await fetch(`${service.url}/v1/physiology`, { method: 'POST', body: '{"valve": "human-functional-mr"}' })
  ).json()
  const panel = page.locator('[data-part=hearts]')
  await panel.getByRole('button', { name: 'Compare with measurements' }).click()
  await panel.getByRole('progressbar').waitFor()
  const met = rows.filter(({ verdict }) => verdict === 'met').length
  const ranges = rows.filter(({ low }) => low !== null).length
  await panel.getByText(`${met} of ${ranges} quantities are within their ranges.`).waitFor()
  assert.ok(await panel.getByText('The ranges are those of human valves with functional regurgitation').isVisible())
  assert.equal(await panel.getByRole('progressbar').count(), 0)
  const table = panel.getByRole('group', { name: 'This valve compared with measured hearts' })
  assert.equal(await table.locator('tbody tr').count(), rows.length)
  const leak = rows.find(({ quantity }) => quantity === 'leak')
  const row = table.locator('tr', { hasText: leak.what })
  assert.deepEqual(await row.locator('td').allTextContents(), [
    `${leak.value.toFixed(1)} mm²${leak.low} to ${leak.high}`,
    '✓ met',
  ])
  await row.getByRole('button', { name: leak.what }).click()
  await page.locator('[data-part=help]', { hasText: 'Zoghbi 2017' }).waitFor()
  await page.keyboard.press('Escape')
  const without = rows.find(({ quantity }) => quantity === 'leak_60')
  assert.deepEqual(await table.locator('tr', { hasText: without.what }).locator('td').allTextContents(), [
    `${without.value.toFixed(1)} mm²`,
    '– no range',
  ])
  assert.deepEqual(await accessProblems(page), [])
  await page.getByLabel('Preset').selectOption('human-normal')
  await page.locator('[data-part=open-valve]', { hasText: 'human-normal' }).waitFor()
  assert.equal(await table.count(), 0)
  await page.getByLabel('Preset').selectOption('human-functional-mr')
  await page.locator('[data-part=open-valve]', { hasText: 'human-functional-mr' }).waitFor()
})

test('what images show narrows the range of the leak, and stays with the valve', async () => {
  const range = async () => {
    const headline = page.locator('[data-part=headline]', { hasText: /\(\d+ to \d+\)/ })
    await headline.waitFor()
    const [, low, high] = (await headline.textContent()).match(/\((\d+) to (\d+)\)/)
    return high - low
  }
  const before = await range()
  const panel = page.locator('[data-part=observed]')
  await panel.locator('summary').click()
  await panel.getByLabel('Widest gap', { exact: true }).fill('5')
  await panel.getByRole('button', { name: 'Use these figures' }).click()
  await panel.getByText('Observed, widest gap, sd:').waitFor()
  await panel.getByLabel('Standard deviation of the widest gap').fill('0.3')
  const first = await page.evaluate(() => globalThis.coapt.state().valve.reference)
  await panel.getByRole('button', { name: 'Use these figures' }).click()
  await page.waitForFunction((valve) => globalThis.coapt.state().valve.reference !== valve, first)
  assert.ok((await range()) < 0.8 * before)
  assert.equal(await panel.getByLabel('Widest gap', { exact: true }).inputValue(), '5')
  assert.deepEqual(await accessProblems(page), [])
  await page.getByLabel('Preset').selectOption('human-functional-mr')
  await page.waitForFunction(() => globalThis.coapt.state().valve.reference === 'human-functional-mr')
  await page.waitForFunction(() =>
    [...document.querySelectorAll('[data-part=observed] input')].every(({ value }) => value === ''),
  )
})

test('all measurements that would narrow the leak are told, and lead to where they are entered', async () => {
  const { rows } = await (
    await fetch(`${service.url}/v1/information`, {
      method: 'POST',
      body: '{"valve": "human-functional-mr", "draws": 24}',
    })
  ).json()
  const link = page.locator('[data-part=narrowing]')
  assert.ok((await link.textContent()).endsWith(rows[0].measurement.replace('mm2', 'mm²')))
  const told = page.locator('[data-part=information]')
  for (const [name, part] of [
    ['Enter what images show', 'observed'],
    ['Fit to closed leaflets', 'import'],
  ]) {
    await link.click()
    assert.deepEqual(
      await told.locator('tbody th').allTextContents(),
      rows.map(({ measurement }) => measurement.replace('mm2', 'mm²')),
    )
    assert.deepEqual(await accessProblems(page), [])
    await told.getByRole('button', { name }).click()
    await told.waitFor({ state: 'hidden' })
    assert.equal(await page.evaluate((of) => document.activeElement.closest('details').dataset.part === of, part), true)
    await page.locator(`details[data-part=${part}] > summary`).click()
  }
})

test('time is traded for certainty of the leak, as the service says', async () => {
  const panel = page.locator('[data-part=certainty]')
  const { leak, triangles } = await (
    await fetch(`${service.url}/v1/closures`, { method: 'POST', body: '{"valve": "human-functional-mr"}' })
  ).json()
  const shown = `${leak.area_mm2.toFixed(0)} ± ${leak.error_mm2.toFixed(0)} mm²`
  assert.match(await panel.textContent(), new RegExp(`quickabout 0\\.\\d+ s, ± ${leak.error_mm2.toFixed(0)} mm²`))
  await panel.getByRole('button', { name: 'quick' }).click()
  await panel.getByText(`The leak is ${shown} (on ${triangles} triangles, in`).waitFor()
  await panel.getByRole('button', { name: 'sure' }).click()
  await panel.getByText(/^The leak is [\d.]+ ± [\d.]+ mm² \([\d.]+ and [\d.]+ on 648 and 2,592 triangles/).waitFor()
  await panel.getByRole('button', { name: 'proof' }).click()
  await panel.getByText(/^The leak is [\d.]+ ± [\d.]+ mm² \([\d., and]+ on 648(,| and) .* triangles/).waitFor()
})

test('the shape is closed with soft and stiff leaflets, as the service says', async () => {
  const panel = page.locator('[data-part=how-sure]')
  await panel.getByRole('button', { name: 'How sure is the shape?' }).click()
  await panel.getByText(/stiffness of the leaflets alone changes the leak from \d+ to \d+ mm²/).waitFor()
  const valve = await (await fetch(`${service.url}/v1/presets/human-functional-mr`)).json()
  const factor = 3 ** 0.9 // of 95 in 100 draws
  valve.tissue.radial_post_kpa *= factor
  valve.tissue.circumferential_post_kpa *= factor
  const body = JSON.stringify({ valve })
  const { leak } = await (await fetch(`${service.url}/v1/closures`, { method: 'POST', body })).json()
  await panel.getByRole('button', { name: 'Stiff', exact: true }).click()
  await panel.getByText(`Leaflets 2.7 times as stiff: leak ${leak.area_mm2.toFixed(0)} mm²`).waitFor()
  await panel.getByRole('button', { name: 'Own' }).click()
  await panel.getByText('Leaflets as stiff as in the file').waitFor()
  assert.equal(await panel.getByRole('button', { name: 'Breathe' }).count(), 0, 'who wants no motion gets none')
  await page.reload() // the other tests look at one viewer
  await page.locator('[data-part=labels] [data-part=leak]').waitFor()
})

test('every colouring has a legend', async () => {
  for (const mode of ['strain_circumferential', 'strain_radial', 'height', 'tension']) {
    await page.getByRole('combobox', { name: 'Colours' }).selectOption(mode)
    assert.ok(await page.locator('[data-part=scale] canvas').isVisible(), mode)
  }
  await page.getByRole('combobox', { name: 'Colours' }).selectOption('leaflets')
})

test('the value under the pointer is told with its unit', async () => {
  await page.getByRole('button', { name: 'From the atrium' }).click()
  const a2 = page.locator('[data-part=labels] span', { hasText: /^A2$/ })
  for (const [mode, words] of [
    ['leaflets', /^A2: \d+\.\d mm (below|above) the annular plane$/],
    ['strain_radial', /^A2: -?\d+ %$/],
    ['height', /^A2: -?\d+\.\d mm$/],
  ]) {
    await page.getByRole('combobox', { name: 'Colours' }).selectOption(mode)
    await settled()
    const { x, y, width, height } = await a2.boundingBox()
    await page.mouse.move(x, y)
    await page.mouse.move(x + width / 2, y + height / 2)
    await page.locator('[data-part=readout]', { hasText: words }).waitFor()
  }
  await page.mouse.move(2, 2)
  await page.locator('[data-part=readout]').waitFor({ state: 'hidden' })
})

test('a range of colours that is typed holds for other valves, until it is let go', async () => {
  const ends = () => page.locator('[data-part=scale] span').allTextContents()
  await page.getByRole('combobox', { name: 'Colours' }).selectOption('strain_radial')
  const own = await ends()
  await page.getByLabel('Colours to').fill('60')
  await page.keyboard.press('Enter')
  assert.deepEqual((await ends()).slice(0, 2), ['0', '60 %'])
  await page.getByLabel('Preset').selectOption('human-normal')
  await page.locator('[data-part=open-valve]', { hasText: 'human-normal' }).waitFor()
  assert.deepEqual((await ends()).slice(0, 2), ['0', '60 %'])
  await page.getByLabel('Preset').selectOption('human-functional-mr')
  await page.locator('[data-part=open-valve]', { hasText: 'human-functional-mr' }).waitFor()
  await page.locator('[data-part=labels] [data-part=leak]').first().waitFor()
  await page.getByLabel('Same scale for all valves').uncheck()
  assert.deepEqual(await ends(), own)
  await page.getByRole('combobox', { name: 'Colours' }).selectOption('leaflets')
})

test('a distance is measured between two points', async () => {
  await page.getByRole('button', { name: 'From the atrium' }).click()
  await page.getByRole('button', { name: 'Measure a distance' }).click()
  await settled()
  const box = await page.locator('[data-part=viewer] canvas').boundingBox()
  const labels = page.locator('[data-part=labels] span')
  for (const name of ['A2', 'P2']) {
    const at = await labels.filter({ hasText: new RegExp(`^${name}$`) }).boundingBox()
    await page.mouse.click(at.x + at.width / 2, at.y + at.height / 2)
    await settled() // labels are made anew with each point
  }
  const text = await page.locator('[data-part=labels] [data-part=distance]').textContent()
  const mm = Number.parseFloat(text)
  assert.ok(mm > 3 && mm < 40, text)
  assert.ok(box.width > 300)
  await page.getByRole('button', { name: 'Measure a distance' }).click()
})

test('a preset and a file can be opened', async () => {
  await page.getByLabel('Preset').selectOption('human-p2-prolapse')
  await page.locator('[data-part=open-valve]', { hasText: 'human-p2-prolapse' }).waitFor()
  const valve = await (await fetch(`${service.url}/v1/presets/porcine-1`)).text()
  const file = join(service.folder, 'mine.json')
  writeFileSync(file, valve)
  await page.getByLabel('Your file').setInputFiles(file)
  await page.locator('[data-part=open-valve]', { hasText: 'mine.json' }).waitFor()
  assert.match(await measure('Annulus, anteroposterior, mm').textContent(), /^\d+\.\d$/)
})

test('all problems of a file are shown with where they are, and the valve stays', async () => {
  const valve = JSON.parse(readFileSync(join(service.folder, 'mine.json'), 'utf8'))
  valve.pressure_kpa = -3
  valve.chordae[0].segments[0].rest_length_mm = 'long'
  const file = join(service.folder, 'wrong.json')
  writeFileSync(file, JSON.stringify(valve))
  await page.getByLabel('Your file').setInputFiles(file)
  const problems = page.locator('[data-part=problems] li')
  await problems.nth(1).waitFor()
  const [chorda, pressure] = await problems.allTextContents()
  assert.match(chorda, /^Chordae 1, segments 1, rest length: .*"long".*\/chordae\/0\/segments\/0\/rest_length_mm/)
  assert.match(pressure, /^Pressure: is -3, must be.*\/pressure_kpa/)
  assert.deepEqual(await problems.locator('pre').allTextContents(), ['"long"', '-3'])
  assert.equal(await page.locator('[data-part=open-valve]').textContent(), 'mine.json')
  writeFileSync(file, 'no JSON at all <script>alert(1)</script>')
  await page.getByLabel('Your file').setInputFiles(file)
  await page.getByText('This is not a JSON document.').waitFor()
})

test('arrow keys turn the valve', async () => {
  const place = () => page.locator('[data-part=labels] span', { hasText: 'saddle peak' }).boundingBox()
  const first = await place()
  await page.locator('[data-part=viewer] canvas').focus()
  for (let i = 0; i < 5; ++i) await page.keyboard.press('ArrowDown')
  await settled()
  assert.notDeepEqual(await place(), first)
})

test('the whole annulus is in the picture at first, after the window has got another shape, and after it was turned', async () => {
  await page.getByRole('button', { name: 'From the atrium' }).click()
  for (const [width, height] of [
    [1440, 900],
    [820, 1180],
    [1180, 820],
    [390, 844],
  ]) {
    await resize(width, height)
    const canvas = await page.locator('[data-part=viewer] canvas').boundingBox()
    // At once: words may be placed anew at any time.
    const boxes = await page
      .locator('[data-part=labels] [data-part=landmark]')
      .evaluateAll((all) =>
        all
          .filter((word) => word.checkVisibility({ visibilityProperty: true }))
          .map((word) => word.getBoundingClientRect().toJSON()),
      )
    const middles = boxes.map((box) => [box.x + box.width / 2 - canvas.x, box.y + box.height / 2 - canvas.y])
    for (const [x, y] of middles)
      assert.ok(x > 0 && x < canvas.width && y > 0 && y < canvas.height, `${width}: ${x} ${y}`)
    const across = Math.max(...middles.map(([x]) => x)) - Math.min(...middles.map(([x]) => x))
    const along = Math.max(...middles.map(([, y]) => y)) - Math.min(...middles.map(([, y]) => y))
    assert.ok(across > 0.6 * canvas.width || along > 0.6 * canvas.height, `${width}: ${across} of ${canvas.width}`)
  }
  await resize(1280, 800)
})

test('it says on every view that it is for research only, and what is not modelled', async () => {
  for (const view of ['Valve', 'Repair', 'Search', 'Studies']) {
    await page.getByRole('link', { name: view, exact: true }).click()
    await page.locator('nav [aria-current]', { hasText: view }).waitFor()
    assert.ok(await page.getByText('Research use only, not a medical device').isVisible())
  }
  await page.getByText('Model limitations').click()
  assert.ok((await page.locator('footer li').count()) >= 4)
  assert.ok(await page.getByText('Blood flow').isVisible())
})
