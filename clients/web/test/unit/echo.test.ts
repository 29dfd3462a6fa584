import { describe, expect, test } from 'vitest'
import type { Vector } from '../../src/api/types'
import { echoImage, type Frame, type Quality, type Sheet } from '../../src/echo/image'

const FRAME: Frame = { left_mm: -10, top_mm: -5, pixel_mm: 0.25, width: 80, height: 60 }
const place = (across: number, depth: number): Vector => [7.3, across, -depth]
const across: Sheet[] = [{ from: [-8, 2], to: [8, 2] }]
const alongBeam: Sheet[] = [{ from: [0, -4], to: [0, 9] }]

const seen = (sheets: Sheet[], quality: Quality) => echoImage(sheets, 1, FRAME, place, quality)
/// Mean grey of the pixels that `chosen` takes.
function mean(grey: Uint8ClampedArray, chosen: (across_mm: number, depth_mm: number) => boolean): number {
  let [sum, count] = [0, 0]
  for (let i = 0; i < grey.length; ++i) {
    const x = FRAME.left_mm + (i % FRAME.width) * FRAME.pixel_mm
    const y = FRAME.top_mm + Math.floor(i / FRAME.width) * FRAME.pixel_mm
    if (!chosen(x, y)) continue
    sum += grey[i] as number
    ++count
  }
  return sum / count
}

describe('the synthetic echo', () => {
  test('is the same each time', () => {
    expect(seen(across, 'fair')).toEqual(seen(across, 'fair'))
  })

  test('shows tissue bright where it lies, blood dark', () => {
    const grey = seen(across, 'good')
    const tissue = mean(grey, (x, y) => Math.abs(x) < 7 && Math.abs(y - 2) < 0.4)
    const blood = mean(grey, (_, y) => Math.abs(y - 2) > 3)
    expect(tissue - blood).toBeGreaterThan(80) // 16 dB
  })

  test('is blurred and noisy where its quality is poor', () => {
    const contrast = (quality: Quality) => {
      const grey = seen(alongBeam, quality)
      const beside = mean(grey, (x, y) => Math.abs(Math.abs(x) - 1.5) < 0.3 && y > -3 && y < 8)
      return mean(grey, (x, y) => Math.abs(x) < 0.4 && y > -3 && y < 8) - beside
    }
    expect(contrast('good')).toBeGreaterThan(contrast('fair'))
    expect(contrast('fair')).toBeGreaterThan(contrast('poor'))
  })

  test('loses tissue that lies along the beam', () => {
    const facing = mean(seen(across, 'good'), (x, y) => Math.abs(x) < 7 && Math.abs(y - 2) < 0.4)
    const along = mean(seen(alongBeam, 'good'), (x, y) => Math.abs(x) < 0.4 && y > -3 && y < 8)
    expect(facing - along).toBeGreaterThan(30) // 6 dB
  })

  test('has speckle, not flat grey', () => {
    const grey = seen(across, 'good')
    const row = Math.round((2 - FRAME.top_mm) / FRAME.pixel_mm)
    const values = [...grey.slice(row * FRAME.width + 10, row * FRAME.width + 70)]
    expect(Math.max(...values) - Math.min(...values)).toBeGreaterThan(40)
  })
})
