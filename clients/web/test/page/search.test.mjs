import assert from 'node:assert/strict'
import { readFileSync } from 'node:fs'
import { test } from 'node:test'
import { accessProblems, complaints, openBefore, page, service, settled } from './page.mjs'

openBefore('search', {}, () => page.locator('[data-part=form] h2', { hasText: 'human-functional-mr' }).waitFor())

const set = (label, value) => page.getByLabel(label, { exact: true }).fill(value)
const unfold = (title) =>
  page.locator('[data-part=form] details', { hasText: title }).evaluate((details) => (details.open = true))
const start = () => page.getByRole('button', { name: 'Start the search' }).click()
const accessible = async () => assert.deepEqual(await accessProblems(page), [])

/// Of the search that is open.
async function resultOf() {
  const id = await page.evaluate(() => new URLSearchParams(location.hash.split('?')[1]).get('job'))
  return (await fetch(`${service.url}/v1/jobs/${id}/result`)).json()
}

async function saved(button) {
  const [download] = await Promise.all([page.waitForEvent('download'), button.click()])
  return { name: download.suggestedFilename(), content: readFileSync(await download.path(), 'utf8') }
}

test('what the service says against an option stands at it', async () => {
  await set('Plans to show', '0')
  await unfold('Optimiser')
  await set('Seed', '-1')
  await page.locator('[data-part=form] details', { hasText: 'Optimiser' }).evaluate((details) => (details.open = false))
  await start()
  await page
    .locator('[data-part=option]', { hasText: 'Plans to show' })
    .locator('[data-part=problems] code', { hasText: '/search/plans' })
    .waitFor({ state: 'attached' })
  await page.getByText('Plans to show is 0, must be from 1 to 50').waitFor()
  await page.getByText('Seed is -1').waitFor() // its fold is opened
  await accessible()
  await page.getByRole('button', { name: 'Defaults' }).click()
  assert.equal(await page.locator('[data-part=problems]').count(), 0)
})

test('a search that is cancelled shows the best so far', async () => {
  await unfold('Optimiser')
  await set('Closures', '100000')
  await set('Plans to show', '5')
  await set('Region points', '17')
  await page.getByLabel('Evidence').uncheck()
  await start()
  await page.locator('[data-part=progress] dl', { hasText: /of 1\d\d,/ }).waitFor()
  await page
    .getByText(/^Cost [\d.]+, reached after [\d,]+ of [\d,]+ closures/)
    .first()
    .waitFor()
  await page.locator('[data-part=leading] [data-part=photo][data-taken]').nth(1).waitFor() // before, and with the plan
  await accessible()
  await page.getByRole('button', { name: 'Cancel' }).click()
  await page.getByText('The search was cancelled; these are the best plans so far.').waitFor()
  assert.ok((await page.locator('[data-part=plan]').count()) > 0)
})

test('a search goes on when the page is loaded again', async () => {
  await unfold('Optimiser')
  await set('Closures', '60')
  await set('Plans to show', '2')
  await set('Region points', '33')
  await page.getByLabel('Evidence').check()
  const [answer] = await Promise.all([page.waitForResponse((response) => response.status() === 202), start()])
  const { id } = await answer.json()
  await page.waitForFunction((job) => new URLSearchParams(location.hash.split('?')[1]).get('job') === job, id)
  await page.reload()
  await page.locator('[data-part=plan]').nth(1).waitFor()
  assert.equal(await page.locator('[data-part=jobs] li').count(), 2)
})

test('a picture that comes when its search is no longer open is dropped', async () => {
  let answer
  const asked = new Promise((resolve) => (answer = resolve))
  await page.route('**/v1/scenes', (route) => asked.then(() => route.continue()).catch(() => {})) // some are given up
  const jobs = page.locator('[data-part=jobs] li')
  for (const [job, plans] of [
    [1, 1],
    [0, 2],
  ]) {
    await jobs.nth(job).getByRole('button').first().click()
    await page.waitForFunction((count) => document.querySelectorAll('[data-part=plan]').length === count, plans)
  }
  answer()
  await page.locator('[data-part=photo][data-taken]').nth(2).waitFor() // the valve as it is and two plans
  await page.unroute('**/v1/scenes')
  assert.deepEqual(complaints, [])
})

