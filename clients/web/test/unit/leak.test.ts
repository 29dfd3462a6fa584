import { describe, expect, it, test } from 'vitest'
import type { Leak, Opening, Scene, Vector } from '../../src/api/types'
import { cornerColours, scaleOf, vertexValues } from '../../src/viewer/colours'
import { boundaryEdges, closedLine } from '../../src/viewer/geometry'
import { gapWidths } from '../../src/viewer/gap_width'
import { leakLabels, openingLabels } from '../../src/viewer/leak'
import { outwards, thickSheet, vertexNormals } from '../../src/viewer/thick_sheet'
import { pyramid } from './scenes'

/// Openings of these areas, the first one at [1, 2, 3], the next at [2, 2, 3].
function openings(...areas: number[]): Leak['openings'] {
  const at = (i: number): Vector => [1 + i, 2, 3]
  const seen = { normal: [0, 0, 1] as Vector, segments: [], width_mm: 1, outline_mm: [] }
  return areas.map((area_mm2, i) => ({ area_mm2, centroid_mm: at(i), ...seen }))
}

describe('the words of a leak', () => {
  it('stand at each opening, with the digits that are known, but for the least', () => {
    const leak = { area_mm2: 47, error_mm2: 5, between_mm2: null, openings: openings(46.4, 0.5, 0.4) }
    const scene = { ...pyramid(), closure: { leak } as unknown as Scene['closure'] }
    expect(leakLabels(scene)).toEqual([
      { point_mm: [1, 2, 3], text: '46 mm²', kind: 'leak' },
      { point_mm: [2, 2, 3], text: '1 mm²', kind: 'leak' },
    ])
  })

  it('are in cm² of a valve that stands open', () => {
    const leak = { area_mm2: 280, error_mm2: null, between_mm2: null, openings: openings(160, 120, 4) }
    expect(openingLabels({ leak } as unknown as Opening).map(({ text }) => text)).toEqual(['1.6 cm²', '1.2 cm²'])
  })
})

test('an outline ends where it begins', () => {
  const line = closedLine([
    [0, 0, -5],
    [10, 0, -5],
    [10, 10, -5],
  ])
  expect(line.length).toBe(3 * 6)
  expect(line.slice(-6)).toEqual([10, 10, -5, 0, 0, -5])
})

describe('leaflets, including their thickness', () => {
  it('have two sides of each face and a round edge in four strips', () => {
    const { source, ups, outs } = thickSheet(pyramid())
    expect(source.length).toBe(2 * 12 + 4 * 4 * 6) // the annulus; the pyramid has no free edge
    expect([...ups.slice(0, 24)]).toEqual([...Array(12).fill(1), ...Array(12).fill(-1)])
    expect(new Set(source.slice(24)).size).toBe(8)
    expect(Math.max(...outs)).toBe(1)
  })

  it('reach out as far at a corner as beside it', () => {
    const { faces, rest_mm } = pyramid()
    const upwards = Float32Array.from({ length: 15 }, (_, i) => (i % 3 === 2 ? 1 : 0))
    const away = outwards(boundaryEdges(faces), rest_mm, upwards)
    expect(away[0]).toBeCloseTo(Math.SQRT2) // a square's corner
    expect([...away.slice(12)]).toEqual([0, 0, 0])
  })

  it('are moved along normals as long as 1', () => {
    const { faces, rest_mm } = pyramid()
    const normals = vertexNormals(faces, rest_mm, 5)
    expect([...normals.slice(12)].map((part) => Math.round(1e6 * part) / 1e6 + 0)).toEqual([0, 0, 1])
    expect(Math.hypot(...normals.slice(0, 3))).toBeCloseTo(1)
  })
})

describe('colours of strain', () => {
  it('run smoothly over vertices', () => {
    const scene = pyramid()
    expect(vertexValues(scene, 'strain_circumferential', scene.rest_mm)?.map(Math.round)).toEqual([15, 5, 15, 25, 15])
    const scale = scaleOf('strain_circumferential', [scene])
    const colours = cornerColours(scene, 'strain_circumferential', scale, scene.rest_mm)
    expect([...colours.slice(6, 9)]).toEqual([...colours.slice(15, 18)]) // the tip, in two faces
  })
})

test('a slit is as wide as its lips are apart, all across; a wedge is wider at its wide end', () => {
  const strip = (half: (x: number) => number) => {
    const [across, along] = [9, 41]
    const points_mm = Array.from({ length: across * along }, (_, i) => {
      const x = 0.25 * Math.floor(i / across)
      return [x, half(x) * (((i % across) - 4) / 4), 0]
    }).flat()
    const faces = Array.from({ length: (across - 1) * (along - 1) }, (_, i) => {
      const a = Math.floor(i / (across - 1)) * across + (i % (across - 1))
      return [a, a + 1, a + across, a + 1, a + across + 1, a + across]
    }).flat()
    return gapWidths({ area_mm2: 0, points_mm, faces, outline: [] })
  }
  const slit = strip(() => 1)
  for (const i of [0, 4, 8]) expect(slit[20 * 9 + i]).toBeCloseTo(2) // from lip to lip
  const wedge = strip((x) => 0.2 + 0.1 * x)
  expect(wedge[4 * 9 + 4]).toBeLessThan(wedge[34 * 9 + 4] as number)
})
