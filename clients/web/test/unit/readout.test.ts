import { expect, test } from 'vitest'
import { scaleOf } from '../../src/viewer/colours'
import type { Pick } from '../../src/viewer/pick'
import { reading } from '../../src/viewer/readout'
import { pyramid } from './scenes'

const scene = pyramid()
/// On face 0, a quarter of the way down from the annulus to the tip, which is 10 mm below.
const pick: Pick = {
  kind: 'leaflet',
  point: { leaflet: 'anterior', along: 0, height: 0.25 },
  point_mm: [7.5, 0, -2.5],
  face: 0,
  weights: [0.75, 0, 0.25],
}

test('a leaflet tells its height', () => {
  expect(reading(scene, scene.rest_mm, 'leaflets', null, pick)).toBe('A3: 2.5 mm below the annular plane')
})

test('a coloured leaflet tells the value of its colour', () => {
  const scale = scaleOf('strain_circumferential', [scene])
  // Both vertices have the means of their faces: 15 %.
  expect(reading(scene, scene.rest_mm, 'strain_circumferential', scale, pick)).toBe('A3: 15 %')
})

test('a chorda tells its highest tension', () => {
  const chorda: Pick = { kind: 'chorda', id: 'branching', point_mm: [0, 0, -10] }
  expect(reading(scene, scene.rest_mm, 'tension', null, chorda)).toBe('branching: 2.00 N')
})
