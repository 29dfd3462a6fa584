// The page in each of its states, also in those between two views: in four sizes of the window and with larger letters nothing is
// cut, covered or out of its box, axe-core finds nothing, the browser complains of nothing. A picture of each is left in
// build/pages, to be looked at; with COAPT_PICTURES=all one of each size in both themes.
import assert from 'node:assert/strict'
import { readFileSync, writeFileSync } from 'node:fs'
import { join } from 'node:path'
import { after, before, test } from 'node:test'
import { drawNothing, looks } from './looks.mjs'
import { openView, ROOT, settled, startBrowser, startService } from './page.mjs'

const LONG_NAME = `Patient 0042 before surgery, segmented twice and averaged over both, second attempt, ${'x'.repeat(60)}`
const { leaflets, annulus, chordae } = JSON.parse(readFileSync(join(ROOT, 'server/openapi.json'))).components.examples
  .one_skirt.value

let service, browser, page, complaints
before(async () => {
  service = await startService()
  browser = await startBrowser()
  ;({ page, complaints } = await open('valve'))
  await named('human-functional-mr')
})
after(async () => {
  await browser.close()
  await service.stop()
})

async function open(view, { url = service.url, prepare = async () => {}, motion = 'reduce' } = {}) {
  const opened = await openView(browser, url, 'studies', { width: 1440, height: 900, motion })
  await opened.page.addInitScript(drawNothing)
  await prepare(opened.page)
  await opened.page.goto(`${url}/#/${view}`)
  await opened.page.reload()
  return opened
}

const looksWell = (name, { of = page, said = complaints, ...how } = {}) => looks(name, of, said, how)
const named = (name, of = page) => of.locator('[data-part=open-valve]', { hasText: name }).waitFor()
const press = (name, of = page) => of.getByRole('button', { name, exact: true }).click()
const answered = () => page.locator('[data-part=answer]', { hasText: 'Closed and measured' }).waitFor()
async function view(name, of = page) {
  await of.getByRole('link', { name, exact: true }).click()
  await of.locator('nav [aria-current]', { hasText: name }).waitFor()
}

const filesOf = (files) => files.map(({ name, text }) => ({ name, mimeType: 'text/plain', buffer: Buffer.from(text) }))
const importStage = () => page.locator('[data-part=import-stage]')

test('the first look, and what scripts are told of it', async () => {
  await looksWell('valve')
  const { view: shown, valve, leak_mm2, plan, isAway } = await page.evaluate(() => globalThis.coapt.state())
  assert.deepEqual([shown, valve.reference, plan.steps, isAway], ['valve', 'human-functional-mr', [], false])
  assert.match(
    await page.locator('[data-part=headline]').first().textContent(),
    new RegExp(`^${Math.round(leak_mm2.before)} (± |mm² )`),
  )
})

test('the closed valve with soft and stiff leaflets', async () => {
  const { page: other, complaints: said } = await open('valve')
  await named('human-functional-mr', other)
  await press('How sure is the shape?', other)
  await other.getByText(/stiffness of the leaflets alone/).waitFor()
  await looksWell('how-sure', { of: other, said, theme: 'dark' })
  await other.context().close()
})

test('a cut turns the valve so that it is seen; the clock stands around the valve from above', async () => {
  await page.getByLabel('Cut', { exact: true }).check()
  await page.locator('[data-part=section]').waitFor()
  await page.locator('[data-part=tip]:visible').first().waitFor() // from above the leaflets hide them
  await looksWell('cut', { theme: 'dark' })
  await page.getByLabel('Cut', { exact: true }).uncheck()
  await press('From the atrium')
  await page.getByLabel('Clock').check()
  await page.locator('[data-part=hour]:visible', { hasText: '12' }).waitFor()
  await looksWell('clock')
  await page.getByLabel('Clock').uncheck()
})