test('all plans stand in one table, with the reason of the first; pictures follow the theme', async () => {
  const table = page.locator('[data-part=ranked] table')
  assert.equal(await table.locator('tbody tr').count(), 3) // the valve as it is, two plans
  assert.match(
    await page.locator('[data-part=why]').textContent(),
    /leaks less than 5 mm² with a probability of (more than )?\d/,
  )
  await page.locator('[data-part=diagnosis]', { hasText: 'Carpentier type' }).waitFor()
  const corner = () =>
    page
      .locator('[data-part=plan] [data-part=photo] canvas')
      .first()
      .evaluate((canvas) => canvas.getContext('2d').getImageData(2, 2, 1, 1).data[0])
  assert.ok((await corner()) > 200)
  await page.emulateMedia({ colorScheme: 'dark' })
  await page.waitForFunction(() => {
    const canvas = document.querySelector('[data-part=plan] [data-part=photo] canvas')
    return canvas.getContext('2d').getImageData(2, 2, 1, 1).data[0] < 60
  })
  await page.emulateMedia({ colorScheme: 'light' })
  const { name, content } = await saved(page.getByRole('button', { name: 'Every plan tried (CSV)' }))
  assert.equal(name, 'coapt-plans-tried.csv')
  assert.match(content, /^number,rank,description,cost_mm2,/)
})

test('a plan shows the figures of the result', async () => {
  const [best] = (await resultOf()).plans
  const leak = page
    .locator('[data-part=plan]')
    .first()
    .locator('dl > div', { hasText: 'Leak with errors of execution' })
    .locator('dd')
  const [, low, high] = (await leak.textContent()).match(/^([\d.]+) to ([\d.]+) mm²$/)
  const digits = low.split('.')[1]?.length ?? 0
  assert.deepEqual(
    [low, high],
    best.leak.execution.map((mm2) => mm2.toFixed(digits)),
  )
  assert.deepEqual(
    await page.locator('[data-part=plan]').first().locator('[data-part=steps] li').allTextContents(),
    best.description,
  )
})

test('the sum of prices is what plans are ranked by, and costs no place in the table', async () => {
  const { plans, weights } = await resultOf()
  plans.forEach(({ ranked_cost, cost_terms }, i) => {
    const sum = Object.entries(cost_terms).reduce((all, [name, amount]) => all + weights[name] * amount, 0)
    const off = Math.abs(sum - ranked_cost)
    assert.ok(off < 1e-6 * Math.abs(ranked_cost), `plan ${i + 1}: ${sum}, ranked by ${ranked_cost}`)
  })
  assert.equal(await page.locator('[data-part=ranked] [data-part=place]', { hasText: 'cost' }).count(), 0)
})

test('what plans trade is drawn, told plan by plan, and stands in a table', async () => {
  const other = { schema: 'coapt.plan/1', steps: [{ step: 'annuloplasty', shape: 'generic-classic', size_mm: 37.5 }] }
  await page.route('**/v1/jobs/*/result', async (route) => {
    const response = await route.fetch()
    const result = await response.json()
    const known = { sd_mm2: 0.1, ring_sizes_below: 1, steps: 1, durability_mm: 9, cost: 2, nodes: 17 }
    result.pareto_front = [
      { ...known, plan: other, description: ['a ring of 37.5 mm'], mean_mm2: 0.3, opening_mm2: 420 },
      { ...known, plan: result.plans[1].plan, description: ['the second'], mean_mm2: 0.2, opening_mm2: 410 },
    ]
    await route.fulfill({ response, json: result })
  })
  await page.reload()
  const { plans } = await resultOf()
  const trade = page.locator('[data-part=trade-off]')
  const plot = trade.getByRole('img', { name: /^Leak versus diastolic opening\. Up and to the left is better/ })
  await plot.focus()
  await page.keyboard.press('ArrowRight')
  const [{ leak_mm2, opening_area_mm2 }] = plans
  const leak = (leak_mm2.mean + leak_mm2.sd).toFixed(1)
  const opening = (opening_area_mm2 / 100).toFixed(1)
  const here = trade.locator('[data-part=here]')
  assert.match(
    await here.textContent(),
    new RegExp(`^Plan 1: leak ${leak} mm² \\(mean \\+ sd\\), opening ${opening} cm², reserve`),
  )
  await page.keyboard.press('ArrowLeft') // stays at the first
  await page.keyboard.press('ArrowRight')
  assert.match(await here.textContent(), /^Plan 2: /)
  await page.keyboard.press('ArrowRight')
  assert.match(
    await here.textContent(),
    /^Plan A: leak 0\.4 mm² .*Not ranked, because it was closed at only 17 region points\.$/,
  )
  await trade.getByText('Show as table').click()
  const rows = (part) => trade.locator(`[data-part=${part}] tbody th`)
  await rows('as-table').first().waitFor()
  assert.deepEqual(await rows('as-table').allTextContents(), ['Before', '1', '2', 'A'])
  assert.deepEqual(await rows('front').allTextContents(), ['A', '2'])
  await trade.getByRole('list', { name: 'Reserve against progression' }).waitFor()
  await trade.getByText('A, B, …: Pareto-optimal, not ranked').waitFor()
  await accessible()
  await page.unroute('**/v1/jobs/*/result')
})

