import { expect, test } from 'vitest'
import type { Plan, Scene, Step } from '../../src/api/types'
import { handlesOf } from '../../src/repair/handles'
import type { Drag } from '../../src/viewer/handles'
import { pyramid } from './scenes'

const RINGS = { rings: [], sizes_mm: { min: 24, max: 40, step: 2 } }
const still: Drag = { mmAlong: () => 0, around: () => 0, leaflet: () => null }

function repaired(): Scene {
  const scene = pyramid()
  scene.closure = { annulus: { al_pm_mm: 20 } } as Scene['closure']
  scene.sutures = [{ side: 'anterolateral', tip_mm: [-10, 0, -16], anchor_mm: [-10, 0, 0] }]
  scene.chordae.push({
    id: 'neochorda-1',
    kind: 'neochorda',
    head: 0,
    ruptured: false,
    segments: [{ parent: -1, end_mm: [0, 0, -10], tension_n: 1, face: 0, weights: [0, 0, 1] }],
  })
  return scene
}

function handles(...steps: Step[]) {
  const plan: Plan = { schema: 'coapt.plan/1', steps }
  return handlesOf(plan, { before: pyramid(), ringed: repaired() }, RINGS)
}

const suture: Step = {
  step: 'papillary_approximation',
  side: 'anterolateral',
  anchor: 'ipsilateral_trigone',
  suture_length_mm: 16,
}

test('a suture is grabbed at its tip: drawn 3 mm away from its anchor it is 3 mm longer', () => {
  const [length] = handles(suture)
  expect(length?.handle.at_mm).toEqual([-10, 0, -16])
  const dragged = length?.handle.dragged({ ...still, mmAlong: (_, [, , z]) => (z === -1 ? 3 : NaN) })
  expect(dragged).toEqual({ ...suture, suture_length_mm: 19 })
  expect(length?.handle.words(dragged as Step)).toBe('suture 19.0 mm')
  expect(length?.handle.stepped(0, -1)).toEqual({ ...suture, suture_length_mm: 15.5 })
})

test('no suture is longer than the way to its anchor', () => {
  const [length] = handles(suture)
  expect(length?.handle.dragged({ ...still, mmAlong: () => 50 })).toEqual({ ...suture, suture_length_mm: 20 })
})

test('its other end is tied to the place of the annulus that is nearest', () => {
  const [, anchor] = handles(suture)
  expect(anchor?.handle.value).toBe(180)
  expect(anchor?.handle.dragged({ ...still, around: () => 0.25 })).toMatchObject({
    anchor: 'annulus_point',
    annulus_around: 0.25,
  })
})

test('a ring whose handle is drawn inwards by a tenth is a tenth smaller', () => {
  const [own] = handles({ step: 'annuloplasty', shape: 'own', sizes_below: 2 })
  // 10 mm from the middle; 20 mm across.
  expect(own?.handle.dragged({ ...still, mmAlong: () => -1 })).toMatchObject({ sizes_below: 3 })
  const [named] = handles({ step: 'annuloplasty', shape: 'generic-classic', size_mm: 30 } as Step)
  expect(named?.handle.dragged({ ...still, mmAlong: () => -1 })).toMatchObject({ size_mm: 28 })
})

test('a neochorda is grabbed where it inserts and put where the pointer meets a leaflet', () => {
  const insertion = { leaflet: 'anterior', along: 0.5, height: 0.98 } as const
  const [only] = handles({ step: 'neochorda', head: 'AL1', insertion, length_mm: 20 })
  expect(only?.handle.at_mm).toEqual([0, 0, -10])
  expect(only?.handle.dragged(still)).toBeNull()
  const there = { leaflet: 'posterior', along: 0.123, height: 1 } as const
  expect(only?.handle.dragged({ ...still, leaflet: () => there })).toMatchObject({
    insertion: { ...there, along: 0.12 },
  })
  expect(only?.handle.stepped(1, 1)).toMatchObject({ insertion: { along: 0.51, height: 0.99 } })
})

test('what cannot be grabbed has no handle', () => {
  expect(handles({ step: 'chordal_excision', chorda: 'branching' })).toEqual([])
})
