// What the view of the farm says of runs and workers.
import { expect, test } from 'vitest'
import { headline, rate } from '../../src/farm/tables'

const worker = { name: 'node1-1', alive: true, barred: false, items: 512, rate_per_s: 120.4, seen_s: 1 }
const run = {
  run: 3,
  label: 'plans',
  kind: 'plans',
  state: 'open' as const,
  created: '2026-11-26T08:00:00Z',
  items: 40,
  done: 13,
  rate_per_s: 0.4,
  eta_s: 67.5,
  workers: 1,
  waits_for_workers: false,
  tasks_poison: 0,
  tasks_disputed: 0,
}

test('the headline counts workers that are alive and runs that are open', () => {
  const gone = { ...worker, alive: false }
  const barred = { ...worker, barred: true }
  expect(headline({ runs: [run], workers: [worker, gone, barred] })).toBe(
    'One worker computes 120 items a second; one run is open.',
  )
  expect(headline({ runs: [{ ...run, state: 'done' }], workers: [worker, worker] })).toBe(
    '2 workers compute 241 items a second; no run is open.',
  )
  expect(headline({ runs: [run, run], workers: [gone] })).toBe('No worker is running; 2 runs are open.')
})

test('a slow rate has a digit after the point', () => {
  expect(rate(0.42)).toBe('0.4/s')
  expect(rate(120.4)).toBe('120/s')
})