test('the reader’s own weights reorder plans without a request, and can be set back', async () => {
  // Both robust and open: the first takes a step less, the second leaks less. 1 + 0.8 and 2 + 0.2.
  await page.route('**/v1/jobs/*/result', async (route) => {
    const response = await route.fetch()
    const result = await response.json()
    result.plans.forEach((plan, i) => {
      const none = Object.fromEntries(Object.keys(plan.cost_terms).map((name) => [name, 0]))
      Object.assign(plan, { status: 'converged', crossing: false, region_failures: 0, closes_robustly: true })
      Object.assign(plan.leak_mm2, { mean: 0.1, sd: 0.1 })
      Object.assign(plan, { opening_area_mm2: 300, projected_area_mm2: 300 })
      Object.assign(plan, { ranked_cost: [1.8, 2.2][i], cost_terms: { ...none, step: i + 1, leak: [0.8, 0.2][i] } })
      plan.tie_with_next = i === 0
    })
    await route.fulfill({ response, json: result })
  })
  await page.reload()
  await page.locator('[data-part=photo][data-taken]').nth(2).waitFor() // all that is asked for
  const asked = []
  const listen = (request) => asked.push(request.url())
  page.on('request', listen)
  const ranked = page.locator('[data-part=ranked]')
  const links = ranked.getByRole('link')
  const names = () => links.evaluateAll((all) => all.map((link) => link.textContent))
  const why = ranked.locator('[data-part=why]')
  const back = ranked.getByRole('button', { name: 'Reset', exact: true })
  assert.ok(await back.isDisabled())
  await ranked.getByText('equivalent to 2').waitFor()
  await ranked.getByText('The same for all plans.').first().waitFor() // neither has a price of opening
  await ranked.getByRole('slider', { name: /^Leak:/ }).focus()
  await page.keyboard.press('ArrowRight') // × 1.5: 2.2 and 2.3
  assert.deepEqual(await names(), ['1.', '2.'])
  await page.keyboard.press('ArrowRight') // × 2: 2.6 and 2.4
  assert.deepEqual(await names(), ['2.', '1.'])
  assert.equal(await page.locator(':focus').getAttribute('aria-valuetext'), 'times 2')
  const costs = (await ranked.locator('[data-part=place]').allTextContents()).map(
    (place) => place.match(/reweighted cost .*/)?.[0],
  )
  assert.deepEqual(costs, ['reweighted cost 2.40 mm²', 'reweighted cost 2.60 mm²'])
  assert.match(
    await why.textContent(),
    /^By your weights, plan 2 ranks first with a cost of 2\.40 mm²; plan 1 has 2\.60:/,
  )
  await ranked.getByText('2 → 1', { exact: false }).waitFor()
  await ranked.getByText('moved from place 1 to 2').waitFor({ state: 'attached' })
  assert.equal(await ranked.getByText('equivalent to 2').count(), 0)
  assert.equal(await page.locator('[data-part=plan] h3').first().textContent(), '1.') // a rank remains a name
  await links.first().click()
  assert.equal(await page.getByRole('article', { name: 'Plan of rank 2' }).count(), 1)
  await accessible()
  await back.click()
  assert.deepEqual(await names(), ['1.', '2.'])
  assert.match(await why.textContent(), /leaks less than 5 mm² with a probability of (more than )?\d/)
  await ranked.getByText('equivalent to 2').waitFor()
  page.off('request', listen)
  assert.deepEqual(asked, [])
  await page.unroute('**/v1/jobs/*/result')
  await page.reload()
  await page.locator('[data-part=plan]').nth(1).waitFor()
})

