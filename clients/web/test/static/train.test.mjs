// The trainer in a browser: a trial of each exam from its start to the table of trials, with a scripted hand.
import assert from 'node:assert/strict'
import { readFileSync } from 'node:fs'
import { join } from 'node:path'
import { after, before, test } from 'node:test'
import { looks } from '../page/looks.mjs'
import { accessProblems, openView, ROOT, startBrowser } from '../page/page.mjs'
import { startFiles } from './files.mjs'

const SEGMENTS = ['A1', 'A2', 'A3', 'P1', 'P2', 'P3', 'AC', 'PC']

let files, browser, page, complaints
before(async () => {
  files = await startFiles(join(ROOT, 'build/static'))
  browser = await startBrowser()
  ;({ page, complaints } = await openView(browser, files.url, 'train'))
})
after(async () => {
  await browser.close()
  await files.stop()
  assert.deepEqual(complaints, [])
})

const task = (words) => page.locator('[data-part=train-task]', { hasText: words }).waitFor()
const press = (name) => page.getByRole('button', { name, exact: true }).click()

/// Grabs the free edge of a segment and lifts it.
async function pull(segment, lift_mm) {
  await press(segment)
  await page.waitForFunction(() => globalThis.coapt.live.state()?.hand)
  await page.evaluate((lift) => {
    const { hand } = globalThis.coapt.live.state()
    globalThis.coapt.live.moveTo(hand[0], hand[1], hand[2] + lift)
  }, lift_mm)
  await page.waitForFunction(() => globalThis.coapt.live.forceN() > 0.05)
}

async function csv() {
  const [file] = await Promise.all([page.waitForEvent('download'), press('Export CSV of all trials')])
  const [header, ...rows] = readFileSync(await file.path(), 'utf8')
    .trim()
    .split('\n')
  return rows.map((row) => Object.fromEntries(row.split(',').map((cell, i) => [header.split(',')[i], cell])))
}

test('exam A: four closed valves, the flaccid one under the hook, a choice; nothing tells the answer', async () => {
  await page.getByRole('combobox', { name: 'Task' }).selectOption('study-1')
  await page.getByLabel('Learner').fill('7')
  await press('Start')
  await task('Four valves under pressure')
  await page.getByText('Synthetic echo', { exact: true }).click()
  const grey = () =>
    page.locator('[data-part=echo] canvas').evaluateAll((all) =>
      all.map((canvas) => {
        const { data } = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height)
        return data.reduce((sum, value) => sum + value, 0)
      }),
    )
  const middle = await grey()
  assert.equal(new Set(middle).size, 4, 'each valve has its own')
  await page.getByRole('slider', { name: 'Position of the cut' }).fill('0.5')
  assert.notDeepEqual(await grey(), middle)
  assert.deepEqual(await accessProblems(page), [])
  await press('Continue to the flaccid valve')
  await page.locator('[data-part=clock]', { hasText: /^(3:00|2:\d\d) left$/ }).waitFor()
  assert.equal(await page.locator('[data-part=echo]').count(), 0, 'it would show heights')
  await pull('P1', 12)
  await pull('AC', 12)
  assert.deepEqual(await accessProblems(page), [])
  await press('I have seen enough')
  await task('Which of the four')
  assert.ok(await page.getByRole('button', { name: 'Answer' }).isDisabled())
  await page.getByRole('radio', { name: 'Valve 2' }).check()
  await page.getByLabel('How sure?').fill('60')
  assert.deepEqual(await accessProblems(page), [])
  await press('Answer')
  await page.getByRole('heading', { name: 'trial 2 of 10' }).waitFor()
  await press('Stop')
  const [trial] = await csv()
  assert.equal(`${trial.learner} ${trial.block} ${trial.trial} ${trial.exam}`, '7 exam 1 A')
  assert.equal(trial.choice, '2')
  assert.equal(Number(trial.right), trial.answer === '2' ? 1 : 0)
  assert.equal(trial.confidence, '0.6')
  assert.equal(trial.visited, 'P1 AC')
  assert.ok(Number(trial.path_mm) >= 24 && Number(trial.largest_n) > 0.05 && Number(trial.seconds) > 0)
})

