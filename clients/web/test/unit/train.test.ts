import { beforeEach, expect, test } from 'vitest'
import { exemplars } from '../../src/train/exemplars'
import { nearest, newSeeds } from '../../src/train/practice'
import { readSchedule, STUDIES } from '../../src/train/schedules'
import { telling } from '../../src/train/telling'
import { ofVertex, segmentOf } from '../../src/train/segments'
import { namesAround } from '../../src/viewer/marks'
import { deleteTrials, keepTrial, keptTrials, lettersOf, rightLetters, trialsCsv } from '../../src/train/trials'
import type { CaseA, CaseB, Judged, SegmentTruth } from '../../src/train/types'
import { clockWords, pressed, unless } from '../../src/train/waits'
import { pyramid } from './scenes'

const kept = new Map<string, string>()
beforeEach(() => {
  kept.clear()
  Object.assign(globalThis, {
    localStorage: {
      getItem: (key: string) => kept.get(key) ?? null,
      setItem: (key: string, text: string) => kept.set(key, text),
    },
  })
})

const made = { exam: 'A', seed: 7, name: 'a "good", normal valve', difficulty: -0.25 } as CaseA
const judged: Judged = {
  seconds: 12.3456,
  path_mm: 80.04,
  largest_n: 0.21,
  visited: ['P1', 'AC', 'P1'],
  choice: '3',
  answer: '2',
  right: 0,
  confidence: 0.4,
  choosing_s: 5,
}

test('trials of a learner are numbered from 1, whoever did others between', () => {
  const numbers = [4, 4, 9, 4].map((learner) => keepTrial(learner, 'exam', made, judged).trial)
  expect(numbers).toEqual([1, 2, 1, 3])
  expect(keptTrials().length).toBe(4)
  deleteTrials()
  expect(keptTrials()).toEqual([])
})

test('a trial is a row of the table that coapt train score reads', () => {
  keepTrial(4, 'exam', made, judged)
  keepTrial(4, 'exam', made, { ...judged, largest_n: 1e4, visited: [] })
  expect(trialsCsv(keptTrials()).split('\n')).toEqual([
    'learner,block,trial,valve,exam,seed,difficulty,choice,answer,right,confidence,seconds,path_mm,largest_n,visited',
    '4,exam,1,"a ""good"", normal valve",A,7,-0.25,3,2,0,0.4,12.346,80.04,0.21,P1 AC P1',
    '4,exam,2,"a ""good"", normal valve",A,7,-0.25,3,2,0,0.4,12.346,80.04,100,',
    '',
  ])
})

test('a name is no formula of a spreadsheet, and ends no row', () => {
  for (const [name, cell] of [
    ['=1+1', "'=1+1"],
    ['-5', "'-5"],
    ['@a, b', `"'@a, b"`],
    ['two\nlines', '"two\nlines"'],
    ['\rback', `"'\rback"`],
    ["it's 5 - 3", "it's 5 - 3"],
  ] as const) {
    const trial = keepTrial(4, name, { ...made, name }, judged)
    expect(trialsCsv([trial])).toContain(`4,${cell},${trial.trial},${cell},A,7,-0.25,`)
  }
})

test('answers to exam B are letters, compared one by one', () => {
  expect(lettersOf(['tethered', 'normal', 'prolapsing'])).toBe('TNP')
  expect(rightLetters('TNPNNNNN', 'TTPNNNNP')).toBe(6)
})

test('new cases are those that were not done, and the nearest in difficulty is taken', () => {
  expect(newSeeds([{ seed: 1 }, { seed: 3 }], 1, 3)).toEqual([2, 4, 5])
  const cases = [
    { seed: 2, difficulty: -1 },
    { seed: 4, difficulty: 0.4 },
    { seed: 5, difficulty: 0.5 },
  ]
  expect(nearest(cases, 0.44)).toBe(4)
})

test('the clearest segment of each kind is the exemplar', () => {
  const truth = (segment: string, mobility: string, change_mm: number) =>
    ({ segment, mobility, change_mm }) as SegmentTruth
  const segments = [
    truth('A1', 'normal', 1.2),
    truth('A2', 'tethered', -2.5),
    truth('A3', 'normal', -0.1),
    truth('P1', 'tethered', -4),
  ]
  expect(exemplars({ segments } as CaseB).map(({ segment }) => segment)).toEqual(['P1', 'A3'])
})

test('a vertex belongs to the segment of most faces around it; a chorda leads to that of its insertion', () => {
  const shape = pyramid()
  expect([0, 1, 3].map((vertex) => ofVertex(shape, vertex))).toEqual(['A3', 'A1', 'P1'])
  expect(ofVertex({ ...shape, segments: ['A3', 'A1', 'P1', 'A3'] }, 4)).toBe('A3')
  const cables: [number, number][] = [
    [0, 0],
    [-1, 0],
  ]
  const valve = { scene: shape, systole_mmhg: 120, cables }
  expect(segmentOf(valve, { vertex: 1, at_mm: [0, 10, 0] })).toBe('A1')
  expect(segmentOf(valve, { cable: 0, share: 0.5, at_mm: [0, 0, 0] })).toBe('A3')
  expect(segmentOf(valve, { cable: 1, share: 0.5, at_mm: [0, 0, 0] })).toBeNull() // a tie
})

test('names stand beside the annulus, those that there are words for', () => {
  const names = namesAround(pyramid(), (segment) => (segment === 'P1' ? null : segment))
  expect(names.map(({ text }) => text)).toEqual(['A1', 'A3', 'P3'])
  const [x = 0, y = 0] = names[0]?.point_mm ?? []
  expect(Math.hypot(x, y)).toBeCloseTo(1.14 * Math.hypot(5, 5), 9) // in the middle of the edge
  expect(x).toBeCloseTo(-y, 9)
})

test('the studies of the thesis have blocks; what is no JSON is refused', () => {
  for (const { name, blocks } of STUDIES) expect(`${name} ${blocks.length > 0}`).toBe(`${name} true`)
  expect(() => readSchedule('no')).toThrow()
  expect(readSchedule('{"name": "x"}').blocks).toEqual([])
})

test('time is told in minutes and seconds, and a wait ends when it is stopped', async () => {
  expect([clockWords(179.2), clockWords(0), clockWords(-3), clockWords(61)]).toEqual(['3:00', '0:00', '0:00', '1:01'])
  const stop = new AbortController()
  const waiting = unless(stop.signal, new Promise(() => {}))
  stop.abort()
  await expect(waiting).rejects.toThrow()
  await expect(pressed({} as HTMLButtonElement, stop.signal)).rejects.toThrow()
})

test('the segment whose free edge differs most tells two closed valves apart', () => {
  const shape = pyramid()
  const first = [...shape.rest_mm]
  const edge = shape.leaflet_coordinates.height.findIndex((height) => height > 0.99)
  first[3 * edge + 2] = (first[3 * edge + 2] ?? 0) + 2
  const { segment, higher_mm } = telling(shape, first, shape.rest_mm)
  expect(higher_mm).toBeCloseTo(2, 9)
  expect(shape.segments).toContain(segment)
  expect(telling(shape, shape.rest_mm, first).higher_mm).toBeCloseTo(-2, 9)
})
