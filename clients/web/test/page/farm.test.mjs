// The view of the farm, on what a service tells that has one.
import assert from 'node:assert/strict'
import { test } from 'node:test'
import { accessProblems, openBefore, page } from './page.mjs'

const RUN = {
  ...{ run: 12, label: 'plans', kind: 'plans', state: 'open', created: '2026-11-26T08:00:00Z', items: 40, done: 13 },
  ...{ rate_per_s: 0.4, eta_s: 67.5, workers: 1, waits_for_workers: false, tasks_poison: 0, tasks_disputed: 1 },
}
const WORKER = { name: 'node1-1', alive: true, barred: false, items: 2048, rate_per_s: 120.5, seen_s: 0.8 }

openBefore('studies')

test('there is no link to a farm where the service has none', async () => {
  await page.getByRole('link', { name: 'Studies' }).waitFor()
  assert.equal(await page.getByRole('link', { name: 'Farm' }).isVisible(), false)
})

test('runs and workers are shown, and again while they change', async () => {
  let done = RUN.done
  const tell = (answer) => (route) => route.fulfill({ json: { ...answer(), notice: '' } })
  await page.route(
    '**/version',
    tell(() => ({ version: '0', api: 'v1', farm: true, not_modelled: [] })),
  )
  await page.route(
    '**/v1/farm',
    tell(() => ({ runs: [{ ...RUN, done }], workers: [WORKER] })),
  )
  await page.reload()
  await page.getByRole('link', { name: 'Farm' }).click()
  await page.getByText('One worker computes 121 items a second; one run is open.').waitFor()
  await page.getByText('1 with conflicting results').waitFor()
  assert.equal(await page.getByRole('progressbar', { name: 'Run 12' }).getAttribute('value'), '13')
  done = 14
  await page.getByText('14 of 40').waitFor()
  assert.deepEqual(await accessProblems(page), [])
})