test('exam B in practice: eight segments are judged, the answer is told, the engine scores both trials', async () => {
  await press('Exams and practice')
  await page.getByRole('combobox', { name: 'Task' }).selectOption('practice B')
  await page.getByLabel('First case').fill('3')
  await press('Start')
  await task('Pull each free edge')
  await pull('P2', 10)
  for (const segment of SEGMENTS)
    await page.getByLabel(`${segment} ${segment === 'P2' ? 'prolapsing' : 'normal'}`).check()
  assert.deepEqual(await accessProblems(page), [])
  await press('Answer')
  await task(/of 8 segments are correct/)
  assert.equal(await page.locator('[data-part=truth] tr').count(), 9)
  assert.deepEqual(await accessProblems(page), [])
  await press('Stop')
  await page.locator('[data-part=scores]', { hasText: 'of 8' }).waitFor()
  const [, trial] = await csv()
  assert.equal(trial.choice, 'NNNNPNNN')
  assert.match(trial.answer, /^[TNP]{8}$/)
  assert.equal(trial.visited, 'P2')
  assert.deepEqual(await accessProblems(page), [])
})

test('exam A in practice: the answer says which segment gave the valve away, and shows it', async () => {
  await press('Exams and practice')
  await page.getByRole('combobox', { name: 'Task' }).selectOption('practice A')
  await press('Start')
  await task('Four valves under pressure')
  await press('Continue to the flaccid valve')
  await press('I have seen enough')
  await page.getByRole('radio', { name: 'Valve 2' }).check()
  await press('Answer')
  const why = page.locator('[data-part=why]')
  await why.filter({ hasText: /its free edge closes \d+\.\d mm (higher|lower) than in valve [1-4]/ }).waitFor()
  const [, segment] = /^(\w\w) distinguishes valve [1-4]/.exec(await why.textContent())
  assert.match(await why.textContent(), new RegExp(`You did not pull ${segment}\\.$`))
  assert.equal(await page.locator('[data-part=four-valves] [data-part=segment]', { hasText: segment }).count(), 4)
  await looks('practice-answer', page, complaints)
  await press(`Pull ${segment} once more`)
  await page.waitForFunction(() => globalThis.coapt.live.state()?.hand)
  await looks('practice-pull', page, complaints, { theme: 'dark' })
  await press('Back to the four valves')
  await why.waitFor()
  await press('Feel an exemplar of each kind')
  await page.locator('[data-part=exemplars][data-case="3"] li').nth(2).waitFor()
  await press('Back')
  await why.waitFor()
  await press('Stop')
})

test('a schedule of a file ends the analysis in time', async () => {
  await press('Exams and practice')
  const blocks = [{ name: 'short', exam: 'B', cases: 1, seconds: 1 }]
  const schedule = { schema: 'coapt.training_schedule/1', name: 'mine', title: 'My own', blocks }
  await page.getByText('Another schedule').click()
  await page
    .getByLabel('Schedule file')
    .setInputFiles({ name: 'mine.json', mimeType: 'application/json', buffer: Buffer.from(JSON.stringify(schedule)) })
  await page.locator('select', { hasText: 'My own' }).waitFor()
  await press('Start')
  await task('Time is up')
  for (const segment of SEGMENTS) await page.getByLabel(`${segment} tethered`).check()
  await press('Answer')
  await page.locator('[data-part=trials]', { hasText: 'TTTTTTTT' }).waitFor()
  assert.equal((await csv()).at(-1).seconds, '1')
})

test('an exemplar of each kind is shown being pulled', async () => {
  await press('Learn')
  await page.locator('[data-part=exemplars][data-case="3"] li').nth(2).waitFor()
  await page
    .getByRole('button', { name: /^Show how/ })
    .first()
    .click()
  await page.waitForFunction(() => globalThis.coapt.live.forceN() > 0.15)
  await page.waitForFunction(() => globalThis.coapt.live.state().spot === null) // let go again
  assert.deepEqual(await accessProblems(page), [])
})

test('all trials are deleted', async () => {
  await press('Results')
  await press('Delete all trials')
  await press('Delete 4 trials for good')
  await page.getByText('No trials yet.').waitFor()
})

test('where the browser lacks something the page says what', async () => {
  const context = await browser.newContext()
  const other = await context.newPage()
  await other.addInitScript(() => (WebAssembly.validate = () => false))
  await other.goto(`${files.url}/#train`)
  await other.getByRole('button', { name: 'Start', exact: true }).click()
  await other.locator('[data-part=problems]', { hasText: 'This view requires WebAssembly with SIMD' }).waitFor()
  await context.close()
})