test('at dusk the stage turns dark with the page, without a touch', async () => {
  const ground = async () => {
    await settled(page)
    const png = (await page.screenshot({ clip: { x: 60, y: 560, width: 1, height: 1 } })).toString('base64')
    return page.evaluate(async (letters) => {
      const bytes = Uint8Array.from(atob(letters), (letter) => letter.charCodeAt(0))
      const pen = new OffscreenCanvas(1, 1).getContext('2d')
      pen.drawImage(await createImageBitmap(new Blob([bytes])), 0, 0)
      return pen.getImageData(0, 0, 1, 1).data[0]
    }, png)
  }
  await page.evaluate(() => (globalThis.drawsNothing = false))
  await press('From the atrium')
  assert.ok((await ground()) > 200)
  await page.emulateMedia({ colorScheme: 'dark' })
  assert.ok((await ground()) < 60)
  await page.evaluate(() => (globalThis.drawsNothing = true))
  await looksWell('valve-dark', { theme: 'dark' })
})

test('files to import, and what another valve leaves of them', async () => {
  await page.getByText('Import meshes').click()
  const drop = async () => {
    await page.getByLabel('Files', { exact: true }).setInputFiles(filesOf([...leaflets, annulus, chordae]))
    await page.locator('[data-part=import]').getByText('10 chordae').waitFor()
    await importStage().waitFor()
  }
  await drop()
  await looksWell('import')
  await page.getByLabel('Preset').selectOption('human-normal')
  await named('human-normal')
  await importStage().waitFor({ state: 'hidden' })
  await looksWell('import-then-preset')
  await drop()
  await page.evaluate(() => (location.hash = '#/valve?valve=human-p2-prolapse'))
  await named('human-p2-prolapse')
  await importStage().waitFor({ state: 'hidden' })
  await page.locator('[data-part=viewer] canvas').first().waitFor()
  await drop()
  await page.getByLabel('Triangles').fill('100')
  await press('Import')
  await page.locator('[data-part=import-result] img').first().waitFor()
  await looksWell('imported')
  await page.evaluate(() => (location.hash = '#/valve?valve=human-functional-mr'))
  await named('human-functional-mr')
  await importStage().waitFor({ state: 'hidden' })
})

test('a repair without a step, with all kinds of them, and while something is picked', async () => {
  await view('Repair')
  await looksWell('repair')
  await press('Ring')
  await answered()
  await press('Neochorda')
  await looksWell('picking-place')
  await page.getByLabel('or choose the place').selectOption('P2')
  await page.locator('[data-part=labels] [data-part=distance]').first().waitFor() // what was chosen is marked
  await looksWell('picking-head', { theme: 'dark' })
  await page.locator('[data-part=labels] [data-part=tip]:visible', { hasText: 'PM1' }).first().waitFor()
  const { x, y, width, height } = await page // at once: words may be placed anew
    .locator('[data-part=labels] [data-part=tip]')
    .evaluateAll((all) =>
      all
        .find((word) => word.textContent === 'PM1')
        .getBoundingClientRect()
        .toJSON(),
    )
  await page.mouse.click(x + width / 2, y + height / 2) // its name is as good as the point
  await page.locator('[data-part=steps]', { hasText: 'Neochorda from PM1 to P2' }).waitFor()
  for (const step of ['Suture AL', 'Resection', 'Edge-to-edge']) await press(step)
  await page.locator('[aria-busy=false]').waitFor()
  await looksWell('repair-steps')
  await press('Clear')
})

test('what a handle may miss by: a surface around it, its margin, a curve', async () => {
  await press('Ring')
  await answered()
  await page.getByRole('slider', { name: 'Ring size' }).focus()
  await page.locator('[data-part=tolerance-progress]', { hasText: /closures\./ }).waitFor()
  const { tolerance } = await page.evaluate(() => globalThis.coapt.state())
  assert.match(tolerance.leak_off, /mm²$/)
  await looksWell('tolerance')
  await page.keyboard.press('Escape')
  await page.getByText('Grab a handle on the repaired valve').waitFor()
  await press('Clear')
})

