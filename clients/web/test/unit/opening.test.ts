import { describe, expect, it } from 'vitest'
import { cornerColours, scaleOf, vertexValues } from '../../src/viewer/colours'
import { boundaryEdges } from '../../src/viewer/geometry'
import { hiddenMembranes, type Membrane, orificeMembranes, skirt } from '../../src/viewer/opening'
import { outwards, thickSheet, vertexNormals } from '../../src/viewer/thick_sheet'
import { pyramid } from './scenes'

type Place = ReturnType<typeof pyramid>['gap'][number]

/// At x, leaflets `width` apart along y, 5 mm below the plane.
function apart(x: number, width: number): Place {
  return { anterior_mm: [x, width / 2, -5], posterior_mm: [x, -width / 2, -5], width_mm: Math.max(0, width - 1) }
}

function area({ points, triangles }: Membrane): number {
  let sum = 0
  for (let i = 0; i < triangles.length; i += 3) {
    const [a, b, c] = triangles.slice(i, i + 3).map((vertex) => points.slice(3 * vertex, 3 * vertex + 3)) as number[][]
    const u = b?.map((part, k) => part - (a?.[k] as number)) as [number, number, number]
    const v = c?.map((part, k) => part - (a?.[k] as number)) as [number, number, number]
    sum += 0.5 * Math.hypot(u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0])
  }
  return sum
}

describe('the opening', () => {
  it('spans two parallel edges over their length', () => {
    const scene = { ...pyramid(), gap: [apart(-2, 3), apart(0, 3), apart(2, 3)] }
    const [membrane, ...others] = hiddenMembranes(scene)
    expect(others).toEqual([])
    expect(area(membrane as Membrane)).toBeCloseTo(4 * 3)
  })

  it('ends where the leaflets touch', () => {
    const scene = { ...pyramid(), gap: [apart(-4, 3), apart(-2, 3), apart(0, 0.5), apart(2, 2), apart(4, 2)] }
    expect(hiddenMembranes(scene).map(area)).toEqual([6, 4])
  })

  it('is the orifice itself where the atrial view shows it, as high as its outline', () => {
    const outline = [-5, -20, -3, 5, -20, -3, 5, 20, -33, -5, 20, -33]
    const scene = {
      ...pyramid(),
      gap: [apart(-2, 3), apart(0, 3), apart(2, 3)],
      orifices: [{ area_mm2: 400, contours_mm: [outline] }],
    }
    expect(hiddenMembranes(scene)).toEqual([])
    const [membrane] = orificeMembranes(scene)
    expect(area(membrane as Membrane)).toBeCloseTo(10 * 50) // 40 mm across, 30 mm deep
    expect(membrane?.label?.text).toBe('400.0 mm²')
    expect(membrane?.label?.point_mm[2]).toBeCloseTo(-18)
  })

  it('is level where folds of the edge lie above each other', () => {
    const outline = [-20, 0, -2, -20, 0, -4, 20, -20, -3, 20, 20, -3]
    const [membrane] = orificeMembranes({ ...pyramid(), orifices: [{ area_mm2: 800, contours_mm: [outline] }] })
    expect(membrane?.points).toEqual([-20, 0, -3, -20, 0, -3, 20, -20, -3, 20, 20, -3])
  })

  it('reaches half of the thickness into the tissue beside it', () => {
    const scene = { ...pyramid(), gap: [apart(-2, 3), apart(0, 3), apart(2, 3)] }
    const [membrane] = hiddenMembranes(scene)
    expect(area(skirt(scene, membrane as Membrane))).toBeCloseTo(5 * 4 - 4 * 3)
  })

  it('is nothing of a valve that is closed', () => {
    expect([...orificeMembranes(pyramid()), ...hiddenMembranes(pyramid())]).toEqual([])
  })
})

describe('leaflets with their thickness', () => {
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
