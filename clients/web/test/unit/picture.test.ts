import { expect, test } from 'vitest'
import type { Scene } from '../../src/api/types'
import { pixelsOf, withDensity } from '../../src/picture/png'
import { figureLines } from '../../src/picture/saver'
import { pyramid } from './scenes'

/// Of so many mm², known to 5, with openings 3 mm wide between these segments.
function leaking(leak_mm2: number | null, ...openings: string[][]): Scene {
  const leak = {
    area_mm2: leak_mm2,
    error_mm2: 5,
    openings: openings.map((segments) => ({ segments, width_mm: 3 })),
  }
  return { ...pyramid(), closure: { leak_mm2, leak, coaptation: {} } as unknown as Scene['closure'] }
}

test('a picture says how large the leak is and where, and grades nothing', () => {
  const first = (before: Scene, after: Scene | null = null) =>
    figureLines(before, after, { schema: 'coapt.plan/1', steps: [] })[0]
  expect(first(leaking(46, ['P2', 'A2', 'P1']))).toBe('Leak 46 ± 5 mm² at P2 and A2, 3.0 mm wide')
  expect(first(leaking(46, ['P2'], ['AC']))).toBe('Leak 46 ± 5 mm², largest at P2, 3.0 mm wide')
  expect(first(leaking(46, []))).toBe('Leak 46 ± 5 mm², 3.0 mm wide') // of a valve that is not mitral
  expect(first(leaking(46))).toBe('Leak 46 ± 5 mm²')
  expect(first(leaking(4, ['AC']))).toBe('Leak 4 ± 5 mm²') // not more than its error
  expect(first(leaking(null, ['AC']))).toBe('Leak unknown')
  expect(first(leaking(46, ['P2']), leaking(12, ['A1']))).toBe('Leak 46 → 12 ± 5 mm² at A1, 3.0 mm wide')
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
