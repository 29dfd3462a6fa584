import { expect, test } from 'vitest'
import { around, layOut, type Word } from '../../src/viewer/label_layout'

const SIZE = { width: 400, height: 300 }
const word = (x: number, y: number, more: Partial<Word> = {}): Word => {
  return { x, y, width: 40, height: 16, rank: 1, reach: 60, ...more }
}

test('a word stands where it is best if there is room', () => {
  expect(layOut([word(100, 100), word(200, 100)], [], SIZE)).toEqual([
    { x: 100, y: 100, isMoved: false },
    { x: 200, y: 100, isMoved: false },
  ])
})

test('of two words at one place the more important one stays', () => {
  const [second, first] = layOut([word(100, 100, { rank: 2 }), word(105, 100, { rank: 1 })], [], SIZE)
  expect(first).toEqual({ x: 105, y: 100, isMoved: false })
  expect(second?.isMoved).toBe(true)
  const apart = Math.abs((second?.x ?? 0) - 105) >= 40 || Math.abs((second?.y ?? 0) - 100) >= 16
  expect(apart).toBe(true)
})

test('nothing stands over what has to be seen', () => {
  const [spot] = layOut([word(200, 150)], [{ left: 150, top: 130, right: 250, bottom: 170 }], SIZE)
  expect(Math.abs((spot?.y ?? 150) - 150)).toBeGreaterThanOrEqual(20 + 8)
})

test('a word goes away from what has to be seen, not across it', () => {
  const opening = { left: 150, top: 140, right: 250, bottom: 160 }
  const [spot] = layOut([word(200, 132)], [opening], SIZE)
  expect(spot?.y).toBeLessThan(132)
})

test('words stay on the canvas', () => {
  const [spot] = layOut([word(390, 4)], [], SIZE)
  expect(spot?.x).toBeLessThanOrEqual(400 - 20)
  expect(spot?.y).toBeGreaterThanOrEqual(8)
})

test('a word without room near enough is left out', () => {
  expect(layOut([word(200, 150, { reach: 20 })], [{ left: 100, top: 80, right: 300, bottom: 220 }], SIZE)).toEqual([
    null,
  ])
})

test('a box holds its points', () => {
  expect(around([])).toBeNull()
  expect(
    around([
      { x: 3, y: 1 },
      { x: -1, y: 7 },
    ]),
  ).toEqual({ left: -1, top: 1, right: 3, bottom: 7 })
})
