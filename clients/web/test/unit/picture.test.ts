import { expect, test } from 'vitest'
import { pixelsOf, withDensity } from '../../src/picture/png'

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
