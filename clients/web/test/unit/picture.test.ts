import { expect, test } from 'vitest'
import type { Scene } from '../../src/api/types'
import { pixelsOf, withDensity } from '../../src/picture/png'
import { figureLines } from '../../src/picture/saver'
import { pyramid } from './scenes'

/// Of so many mm², known to 5, with openings beside these segments.
function leaking(leak_mm2: number | null, ...segments: string[]): Scene {
  const closure = {
    leak_mm2,
    leak_mm2_error: 5,
    orifices: segments.map((segment) => ({ segment })),
    coaptation: {},
  } as Scene['closure']
  return { ...pyramid(), closure }
}

test('a picture says how large the leak is and where, and grades nothing', () => {
  const first = (before: Scene, after: Scene | null = null) =>
    figureLines(before, after, { schema: 'coapt.plan/1', steps: [] })[0]
  expect(first(leaking(46, 'P2'))).toBe('Leak 46 ± 5 mm² at P2')
  expect(first(leaking(46, 'P2', 'AC'))).toBe('Leak 46 ± 5 mm², largest at P2')
  expect(first(leaking(46))).toBe('Leak 46 ± 5 mm²')
  expect(first(leaking(4, 'AC'))).toBe('Leak 4 ± 5 mm²') // not more than its error
  expect(first(leaking(null, 'AC'))).toBe('Leak not known')
  expect(first(leaking(46, 'P2'), leaking(12, 'A1'))).toBe('Leak 46 → 12 ± 5 mm² at A1')
})

test('180 mm are 2126 pixels at 300 dpi', () => {
  expect(pixelsOf(180)).toBe(2126)
  expect(pixelsOf(25.4)).toBe(300)
})

test('the density stands behind the header, with its check sum, and all else stays', () => {
  const png = Uint8Array.from({ length: 50 }, (_, i) => i)
  const all = withDensity(png)
  expect([...all.slice(0, 33)]).toEqual([...png.slice(0, 33)])
  expect([...all.slice(54)]).toEqual([...png.slice(33)])
  // 11,811 pixels a metre; the sum is zlib's of 'pHYs' and the nine bytes.
  const hex = [...all.slice(33, 54)].map((byte) => byte.toString(16).padStart(2, '0')).join('')
  expect(hex).toBe('000000097048597300002e2300002e230178a53f76')
})
