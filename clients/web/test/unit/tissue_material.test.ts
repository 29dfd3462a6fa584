import { expect, test } from 'vitest'
import { TissueMaterial } from '../../src/viewer/tissue_material'
import { pyramid } from './scenes'

test('light comes through the disc that fits into the annulus', () => {
  const tissue = new TissueMaterial()
  tissue.set(pyramid())
  expect(tissue.occlusion.annulusRadius.value).toBe(10)
  expect(tissue.occlusion.annulusNormal.value.toArray()).toEqual([0, 0, 1])
})

test('where colours mean numbers there is no highlight and no darkening', () => {
  const tissue = new TissueMaterial()
  tissue.wet(false)
  expect(tissue.specular.getHex()).toBe(0)
  expect(tissue.occlusion.occluded.value).toBe(0)
  tissue.wet(true)
  expect(tissue.specular.getHex()).not.toBe(0)
  expect(tissue.occlusion.occluded.value).toBeGreaterThan(0)
})
