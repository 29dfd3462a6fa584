// Which of two plans the reader prefers. What a service says of answers is made here, but for the first test, which asks the
// service itself.
import assert from 'node:assert/strict'
import { readFileSync } from 'node:fs'
import { test } from 'node:test'
import { setTimeout as wait } from 'node:timers/promises'
import { accessProblems, complaints, openBefore, page, service } from './page.mjs'

const PATH = '**/v1/preferences'
const VALVE = 'human-functional-mr'
const PAIRS = [
  [2, 1],
  [3, 1],
  [2, 3],
]
let job, weights

openBefore('search', {}, startSearch)

const post = (path, body) =>
  fetch(service.url + path, {
    method: 'POST',
    headers: { 'Content-Type': 'application/json' },
    body: JSON.stringify(body),
  })
async function startSearch() {
  const search = { evaluations: 30, region_points: 9, plans: 3, evidence: false, fine_levels: 0, model_draws: 0 }
  job = (await (await post('/v1/plans', { valve: VALVE, search })).json()).id
  while ((await fetch(`${service.url}/v1/jobs/${job}/result`)).status !== 200) await wait(500)
}

const panel = () => page.locator('[data-part=learning]')
const press = (name) => panel().getByRole('button', { name }).click()
const asks = (words) => panel().getByRole('heading', { name: words }).waitFor()
const says = (words) => panel().locator('[data-part=standing]', { hasText: words }).waitFor()
const accessible = async () => assert.deepEqual(await accessProblems(page), [])
const names = () => page.locator('[data-part=ranked] tbody a').evaluateAll((all) => all.map((link) => link.textContent))
const title = () => page.locator('[data-part=ranked] h2').textContent()

async function open() {
  await page.goto(`${service.url}/#/search?valve=${VALVE}&job=${job}`)
  await page.reload()
  await panel().locator('summary').click()
}

/// Leaks are worth twice as much after two answers.
function canned({ cases: [{ name, plans }], answers }) {
  const [first, second] = PAIRS[answers.length] ?? []
  const isKnown = answers.length >= 2
  return {
    schema: 'coapt.preference/1',
    question: first ? { case: name, first, second, repeats: false, information_bits: 0.3, plans: [{}, {}] } : null,
    first_places: [{ case: name, rank: plans.length, probability: 0.614 }],
    learned: {
      ...{ schema: 'coapt.weights/1', version: '0', notice: '', noise_mm2: 0.7, tie: 0.5, log_sd: {} },
      ...{ covariance: { names: [], matrix: [] }, unable: 0, consistency: null, answers: answers.length },
      weights: { ...weights, leak: isKnown ? 2 : 1 },
      informed: isKnown ? ['leak'] : [],
    },
  }
}

test('the service asks, hears an answer and asks again', async (t) => {
  if ([404, 405].includes((await post('/v1/preferences', {})).status)) return t.skip('an older service')
  await open()
  await asks(/^Plan \d or plan \d\?$/)
  await says('No question answered yet.')
  await panel()
    .getByRole('button', { name: /^This one/ })
    .first()
    .click()
  await says(/^1 question answered\. Plan \d is most likely .* \d+ %/)
  await press('Start again')
  await says('No question answered yet.')
})

test('an answer is asked for at once, one at a time, and the focus stays at the question', async () => {
  // All robust and open: 1 + 0.8, 2 + 0.2 and 3. With leaks worth twice as much 2.6, 2.4 and 3.
  await page.route('**/v1/jobs/*/result', async (route) => {
    const response = await route.fetch()
    const result = await response.json()
    assert.equal(result.plans.length, 3)
    weights = result.weights
    result.plans.forEach((plan, i) => {
      const none = Object.fromEntries(Object.keys(plan.cost_terms).map((name) => [name, 0]))
      Object.assign(plan, { status: 'converged', crossing: false, region_failures: 0, closes_robustly: true })
      Object.assign(plan.leak_mm2, { mean: 0.1, sd: 0.1 })
      Object.assign(plan, { opening_area_mm2: 300, projected_area_mm2: 300 })
      const leak = [0.8, 0.2, 0][i]
      Object.assign(plan, { ranked_cost: i + 1 + leak, cost_terms: { ...none, step: i + 1, leak } })
    })
    await route.fulfill({ response, json: result })
  })
  const asked = []
  let answer = Promise.resolve()
  await page.route(PATH, async (route) => {
    asked.push(route.request().postDataJSON())
    await answer
    await route.fulfill({ json: canned(asked.at(-1)) })
  })
  await open()
  await asks('Plan 2 or plan 1?')
  const [{ cases, answers, hide_figures }] = asked
  assert.deepEqual([cases.length, cases[0].name, answers, hide_figures], [1, job, [], false])
  assert.deepEqual(
    cases[0].plans.map(({ cost_terms }) => cost_terms.step),
    [1, 2, 3],
  )
  await panel().locator('[data-part=photo][data-taken]').nth(3).waitFor() // of either plan, closed and open
  await panel().locator('[data-part=cut] svg').nth(1).waitFor()
  assert.equal(await panel().locator('dd').count(), 6)
  await panel().getByLabel('Hide figures').check()
  assert.equal(await panel().locator('dd:visible, svg text:visible').count(), 0)
  await accessible()

  let go
  answer = new Promise((resolve) => (go = resolve))
  await panel().getByRole('button', { name: 'This one plan 2' }).press('Enter')
  assert.ok(await panel().getByRole('button', { name: 'Cannot decide' }).isDisabled())
  go()
  await asks('Plan 3 or plan 1?')
  await says('1 question answered. Plan 3 is most likely your preferred plan (probability 61 %).')
  assert.equal(await page.locator(':focus').textContent(), 'Plan 3 or plan 1?')
  assert.equal(asked.length, 2)
  assert.deepEqual(asked[1].answers, [{ case: job, first: 2, second: 1, answer: 'first' }])
  await panel().getByText('Your answers have not narrowed any weight yet').waitFor()
})

