import { expect, test } from 'vitest'
import type { JobProgress } from '../../src/api/types'
import { Pace, roughly } from '../../src/jobs/pace'
import { costSummary, endedSeries, isFlat, liveSeries } from '../../src/search/cost_chart'

function progress(stage: string, closures: number, seconds: number, more: Partial<JobProgress> = {}): JobProgress {
  return {
    stage,
    closures,
    closures_planned: 100,
    best_leak_mm2: null,
    best_cost: null,
    random_cost: null,
    seconds,
    ...more,
  }
}

test('what is left goes by the pace of the stage', () => {
  const pace = new Pace()
  expect(pace.left(progress('searching', 0, 1))).toBeNull()
  expect(pace.left(progress('searching', 20, 3))).toBe(8) // 10 a second, 80 left
  expect(pace.left(progress('ranking', 40, 5))).toBeNull() // a stage has a pace of its own
  expect(pace.left(progress('ranking', 50, 15))).toBe(50)
})

test('known closures at the start say nothing of the pace', () => {
  const pace = new Pace()
  expect(pace.left(progress('searching', 60, 0))).toBeNull()
  expect(pace.left(progress('searching', 70, 5))).toBe(15)
})

test('a stage that begins again has a new pace', () => {
  const pace = new Pace()
  pace.left(progress('ring', 90, 9))
  expect(pace.left(progress('ring', 0, 10))).toBeNull()
  expect(pace.left(progress('ring', 50, 20))).toBe(10)
})

test('stages that share their closures foretell the end of all of them', () => {
  const pace = new Pace({ searching: 0.6, ranking: 0.5 })
  pace.left(progress('searching', 0, 0))
  expect(pace.left(progress('searching', 20, 4))).toBe(8) // 5 a second, 40 of the 60 that are needed
  expect(pace.left(progress('ranking', 20, 5))).toBe(7) // time passes
})

test('what is told follows a change of pace slowly', () => {
  const pace = new Pace()
  pace.left(progress('searching', 0, 0))
  expect(pace.left(progress('searching', 40, 4))).toBe(6)
  const slower = pace.left(progress('searching', 42, 6)) ?? 0 // 7 a second now, 58 left: 8.3 s; 4 were expected
  expect(slower).toBeGreaterThan(4)
  expect(slower).toBeLessThan(6)
})

test('a limit of the time is the end at the latest', () => {
  for (const [closures, left] of [
    [5, 26], // 76 by the pace
    [50, 4],
  ] as const) {
    const pace = new Pace()
    expect(pace.left(progress('searching', 0, 0), 30)).toBe(30)
    expect(pace.left(progress('searching', closures, 4), 30)).toBe(left)
  }
})

test('time left is told no more exactly than it is known', () => {
  expect([3, 43, 58, 95, 400, 7000].map(roughly)).toEqual([
    'a few seconds',
    'about 45 s',
    'about 1 min',
    'about 1.5 min',
    'about 7 min',
    'about 2 h',
  ])
})

test('the best score is told with when it was found', () => {
  const series = endedSeries(
    [
      { closures: 9, cost: 5 },
      { closures: 24, cost: 2.6 },
      { closures: 2000, cost: 2.6 },
    ],
    [],
  )
  expect(costSummary(series)).toBe('Cost 2.60, reached after 24 of 2,000 closures.')
  expect(isFlat(series)).toBe(false)
  expect(
    isFlat(
      endedSeries(
        [
          { closures: 9, cost: 5 },
          { closures: 24, cost: 5 },
        ],
        [],
      ),
    ),
  ).toBe(true)
})

test('the live curves hold what is known, once for each number of closures', () => {
  const [ours, random] = liveSeries([
    progress('searching', 1, 1),
    progress('searching', 9, 2, { best_cost: 5 }),
    progress('searching', 9, 3, { best_cost: 4, random_cost: 8 }),
  ])
  expect(ours).toMatchObject({ x: [9], y: [4] })
  expect(random).toMatchObject({ x: [9], y: [8] })
})

test('a service that does not tell costs gives no curve', () => {
  const { best_cost: _, random_cost: __, ...older } = progress('searching', 9, 2)
  expect(liveSeries([older as JobProgress]).every((one) => one.x.length === 0)).toBe(true)
})

test('a short search has no curve of random search', () => {
  expect(endedSeries([{ closures: 9, cost: 2 }], []).map(({ label }) => label)).toEqual(['coapt'])
})
