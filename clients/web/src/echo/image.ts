// A synthetic echo of a cut through a valve (thesis 5.2.3): scatterers of a fixed noise volume wherever tissue is, seen through the
// point spread of a probe in the atrium, in logarithmic grey. It has the look of an echo, speckle, blur and drop-out of tissue
// that lies along the beam, not its acoustics: no shadows, no refraction, no side lobes.
import type { Vector } from '../api/types'

export type Quality = 'good' | 'fair' | 'poor'

/// `axial_mm`, `lateral_mm`: standard deviations of the point spread along and across the beam; `noise_db`: of the receiver,
/// against tissue that faces the beam. Assumed: what transesophageal pictures of 5 to 7 MHz look like at 5 cm.
interface Probe {
  axial_mm: number
  lateral_mm: number
  noise_db: number
}
const PROBES: Record<Quality, Probe> = {
  good: { axial_mm: 0.25, lateral_mm: 0.5, noise_db: -46 },
  fair: { axial_mm: 0.35, lateral_mm: 0.9, noise_db: -36 },
  poor: { axial_mm: 0.5, lateral_mm: 1.6, noise_db: -22 },
}

/// A piece of a leaflet in the cut: across the beam and along it, from the probe's side on, mm.
export interface Sheet {
  from: [number, number]
  to: [number, number]
}

/// The picture's place in the cut.
export interface Frame {
  left_mm: number
  top_mm: number
  pixel_mm: number
  width: number
  height: number
}

const SAMPLES = 64 // of the noise volume, along each side; then it repeats
const SPACING_MM = 0.3
const WAVE_MM = 0.3 // of the pulse, there and back
const ALONG_BEAM = 0.3 // amplitude of tissue along the beam, of that across it
const BLOOD = 0.01
const RANGE_DB = 50 // from black to white
const REACH = 2.5 // standard deviations that a spread is followed to

let volume: Float32Array | null = null

/// Normal deviates, the same in every browser.
function noise(): Float32Array {
  if (volume) return volume
  volume = new Float32Array(SAMPLES ** 3)
  let state = 1
  const share = () => {
    state = (Math.imul(state, 1664525) + 1013904223) >>> 0
    return (state >>> 8) / 2 ** 24
  }
  for (let i = 0; i < volume.length; ++i) {
    let sum = -6
    for (let k = 0; k < 12; ++k) sum += share()
    volume[i] = sum
  }
  return volume
}

function sampleAt([x, y, z]: Vector): number {
  const index = (value: number) => Math.floor(value / SPACING_MM) & (SAMPLES - 1)
  return noise()[(index(x) * SAMPLES + index(y)) * SAMPLES + index(z)] as number
}

/// Grey values, a byte a pixel, row by row. `place`: of a point of the cut in the valve's frame.
export function echoImage(
  sheets: Sheet[],
  thickness_mm: number,
  frame: Frame,
  place: (across_mm: number, depth_mm: number) => Vector,
  quality: Quality,
): Uint8ClampedArray {
  const { width, height, pixel_mm } = frame
  const probe = PROBES[quality]
  const scattered = reflectivity(sheets, thickness_mm, frame)
  for (let row = 0, i = 0; row < height; ++row)
    for (let column = 0; column < width; ++column, ++i)
      scattered[i] =
        (scattered[i] as number) * sampleAt(place(frame.left_mm + column * pixel_mm, frame.top_mm + row * pixel_mm))
  const lateral = spread(probe.lateral_mm / pixel_mm, () => 1)
  const phase = (k: number) => (2 * Math.PI * k * pixel_mm) / WAVE_MM
  const blurred = along(scattered, lateral, 1, width)
  const real = along(
    blurred,
    spread(probe.axial_mm / pixel_mm, (k) => Math.cos(phase(k))),
    width,
    height,
  )
  const imaginary = along(
    blurred,
    spread(probe.axial_mm / pixel_mm, (k) => Math.sin(phase(k))),
    width,
    height,
  )
  const grey = new Uint8ClampedArray(width * height)
  const floor = 10 ** (probe.noise_db / 20)
  for (let i = 0; i < grey.length; ++i) {
    const hiss = floor * sampleAt([i * SPACING_MM, 0, (i / SAMPLES) * SPACING_MM])
    const amplitude = Math.hypot((real[i] as number) + hiss, imaginary[i] as number)
    grey[i] = 255 * (1 + (20 * Math.log10(amplitude + 1e-9)) / RANGE_DB)
  }
  return grey
}

/// How strongly each pixel scatters: tissue within half its thickness of a sheet, else blood.
function reflectivity(sheets: Sheet[], thickness_mm: number, frame: Frame): Float32Array {
  const { left_mm, top_mm, pixel_mm, width, height } = frame
  const map = new Float32Array(width * height).fill(BLOOD)
  const half = thickness_mm / 2
  for (const { from, to } of sheets) {
    const [dx, dy] = [to[0] - from[0], to[1] - from[1]]
    const length = Math.hypot(dx, dy) || 1e-9
    const strength = ALONG_BEAM + (1 - ALONG_BEAM) * Math.abs(dx / length)
    const pixel = (mm: number, start: number, count: number) =>
      Math.min(Math.max(Math.round((mm - start) / pixel_mm), 0), count - 1)
    const rows = [Math.min(from[1], to[1]) - half, Math.max(from[1], to[1]) + half].map((y) => pixel(y, top_mm, height))
    const columns = [Math.min(from[0], to[0]) - half, Math.max(from[0], to[0]) + half].map((x) =>
      pixel(x, left_mm, width),
    )
    for (let row = rows[0] as number; row <= (rows[1] as number); ++row)
      for (let column = columns[0] as number; column <= (columns[1] as number); ++column) {
        const [px, py] = [left_mm + column * pixel_mm - from[0], top_mm + row * pixel_mm - from[1]]
        const share = Math.min(Math.max((px * dx + py * dy) / (length * length), 0), 1)
        if (Math.hypot(px - share * dx, py - share * dy) > half) continue
        const i = row * width + column
        map[i] = Math.max(map[i] as number, strength)
      }
  }
  return map
}

/// A Gaussian times a wave, of unit energy; its middle is the middle entry.
function spread(deviation_px: number, wave: (k: number) => number): number[] {
  const reach = Math.max(1, Math.ceil(REACH * deviation_px))
  const bell = Array.from({ length: 2 * reach + 1 }, (_, i) => Math.exp(-0.5 * ((i - reach) / deviation_px) ** 2))
  const energy = Math.sqrt(bell.reduce((sum, value) => sum + value * value, 0))
  return bell.map((value, i) => (value * wave(i - reach)) / energy)
}

/// Convolves along rows (`stride` 1, `count` columns) or columns (`stride` the width, `count` rows).
function along(values: Float32Array, kernel: number[], stride: number, count: number): Float32Array {
  const result = new Float32Array(values.length)
  const reach = (kernel.length - 1) / 2
  for (let i = 0; i < values.length; ++i) {
    const at = Math.floor(i / stride) % count
    let sum = 0
    for (let k = Math.max(-reach, -at); k <= Math.min(reach, count - 1 - at); ++k)
      sum += (kernel[k + reach] as number) * (values[i + k * stride] as number)
    result[i] = sum
  }
  return result
}
