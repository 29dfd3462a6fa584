import { expect, test } from 'vitest'
import { filesToImport, guessedRoles, type ImportSettings, placed } from '../../src/valve/parts'
import { given } from '../../src/valve/corrections'
import { readPlace, writePlace } from '../../src/valve/landmark_places'
import { inputFrame, intoFile, intoView } from '../../src/viewer/input_frame'
import type { FileLookedAt, Vector } from '../../src/api/types'

const SETTINGS: ImportSettings = {
  name: 'mine',
  triangles: 500,
  labels: [],
  units: null,
  closed: null,
  trusts: false,
  flips: false,
  mirrored: false,
  seed: null,
  places: {},
  fit: null,
}

test('files are what their names say', () => {
  expect(guessedRoles(['Anterior.STL', 'posterior.stl', 'annulus.csv', 'chordae.csv', 'notes.txt'])).toEqual([
    'anterior',
    'posterior',
    'annulus',
    'chordae',
    'none',
  ])
  expect(guessedRoles(['skirt.obj', 'Annulus.mrk.json', 'chords.json'])).toEqual(['anterior', 'annulus', 'chordae'])
})

test('voxels go beside the header of a label map that they belong to', async () => {
  expect(guessedRoles(['map.mhd', 'map.raw'])).toEqual(['labels', 'voxels'])
  expect(guessedRoles(['map.raw.gz', 'map.nhdr', 'ring.csv'], [null, null, 'curve'])).toEqual([
    'voxels',
    'labels',
    'annulus',
  ])
  expect(guessedRoles(['map.nii.gz'])).toEqual(['labels'])
  const files = [new File(['NDims'], 'map.mhd'), new File([new Uint8Array([0, 255, 16])], 'map.raw')]
  expect(await filesToImport(files, ['labels', 'voxels'], SETTINGS)).toEqual({
    name: 'mine',
    triangles: 500,
    labels: { name: 'map.mhd', base64: 'TkRpbXM=' },
    voxels: { name: 'map.raw', base64: 'AP8Q' },
  })
})

test('meshes with lists of markups are a folder of SlicerHeart', () => {
  const names = ['anterior.vtk', 'posterior.vtk', 'chords.vtk', 'annulus.mrk.json', 'papillary.mrk.json']
  expect(new Set(guessedRoles(names))).toEqual(new Set(['folder']))
})

test('the anterior leaflet is the first, whatever the order of the files', () => {
  const places = placed(['p.stl', 'a.stl', 'ring.csv', 'x'], ['posterior', 'anterior', 'annulus', 'none'])
  expect([...places]).toEqual([
    ['/leaflets/0', 'a.stl'],
    ['/leaflets/1', 'p.stl'],
    ['/annulus', 'ring.csv'],
  ])
})

test('binary formats travel as base64, others as text', async () => {
  const files = [new File([new Uint8Array([0, 255, 16])], 'a.stl'), new File(['1,2,3'], 'annulus.csv')]
  expect(await filesToImport(files, ['anterior', 'annulus'], SETTINGS)).toEqual({
    name: 'mine',
    triangles: 500,
    leaflets: [{ name: 'a.stl', base64: 'AP8Q' }],
    annulus: { name: 'annulus.csv', text: '1,2,3' },
  })
})

test('what a name does not say is told by what is in the file', () => {
  expect(guessedRoles(['a.csv', 'b.csv', 'c.json', 'd.stl'], ['curve', 'chordae', 'tips', 'surface'])).toEqual([
    'annulus',
    'chordae',
    'tips',
    'anterior',
  ])
  expect(guessedRoles(['anterior.stl', 'posterior.stl', 'systole.stl'])).toEqual(['anterior', 'posterior', 'surface'])
})