test('a story, and while it is written', async () => {
  await page.evaluate(() => (location.hash = '#/valve?valve=fibroelastic-flail&story=flail-p2&slide=2'))
  await page.locator('[data-part=story][data-told="2"]').waitFor()
  await looksWell('story')
  await press('Edit')
  await page.getByRole('group', { name: 'Write the story' }).waitFor()
  await looksWell('story-editor', { theme: 'dark' })
  await page.getByRole('button', { name: 'End the story' }).click()
  await page.evaluate(() => (location.hash = '#/repair?valve=human-functional-mr'))
  await named('human-functional-mr')
})

test('long names, of a plan that is kept and scored and of a valve', async () => {
  await press('Ring')
  await answered()
  await press('Keep this repair')
  const name = page.getByRole('textbox', { name: /^Name of/ })
  await name.fill(LONG_NAME)
  await name.press('Enter')
  await press('Score plans')
  await page.getByText(/^Best: .* Leak/).waitFor()
  await looksWell('long-names')
  const valve = await (await fetch(`${service.url}/v1/presets/human-functional-mr`)).text() // it leaks: the next test searches
  writeFileSync(join(service.folder, `${LONG_NAME}.json`), valve)
  await view('Valve')
  await page.getByLabel('Your file').setInputFiles(join(service.folder, `${LONG_NAME}.json`))
  await named(LONG_NAME)
  await page.getByText('Opened before').click()
  assert.match(await page.getByLabel('Preset').evaluate((list) => list.selectedOptions[0].text), /own valve/)
  await looksWell('long-name-of-a-valve')
})

test('a search: asked for, refused, running, failed, done, compared', async () => {
  await page.evaluate(() => (globalThis.drawsNothing = false)) // also while pictures of plans are taken
  await view('Search')
  await page.locator('[data-part=photo][data-taken]').waitFor()
  const start = page.getByRole('button', { name: 'Start the search' })
  const { y, height } = await start.boundingBox()
  assert.ok(y + height < 900, 'it starts without a scroll')
  await looksWell('search')
  await page.getByLabel('Plans to show').fill('0')
  await start.click()
  await page.locator('[data-part=problems]').waitFor()
  await looksWell('search-refused')
  await press('Defaults')
  await page.locator('[data-part=form] details', { hasText: 'Optimiser' }).evaluate((fold) => (fold.open = true))
  const fields = {
    Closures: '3000',
    'Region points': '5',
    'Plans to show': '2',
    'Tissue variants': '0',
    'Mesh refined': '0',
  }
  for (const [label, value] of Object.entries(fields))
    await page.getByLabel(new RegExp(`^${label}(times)?$`)).fill(value)
  await start.click() // with the evidence: without it nothing is left to look for after 150 closures
  await page.locator('[data-part=leading] [data-part=photo][data-taken]').nth(1).waitFor()
  await looksWell('search-running', { theme: 'dark' })
  await press('Cancel')
  await page.locator('[data-part=plan]').first().waitFor()
  await page.getByLabel('Evidence').uncheck()
  await page.getByLabel('Closures', { exact: true }).fill('30')
  await start.click()
  await page.locator('[data-part=plan]').nth(1).waitFor()
  await page.locator('[data-part=plan] [data-part=photo][data-taken]').nth(1).waitFor()
  await page.getByRole('checkbox', { name: 'Compare plan 1' }).check()
  await page.getByRole('checkbox', { name: 'Compare plan 2' }).check()
  await looksWell('search-done')
  const problem = { code: 'failed', path: '', message: 'The service ended while this job ran.' }
  await page.route(/\/v1\/jobs\/[0-9a-f-]+$/, async (route) => {
    const job = await (await route.fetch()).json()
    await route.fulfill({ json: { ...job, state: 'FAILED', problems: [problem], links: {} } })
  })
  await page.reload()
  await page.getByText('The search failed').waitFor()
  await looksWell('search-failed')
  await page.unroute(/\/v1\/jobs\/[0-9a-f-]+$/)
})

