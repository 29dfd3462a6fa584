import { expect, test } from 'vitest'
import { shareAt } from '../../src/valve/motion'

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