test('its evidence holds a map, curves that can be read and hidden, and the rules of practice', async () => {
  const plan = page.locator('[data-part=plan]').first()
  await plan.locator('summary', { hasText: 'Evidence' }).click()
  await plan.locator('[data-part=heat]').first().waitFor()
  assert.equal(await plan.locator('[data-part=heat]').first().locator('tbody td').count(), 99)
  await plan.locator('[data-part=plot] canvas').waitFor()
  await plan.locator('[data-part=plot]').focus()
  await page.keyboard.press('ArrowRight')
  await plan.locator('[data-part=legend] [data-part=value]', { hasText: /\d/ }).first().waitFor()
  const toggle = plan.locator('[data-part=legend] button').first()
  await toggle.press('Enter')
  assert.equal(await toggle.getAttribute('aria-pressed'), 'false')
  await plan.getByText('Show as table').click()
  await plan.locator('[data-part=as-table] tbody').waitFor()
  assert.equal(await plan.locator('[data-part=as-table] tbody tr').count(), 7) // 0 to 6 mm
  await plan.getByRole('rowheader', { name: 'opening area' }).waitFor()
})

test('two plans are compared', async () => {
  await page.getByRole('checkbox', { name: 'Compare plan 1' }).check()
  await page.getByRole('checkbox', { name: 'Compare plan 2' }).check()
  const comparison = page.getByRole('region', { name: 'Ranks 1 and 2 compared' })
  await comparison.waitFor()
  assert.equal(await comparison.locator('[data-part=photo]').count(), 2)
  assert.equal(await comparison.locator('[data-part=heat-scale]').count(), 1)
  await comparison.getByText('Highest chordal tension').waitFor()
  await comparison.getByRole('button', { name: 'Show both in 3D' }).click()
  await comparison.locator('[data-part=compared] figcaption', { hasText: /^Rank 2: [\d.]+/ }).waitFor()
  const stages = comparison.locator('[data-part=compared] canvas')
  const drawn = async () => {
    await settled()
    return Promise.all([0, 1].map(async (i) => (await stages.nth(i).screenshot()).toString('base64')))
  }
  const [first, second] = await drawn()
  await stages.first().focus()
  await page.keyboard.press('ArrowLeft')
  const [turned, followed] = await drawn()
  assert.notEqual(turned, first)
  assert.notEqual(followed, second) // its camera is linked
  for (const [theme, width] of [
    ['dark', 820],
    ['light', 1280],
  ]) {
    await page.emulateMedia({ colorScheme: theme })
    await page.setViewportSize({ width, height: 900 })
    await accessible()
  }
})

test('plans and meshes can be saved, the report opened', async () => {
  const plan = page.locator('[data-part=plan]').first()
  const { content } = await saved(plan.getByRole('button', { name: 'Plan (JSON)' }))
  assert.equal(JSON.parse(content).schema, 'coapt.plan/1')
  await plan.getByLabel('File format').selectOption('obj')
  assert.match((await saved(plan.getByRole('button', { name: 'Mesh' }))).content, /^v /m)
  const [report] = await Promise.all([page.waitForEvent('popup'), plan.getByRole('link', { name: 'Report' }).click()])
  await report.waitForURL(/\/report$/, { waitUntil: 'load' })
  assert.match(await report.title(), /human-functional-mr/)
  await report.close()
})

test('a plan is kept, and tried by hand', async () => {
  const plan = page.locator('[data-part=plan]').first()
  await plan.getByRole('button', { name: 'Keep' }).click()
  await plan.getByText('Kept;').waitFor()
  await plan.getByRole('button', { name: 'Try by hand' }).click()
  await page.waitForFunction(() => location.hash.startsWith('#/repair?'))
})

test('the list tells what was found; what one tab removes is gone in the other', async () => {
  await page.getByRole('link', { name: 'Search', exact: true }).click()
  const entries = (of) => of.locator('[data-part=jobs] li')
  await entries(page)
    .first()
    .getByText(/leak \d/)
    .waitFor()
  await entries(page)
    .first()
    .getByText(/^today \d\d:\d\d, 60 closures$/)
    .waitFor()
  const second = await page.context().newPage()
  await second.goto(`${service.url}/#/search`)
  await entries(second).nth(1).waitFor()
  await entries(page).nth(1).getByRole('button', { name: 'Remove the search' }).click()
  await entries(second).nth(1).waitFor({ state: 'detached' })
  await entries(page).first().getByRole('button', { name: 'Remove the search' }).click() // the one that is open
  await page.getByText('None yet.').waitFor()
  await page.locator('[data-part=ranked]').waitFor({ state: 'detached' })
  assert.doesNotMatch(page.url(), /job=/)
  await second.close()
})