test('many valves in a table', async () => {
  await view('Cohort')
  const state = page.locator('[data-part=cohort-state]')
  await page.waitForFunction(() =>
    /^(\d+) valves?, \1 closed/.test(document.querySelector('[data-part=cohort-state]')?.textContent ?? ''),
  )
  await page.getByRole('button', { name: 'Leak, mm²' }).click()
  await page.getByRole('columnheader', { name: 'Leak, mm²' }).and(page.locator('[aria-sort=descending]')).waitFor()
  assert.match(await page.locator('[data-part=cohort-valve]').first().textContent(), /Type/)
  for (const name of ['Human: Normal', 'Disease: Barlow']) await page.getByLabel(`Compare ${name}`).check()
  await page.locator('[data-part=compared] figcaption', { hasText: 'Barlow' }).waitFor()
  assert.equal(await page.locator('[data-part=compared] canvas').count(), 2)
  await looksWell('cohort')
  for (const name of ['Human: Normal', 'Disease: Barlow']) await page.getByLabel(`Compare ${name}`).uncheck()
  await page.getByLabel('Filter').fill('type iiib')
  assert.match(await state.textContent(), /^[1-9]\d* valves?,/)
  await page.getByLabel('Files of valves').setInputFiles(filesOf([{ name: 'mine.json', text: '{}' }]))
  await page.locator('[data-part=problems]', { hasText: 'mine.json is not a valve file' }).waitFor()
  await looksWell('cohort-refused', { theme: 'dark' })
  await page.getByLabel('Filter').fill('')
})

test('a study', async () => {
  await view('Studies')
  await looksWell('studies')
})

test('live: at rest, pulled, and while something is picked', async () => {
  await view('Live')
  await page.locator('[data-part=live-state]', { hasText: 'At rest' }).waitFor()
  const named = (text) => page.locator('[data-part=labels] span', { hasText: text })
  await named('aortic root').waitFor()
  await named('P2').waitFor()
  await page.getByLabel('Cut', { exact: true }).check()
  await named('A1').waitFor({ state: 'detached' }) // of the half that is hidden
  await named('A3').waitFor()
  assert.equal(await named('aortic root').count(), 0, 'it is seen from the side')
  await looksWell('live-cut')
  await page.getByLabel('Cut', { exact: true }).uncheck()
  await press('From the atrium')
  await press('P2')
  for (let i = 0; i < 6; ++i) await press('Lift')
  await page.locator('[data-part=live-state]', { hasText: 'Pulled by one hook' }).waitFor()
  await press('From the ventricle')
  await looksWell('live-pulled', { theme: 'dark' })
  await press('Let go')
  await press('Chorda')
  await looksWell('live-picking')
  await page.keyboard.press('Escape')
})

test('training', async () => {
  await view('Train')
  await looksWell('train')
})

test('the keyboard alone reaches everything, and one sees where it is', async () => {
  for (const name of ['Repair', 'Live', 'Search', 'Train']) {
    await view(name)
    const faults = []
    const reached = new Set()
    for (;;) {
      await page.keyboard.press('Tab')
      const { told, fault } = await page.evaluate(() => {
        const focused = document.activeElement
        const { left, top, width, height } = focused.getBoundingClientRect()
        const hit = document.elementFromPoint(left + width / 2, top + height / 2)
        const isSeen =
          hit !== null && (hit.contains(focused) || focused.contains(hit) || hit.closest('label')?.control === focused)
        const told = `${focused.localName} ${focused.getAttribute('aria-label') ?? focused.textContent.slice(0, 40)} ${left} ${top + focused.closest('main, body').scrollTop}`
        const isMarked = getComputedStyle(focused).outlineStyle !== 'none'
        return { told, fault: focused !== document.body && !(isSeen && isMarked) && told }
      })
      if (reached.has(told)) break
      reached.add(told)
      if (fault) faults.push(fault)
    }
    assert.deepEqual(faults, [], name)
    assert.ok(reached.size > 15, `${name}: ${reached.size}`)
  }
})