test('landmarks, drawn chordae and a fit go along', async () => {
  const files = ['anterior.obj', 'ring.csv', 'closed.obj'].map((name) => new File([name], name))
  const request = await filesToImport(files, ['anterior', 'annulus', 'surface'], {
    ...SETTINGS,
    units: 'cm',
    closed: true,
    seed: 3,
    places: { saddle_peak: [0, 1, 2], tip_al: [-1, 0, -2], tip_pm: [1, 0, -2] },
    fit: { leak_mm2: 30, side: 'middle' },
  })
  expect(request).toEqual({
    name: 'mine',
    triangles: 500,
    units: 'cm',
    closed: true,
    chordae_seed: 3,
    leaflets: [{ name: 'anterior.obj', text: 'anterior.obj' }],
    annulus: { name: 'ring.csv', text: 'ring.csv' },
    landmarks: { saddle_peak: [0, 1, 2] },
    tips: { name: 'tips.csv', text: 'AL,-1,0,-2\nPM,1,0,-2\n' },
    fit: { side: 'middle', surface: { name: 'closed.obj', text: 'closed.obj' }, leak_mm2: 30 },
  })
  const one = { ...SETTINGS, seed: 3, places: { tip_al: [-1, 0, -2] as Vector } }
  expect((await filesToImport(files, ['anterior', 'annulus', 'none'], one)).tips).toBeUndefined()
})

test('a place is three numbers', () => {
  expect(readPlace('1.5, -2;3')).toEqual([1.5, -2, 3])
  expect(readPlace('1 2 3')).toEqual([1, 2, 3])
  for (const text of ['', '1, 2', '1, 2, x', '1, 2, 3, 4']) expect(readPlace(text)).toBeNull()
  expect(writePlace([1.234567, 0, -20])).toBe('1.2346, 0, -20')
  expect(writePlace(undefined)).toBe('')
})

/// A square annulus across x in the files' frame, its tips at greater x: the atrium is at smaller x.
const looked = (content: FileLookedAt['content'], points: number[]): FileLookedAt => ({
  ...{ name: content, content, points, faces: [], labels: [], parts: [], problems: [] },
})

test('files are looked at as a valve is: the atrium above, the anterior leaflet in front', () => {
  const frame = inputFrame([
    { file: looked('curve', [5, 1, 1, 5, -1, 1, 5, -1, -1, 5, 1, -1]), role: 'annulus' },
    { file: looked('tips', [9, 0, 1, 9, 0, -1]), role: 'tips' },
    { file: looked('surface', [6, 0, 1]), role: 'anterior' },
    { file: looked('surface', [6, 0, -1]), role: 'posterior' },
  ])
  if (!frame) throw new Error('no frame')
  const { origin, axes, scale } = frame
  expect(origin).toEqual([5, 0, 0])
  expect(axes[2].map((one) => Math.round(one) + 0)).toEqual([-1, 0, 0])
  expect(axes[1].map((one) => Math.round(one) + 0)).toEqual([0, 0, 1])
  const point: Vector = [7, 2, -3]
  const back = intoFile(frame, intoView(frame, point))
  for (const k of [0, 1, 2] as const) expect(back[k]).toBeCloseTo(point[k], 9)
  expect(Math.hypot(...intoView(frame, [9, 0, 1]))).toBeCloseTo(scale * Math.hypot(4, 1), 9)
  expect(inputFrame([])).toBeNull()
})

test('what a person says of a label map goes along', async () => {
  const labels = [
    { number: 1, part: 'posterior' as const },
    { number: 2, part: 'anterior' as const },
    { number: 3, part: null },
    { number: 4, part: 'posterior' as const },
  ]
  const asked = await filesToImport([], [], { ...SETTINGS, labels, closed: false, flips: true, trusts: true })
  expect(asked).toEqual({
    name: 'mine',
    triangles: 500,
    label_numbers: { anterior: [2], posterior: [1, 4] },
    closed: false,
    flip: true,
    trust_labels: true,
  })
})

test('a label takes the part of another one in exchange', () => {
  const labels = [
    { number: 1, part: 'anterior' as const },
    { number: 2, part: 'posterior' as const },
    { number: 3, part: null },
  ]
  expect(given(labels, 1, 'posterior').map(({ part }) => part)).toEqual(['posterior', 'anterior', null])
  expect(given(labels, 3, 'posterior').map(({ part }) => part)).toEqual(['anterior', 'posterior', 'posterior'])
  expect(given(labels, 2, null).map(({ part }) => part)).toEqual(['anterior', null, null])
})
