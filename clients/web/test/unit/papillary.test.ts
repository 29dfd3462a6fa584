import { expect, test } from 'vitest'
import { closedNodes, distance, tipsOf } from '../../src/viewer/geometry'
import { muscleEnds, PapillaryMuscles } from '../../src/viewer/papillary'
import { pyramid } from './scenes'

test('a muscle ends below its tip, away from the annulus, and the other one where a mirror has it', () => {
  const scene = pyramid()
  const tips = tipsOf(scene, closedNodes(scene))
  const [left, right] = muscleEnds(scene, tips)
  expect(tips[0]).toEqual([-8, 0, -20])
  expect(left?.[0]).toBeLessThan(-8)
  expect(left?.[2]).toBeLessThan(-20)
  expect(right?.[0]).toBeCloseTo(-(left?.[0] ?? 0))
  expect(distance(tips[0] ?? [0, 0, 0], left ?? [0, 0, 0])).toBeCloseTo(8)
})

test('the heads of a side meet at one end, below the middle of their tips', () => {
  const scene = pyramid()
  const [first] = scene.heads
  if (first) scene.heads.splice(1, 0, { ...first, id: 'AL2', tip_mm: [-8, 4, -20] })
  const [one, two] = muscleEnds(scene, tipsOf(scene, closedNodes(scene)))
  expect(one).toEqual(two)
  expect(one?.[1]).toBeGreaterThan(2)
})

test('heads are drawn from the tips as they are in the state, and none where no tips are', () => {
  const scene = pyramid()
  const muscles = new PapillaryMuscles()
  const nodes = closedNodes(scene)
  muscles.set(scene, nodes)
  const { position } = muscles.mesh.geometry.attributes
  expect([position?.getX(0), position?.getZ(0)]).toEqual([-8, -20])
  nodes[nodes.length - 6] = -9
  muscles.set(scene, nodes)
  expect(muscles.mesh.geometry.attributes.position?.getX(0)).toBe(-9)
  muscles.set({ ...scene, heads: [] }, nodes)
  expect(muscles.mesh.geometry.index?.count).toBe(0)
})
