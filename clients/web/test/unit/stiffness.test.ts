import { expect, test } from 'vitest'
import type { Scene } from '../../src/api/types'
import { breathing, spreadWords, stiffnessAt, variantWords, type Variant } from '../../src/valve/stiffness'
import { nodesAt } from '../../src/viewer/geometry'
import { pyramid } from './scenes'

function variant(factor: number, leak_mm2: number, low_mm: number): Variant {
  const scene = pyramid()
  const closed_mm = scene.rest_mm.map((value, i) => (i === 14 ? low_mm : value))
  return { factor, scene: { ...scene, closed_mm, closure: { leak: { area_mm2: leak_mm2 } } as Scene['closure'] } }
}
const variants = [variant(0.5, 20.4, -10), variant(1, 40, -12), variant(3, 80, -18)]

test('the half of the draws that is softer and the half that is stiffer meet at the own stiffness', () => {
  expect([0, 0.5, 1].map(stiffnessAt)).toEqual([0.5, 1, 3])
  expect(stiffnessAt(0.25)).toBeCloseTo(Math.sqrt(0.5))
})

test('the valve breathes through the closed shapes of all variants', () => {
  const whole = breathing(variants)
  expect([0, 0.25, 0.5, 1].map((share) => nodesAt(whole, share)[14])).toEqual([-10, -11, -12, -18])
})

test('a variant and the spread are told in words', () => {
  expect(variants.map(variantWords)).toEqual([
    'Leaflets 0.5 times as stiff: leak 20 mm²',
    'Leaflets as stiff as in the file: leak 40 mm²',
    'Leaflets 3.0 times as stiff: leak 80 mm²',
  ])
  expect(spreadWords(variants, null)).toBe('The stiffness of the leaflets alone changes the leak from 20 to 80 mm².')
  expect(spreadWords(variants, [15, 90])).toContain('leaves it at 15 to 90 mm² (5 to 95 %)')
})
