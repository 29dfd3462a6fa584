import { expect, test } from 'vitest'
import type { Opening } from '../../src/api/types'
import { shareAt } from '../../src/valve/motion'
import { passageOf } from '../../src/viewer/passage'

test('a beat begins and ends open, is closed in between, and turns back nowhere on the way', () => {
  expect([0, 0.1, 0.2].map(shareAt)).toEqual([-1, -1, -1])
  expect([0.45, 0.5, 0.65].map(shareAt)).toEqual([1, 1, 1])
  expect(shareAt(0.95)).toBeCloseTo(-1)
  expect(shareAt(1)).toBeCloseTo(-1)
  const phases = Array.from({ length: 101 }, (_, i) => i / 100)
  for (const phase of phases.slice(1)) {
    const step = shareAt(phase) - shareAt(phase - 0.01)
    if (phase <= 0.5) expect(step).toBeGreaterThanOrEqual(0)
    else expect(step).toBeLessThanOrEqual(1e-12)
  }
})

test('the outline of a passage is closed and has its area in its middle', () => {
  const scene = { passage_mm: [0, 0, -5, 10, 0, -5, 10, 10, -5, 0, 10, -5] }
  const passage = passageOf({ scene, opening_area_mm2: 123 } as unknown as Opening)
  expect(passage?.line.length).toBe(4 * 6)
  expect(passage?.line.slice(-6)).toEqual([0, 10, -5, 0, 0, -5])
  expect(passage?.labels).toEqual([{ point_mm: [5, 5, -5], text: '1.2 cm²', kind: 'orifice' }])
  expect(passageOf({ scene: { passage_mm: [] } } as unknown as Opening)).toBeNull()
})
