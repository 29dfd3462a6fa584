import { expect, test } from 'vitest'
import {
  annulusPoint,
  at,
  boundaryEdges,
  chordaLines,
  closedNodes,
  leafletPlace,
  leafletPointAt,
  nodesAt,
  papillaryTip,
  seamLines,
  section,
  tieLines,
} from '../../src/viewer/geometry'
import { pyramid } from './scenes'

test('nodes are vertices, branch points and heads, in this order', () => {
  const nodes = closedNodes(pyramid())
  expect(nodes.length).toBe(3 * (5 + 1 + 2))
  expect(at(nodes, 5)).toEqual([-4, 0, -15])
  expect(at(nodes, 6)).toEqual([-8, 0, -20])
})

test('a chorda runs from its head over its branch point into its face', () => {
  const scene = pyramid()
  expect(chordaLines(scene, closedNodes(scene))).toEqual([-8, 0, -20, -4, 0, -15, -4, 0, -15, 0, 0, -10])
})

test('ties and seams lie in the faces that they name', () => {
  const scene = pyramid()
  const middle = { face: 0, weights: [0.5, 0.5, 0] as [number, number, number] }
  const tip = { face: 2, weights: [0, 0, 1] as [number, number, number] }
  scene.ties = [{ id: 'edge-to-edge-1-1', anterior: middle, posterior: tip, tension_n: 1 }]
  expect(tieLines(scene, closedNodes(scene))).toEqual([5, 5, 0, 0, 0, -10])
  scene.seams = [[middle, tip, middle]]
  expect(seamLines(scene, closedNodes(scene))).toEqual([5, 5, 0, 0, 0, -10, 0, 0, -10, 5, 5, 0])
})

test('the motion is followed linearly between its states, and ends where they end', () => {
  const scene = pyramid()
  const open = Array.from(closedNodes(scene), () => 0)
  scene.motion_mm = [open, open.map(() => 2), open.map(() => 6)]
  expect(nodesAt(scene, 0.25)[0]).toBeCloseTo(1)
  expect(nodesAt(scene, 0.75)[0]).toBeCloseTo(4)
  expect(nodesAt(scene, 1)[0]).toBe(6)
  expect(nodesAt(scene, 7)[0]).toBe(6)
})

test('before its unstressed state a beat follows the opening, and without one it stays there', () => {
  const scene = pyramid()
  const unstressed = Array.from(closedNodes(scene), () => 0)
  scene.motion_mm = [unstressed, unstressed.map(() => 6)]
  const { faces, annulus_mm, heads, chordae } = scene
  const opening = { faces, annulus_mm, heads, chordae, open_mm: null, leak: [] }
  const moving = { ...opening, motion_mm: [unstressed, unstressed.map(() => -1), unstressed.map(() => -4)] }
  expect([-1, -0.75, -0.5, 0, 0.5, 1].map((share) => nodesAt(scene, share, moving)[0])).toEqual([-4, -2.5, -1, 0, 3, 6])
  expect(nodesAt(scene, -1)[0]).toBe(0)
  expect(nodesAt(scene, -1, { ...opening, motion_mm: [] })[0]).toBe(0)
})

test('edges of one face alone are the boundary', () => {
  expect(boundaryEdges(pyramid().faces)).toEqual([
    [0, 1],
    [1, 2],
    [2, 3],
    [3, 0],
  ])
})

test('a plane cuts the faces it goes through, each in one piece', () => {
  const scene = pyramid()
  const pieces = section(scene, closedNodes(scene), [5, 0, 0], [1, 0, 0])
  expect(pieces.map((piece) => piece.face).sort()).toEqual([0, 3])
  for (const { from, to } of pieces) {
    expect(from[0]).toBeCloseTo(5)
    expect(to[0]).toBeCloseTo(5)
  }
  expect(section(scene, closedNodes(scene), [11, 0, 0], [1, 0, 0])).toEqual([])
})

test('leaflets are walked from the anterolateral commissure to the posteromedial one', () => {
  expect(leafletPlace(0.25)).toEqual({ leaflet: 'anterior', along: 0.5 })
  expect(leafletPlace(0.5)).toEqual({ leaflet: 'posterior', along: 0 })
  expect(leafletPlace(0.75)).toEqual({ leaflet: 'posterior', along: 0.5 })
  expect(leafletPlace(0.99).along).toBeCloseTo(0.98)
  expect(leafletPlace(1.25)).toEqual({ leaflet: 'anterior', along: 0.5 })
})

test('a point of a face has the mean of the places of its corners, also across the jump of the angle', () => {
  const scene = pyramid()
  expect(leafletPointAt(scene, 0, [0, 1, 0])).toEqual({ leaflet: 'anterior', along: 0.5, height: 0 })
  scene.leaflet_coordinates.around = [0, 0.25, 0.5, 0.75, 0.9]
  const point = leafletPointAt(scene, 3, [0.5, 0.5, 0]) // between mid-posterior (0.75) and the commissure (0)
  expect(point.leaflet).toBe('posterior')
  expect(point.along).toBeCloseTo(0.75)
})

test('a place on the annulus is found round the whole of it', () => {
  const scene = pyramid()
  expect(annulusPoint(scene, 0.125)).toEqual([5, 5, 0])
  expect(annulusPoint(scene, 0.25)).toEqual([0, 10, 0])
  expect(annulusPoint(scene, 0.875)).toEqual([5, -5, 0])
  expect(annulusPoint(scene, 0.99)[0]).toBeCloseTo(9.6)
})

test('the tip of a side is the mean of its heads', () => {
  const scene = pyramid()
  scene.heads.push({ id: 'AL2', side: 'anterolateral', rest_mm: [0, 0, 0], tip_mm: [-10, 4, -22] })
  expect(papillaryTip(scene, 'anterolateral')).toEqual([-9, 2, -21])
})
