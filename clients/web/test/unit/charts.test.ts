import { expect, test } from 'vitest'
import { evenLimits, shadeOf } from '../../src/charts/colours'
import { roundDown, roundsIn, roundUp } from '../../src/charts/rounds'
import { aligned, readAt } from '../../src/charts/series'
import { histogram } from '../../src/studies/histogram'

test('series with places of their own share one list of them', () => {
  const series = [
    { label: 'a', hue: 0 as const, x: [0, 2], y: [1, 2] },
    { label: 'b', hue: 1 as const, x: [1, 2], y: [3, null] },
  ]
  expect(aligned(series)).toEqual({
    x: [0, 1, 2],
    y: [
      [1, null, 2],
      [null, 3, null],
    ],
  })
})

test('where a line has no value the nearest is read, of steps the one before, of dots none', () => {
  const values = [1, null, undefined, 4]
  expect([1, 2].map((index) => readAt('line', values, index))).toEqual([0, 3])
  expect([1, 2].map((index) => readAt('steps', values, index))).toEqual([0, 0])
  expect([1, 2].map((index) => readAt('dots', values, index))).toEqual([1, 2])
  expect(readAt('line', [null, null], 1)).toBe(1)
})

test('a shade begins at its limit', () => {
  expect([-1, 0, 0.4, 0.5, 1.9, 2, 99].map((value) => shadeOf(value, [0.5, 2]))).toEqual([0, 0, 0, 1, 1, 2, 2])
  expect(evenLimits(8)).toEqual([1, 2, 3, 4, 5, 6, 7])
})

test('a histogram counts every known value once, in round bins', () => {
  const { edges, counts } = histogram([[0, 0.5, 1, 3.9, null], [4]], 4)
  expect(edges).toEqual([0, 1, 2, 3, 4, 5])
  expect(counts).toEqual([
    [2, 1, 0, 1, 0],
    [0, 0, 0, 0, 1],
  ])
})

test('a histogram of one value has one bin, one of nothing an empty one', () => {
  expect(histogram([[5, 5]], 4)).toEqual({ edges: [5, 6], counts: [[2]] })
  expect(histogram([[null]], 4)).toEqual({ edges: [0, 1], counts: [[0]] })
})

test('round numbers are 1, 2 and 5 times a power of ten', () => {
  expect([0.07, 1, 3, 5.1, 20].map(roundUp)).toEqual([0.1, 1, 5, 10, 20])
  expect([0.07, 1, 3, 5.1, 20].map(roundDown)).toEqual([0.05, 1, 2, 5, 20])
  expect(roundsIn(0.5, 21)).toEqual([0.5, 1, 2, 5, 10, 20])
})