test('answers survive a reload; plans are ordered by what they say, times the sliders', async () => {
  await open()
  await asks('Plan 3 or plan 1?')
  await press('Cannot decide')
  await asks('Plan 2 or plan 3?')
  const cells = panel().locator('[data-part=informed] tbody tr')
  assert.deepEqual(await cells.locator('th, td').allTextContents(), [
    'Leak, per mm² of mean + weighted sd',
    '1',
    '2',
    '× 2.00',
  ])
  assert.deepEqual(await names(), ['1.', '2.', '3.'])
  const order = panel().getByLabel('Rank plans by the learned weights')
  await order.check()
  assert.deepEqual(await names(), ['2.', '1.', '3.'])
  assert.equal(await title(), '3 ranked plans, best first by the learned weights')
  assert.match(
    await page.locator('[data-part=why]').textContent(),
    /^By the learned weights, plan 2 ranks first with a cost of 2\.40 mm²; plan 1 has 2\.60:/,
  )
  const operation = page.getByRole('slider', { name: /^Operation:/ })
  await operation.focus()
  for (let i = 0; i < 2; ++i) await page.keyboard.press('ArrowLeft') // × 0.5: 2.1, 1.4 and 1.5
  assert.deepEqual(await names(), ['2.', '3.', '1.'])
  assert.equal(await title(), '3 ranked plans, best first by the learned weights and your weights')
  await page.getByRole('button', { name: 'Reset', exact: true }).click()
  for (const [colorScheme, width] of [
    ['dark', 1280],
    ['light', 390],
    ['light', 1280],
  ]) {
    await page.emulateMedia({ colorScheme })
    await page.setViewportSize({ width, height: 900 })
    await accessible()
  }
  await order.uncheck()
  assert.deepEqual(await names(), ['1.', '2.', '3.'])
  assert.equal(await title(), '3 ranked plans, best first')
})

test('the learned weights is saved as a search takes it', async () => {
  const [file] = await Promise.all([page.waitForEvent('download'), press('Save the weights (JSON)')])
  assert.equal(file.suggestedFilename(), 'weights.json')
  const { schema, weights } = JSON.parse(readFileSync(await file.path(), 'utf8'))
  assert.deepEqual([schema, weights.leak], ['coapt.weights/1', 2])
})

test('the last answer is taken back, all are forgotten; then plans have the order of the search', async () => {
  await press('This one plan 3')
  await asks('No question is left; all pairs have been compared.')
  await press('Undo the last answer')
  await asks('Plan 2 or plan 3?')
  await panel().getByLabel('Rank plans by the learned weights').check()
  await press('Start again')
  await says('No question answered yet.')
  assert.equal(await title(), '3 ranked plans, best first')
  assert.equal(await panel().locator('[data-part=learned]').isVisible(), false)
  assert.ok(await panel().getByRole('button', { name: 'Undo the last answer' }).isDisabled())
})

test('an answer that the service does not take is not kept; an older service is told as one', async () => {
  await page.unroute(PATH)
  const refuse = (status, body) => page.route(PATH, (route) => route.fulfill({ status, json: body }), { times: 1 })
  await refuse(422, { problems: [{ code: 'out_of_range', path: '/answers/0/first', message: 'first is 9' }] })
  await press('This one plan 2')
  await panel().locator('[data-part=problems]', { hasText: 'first is 9' }).waitFor()
  await asks('Plan 2 or plan 1?')
  assert.ok(await panel().getByRole('button', { name: 'Undo the last answer' }).isDisabled())
  await refuse(404, { title: 'Not Found' })
  await open()
  await panel().getByText('This service cannot learn preferences because it is older than this page.').waitFor()
  await accessible()
  for (const said of complaints.splice(0)) assert.match(said, /404/)
})