test('the palette, with and without what is sought', async () => {
  await page.keyboard.press('Control+k')
  await page.locator('#palette-list', { hasText: 'human-normal' }).waitFor()
  await looksWell('palette')
  await page.getByLabel('Find a command').fill('nothing of this name')
  await page.getByText('Nothing found').waitFor()
  await looksWell('palette-empty', { theme: 'dark' })
  await page.getByLabel('Find a command').fill('ring classic 30')
  await page.locator('#palette-list [role=option]', { hasText: 'generic-classic, size 30' }).waitFor()
  await page.getByLabel('Find a command').fill('word tenting')
  await page.locator('#palette-list [role=option]', { hasText: 'tenting height' }).waitFor()
  await page.getByLabel('Find a command').fill('ring')
  await page.keyboard.press('Enter')
  await page.locator('nav [aria-current]', { hasText: 'Repair' }).waitFor()
  await page.locator('[data-part=steps]', { hasText: 'undersized by 2 sizes' }).waitFor()
})

test('an address that names nothing', async () => {
  await page.evaluate(() => (location.hash = '#/valve?valve=no-such-valve'))
  await page.getByText('There is no valve').waitFor()
  complaints.length = 0 // the browser reports the answer 404
  await looksWell('no-such-valve')
})

test('with motion: a beat played to its end, a repair, the palette', async () => {
  const moving = await open('valve', { motion: 'no-preference' })
  const { page: of, complaints: said } = moving
  await named('human-functional-mr', of)
  assert.equal(await of.evaluate(() => matchMedia('(prefers-reduced-motion: reduce)').matches), false)
  await press('Play a beat', of)
  await of.getByRole('button', { name: 'Play a beat' }).waitFor()
  await of.locator('[data-part=labels] [data-part=leak]', { hasText: 'cm²' }).first().waitFor()
  await looksWell('motion-open', { of, said })
  await view('Repair', of)
  await press('Ring', of)
  await of.locator('[data-part=answer]', { hasText: 'Closed and measured' }).waitFor()
  await looksWell('motion-repair', { of, said, theme: 'dark' })
  await of.keyboard.press('Control+k')
  await of.locator('#palette-list', { hasText: 'human-normal' }).waitFor()
  await looksWell('motion-palette', { of, said })
  await of.context().close()
})

test('without the engine live and training are not offered; who asks for them is told', async () => {
  const without = await open('valve', {
    prepare: (other) => other.route('**/coapt-engine.wasm', (route) => route.fulfill({ status: 404 })),
  })
  await named('human-functional-mr', without.page)
  await without.page.getByRole('link', { name: 'Live', exact: true }).waitFor({ state: 'hidden' })
  assert.equal(await without.page.getByRole('link', { name: 'Train', exact: true }).isVisible(), false)
  await without.page.evaluate(() => (location.hash = '#/live'))
  await without.page.getByText('which is not installed').first().waitFor()
  await looksWell('no-engine', { of: without.page, said: [] }) // the browser reports the answer 404
  await without.page.context().close()
})

test('a token is asked for; the link that holds it will do', async () => {
  const token = 'sixteen-or-more-characters'
  const file = join(service.folder, 'token')
  writeFileSync(file, token, { mode: 0o600 })
  const closed = await startService(['--token-file', file])
  try {
    const asked = await open('valve', { url: closed.url })
    await asked.page.getByRole('dialog').waitFor()
    await looksWell('token', { of: asked.page, said: asked.complaints })
    await asked.page.getByLabel('Token', { exact: true }).last().fill(`${closed.url}/#token=${token}`)
    await press('Continue', asked.page)
    await named('human-functional-mr', asked.page)
    await asked.page.context().close()
    const context = await browser.newContext()
    const invited = await context.newPage()
    await invited.goto(`${closed.url}/#token=${token}`) // as coapt-server prints it
    await named('human-functional-mr', invited)
    assert.ok(!invited.url().includes(token))
    await context.close()
  } finally {
    await closed.stop()
  }
})

test('the service is away', async () => {
  const lonely = await startService()
  const left = await open('repair', { url: lonely.url })
  await left.page.getByRole('button', { name: 'Ring', exact: true }).waitFor()
  await lonely.kill()
  await press('Ring', left.page)
  await left.page.locator('[data-part=notices]').getByText('The service does not respond').waitFor()
  await looksWell('offline', { of: left.page, said: [] })
  await left.page.context().close()
})
