import { expect, test } from 'vitest'
import { anteriorFile, type DecisionControl, given, takeControl } from '../../src/valve/corrections'
import { ACCEPTED, COMPANIONS, isImportable, LABEL_MAPS, MESHES, TABLES } from '../../src/valve/formats'
import { readGrid } from '../../src/valve/import_form'
import {
  filesToImport,
  firstRoles,
  guessedRoles,
  type ImportSettings,
  placed,
  statedRoles,
} from '../../src/valve/parts'
import { readPlace, writePlace } from '../../src/valve/landmark_places'
import { inputFrame, intoFile, intoView } from '../../src/viewer/input_frame'
import type { FileLookedAt, Vector } from '../../src/api/types'
import fileRoles from '../../../../io/exchange/file_roles.cpp?raw'
import labelMaps from '../../../../io/image/label_map.cpp?raw'
import tables from '../../../../io/mesh/csv_table.cpp?raw'

const SETTINGS: ImportSettings = {
  name: 'mine',
  provenance: [],
  triangles: 500,
  labels: [],
  phase: null,
  grid: null,
  axes: null,
  units: null,
  closed: null,
  hidden_mm: null,
  inVivo: false,
  thickness: null,
  branches: null,
  branch_at: null,
  slack: null,
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
    labels: { name: 'map.mhd', text: 'NDims' },
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

test('what is no text travels as base64', async () => {
  const files = [new File([new Uint8Array([0, 255, 16])], 'a.stl'), new File(['1,2,3'], 'annulus.csv')]
  expect(await filesToImport(files, ['anterior', 'annulus'], SETTINGS)).toEqual({
    name: 'mine',
    triangles: 500,
    leaflets: [{ name: 'a.stl', base64: 'AP8Q' }],
    annulus: { name: 'annulus.csv', text: '1,2,3' },
  })
})

test('the formats are those of the service', () => {
  const quoted = (text: string | undefined): string[] =>
    [...(text ?? '').matchAll(/"(\w+)"/g)].map(([, word]) => word ?? '')
  const after = (text: string, start: string, end: string): string => text.split(start)[1]?.split(end)[0] ?? ''
  expect(MESHES).toEqual(quoted(after(fileRoles, 'kMeshFormats =', ';')))
  expect(COMPANIONS).toEqual(quoted(after(fileRoles, 'bool is_companion_format(', '}')))
  expect(TABLES).toEqual(quoted(after(tables, 'kFormats =', ';')))
  expect(LABEL_MAPS).toEqual(quoted(after(labelMaps, 'bool is_label_map_format(', '}')))
  for (const name of ['map.nii.gz', 'A.VTP', 'ring.fcsv', 'all.vtm', 'x.mrk.json'])
    expect(isImportable(name)).toBe(true)
  for (const name of ['LICENSE.txt', '.hidden.csv', 'scan.dcm', 'heart.inp']) expect(isImportable(name)).toBe(false)
  expect(ACCEPTED.split(',')).toContain('.bz2')
})

test('what is dropped is sorted by the service, but for folders, fits and what a person says', async () => {
  const names = ['P1.stl', 'P2.stl', 'AML.stl', 'ring.csv', 'closed.stl', 'photo.png']
  const guesses = guessedRoles(names, [null, null, null, 'curve', null, null])
  expect(guesses).toEqual(['posterior', 'posterior', 'anterior', 'annulus', 'surface', 'none'])
  const roles = firstRoles(guesses)
  expect(roles).toEqual(['detected', 'detected', 'detected', 'detected', 'surface', 'none'])
  const files = names.map((name) => new File([name], name))
  const request = await filesToImport(files, roles, { ...SETTINGS, seed: 1 }, guesses)
  expect(request.files?.map(({ name }) => name)).toEqual(['P1.stl', 'P2.stl', 'AML.stl', 'ring.csv'])
  expect(request.leaflets).toBeUndefined()
})

test('with one leaflet stated the other one is stated, too', async () => {
  const guesses = guessedRoles(['x.obj', 'y.obj', 'ring.csv'], ['surface', 'surface', 'curve'])
  const roles = statedRoles(['detected', 'posterior', 'detected'], guesses)
  expect(roles).toEqual(['anterior', 'posterior', 'detected'])
  expect([...placed(['x', 'y', 'ring'], roles).keys()]).toEqual(['/files/0', '/leaflets/0', '/leaflets/1'])
  expect(statedRoles(['labels', 'detected'], ['labels', 'voxels'])).toEqual(['labels', 'voxels'])
})

test('everything that a person may say goes along', async () => {
  const said: ImportSettings = {
    ...SETTINGS,
    provenance: ['A phantom.'],
    phase: 2,
    grid: readGrid('{"size": [4, 4, 4], "to_lps_mm": [[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0]]}'),
    axes: 'RAS',
    hidden_mm: 2.5,
    inVivo: true,
    thickness: 'measured',
    branches: 2,
    branch_at: 0.5,
    slack: 1.1,
  }
  expect(await filesToImport([], [], said)).toEqual({
    ...{ name: 'mine', triangles: 500, provenance: ['A phantom.'], phase: 2, frame: 'RAS', hidden_mm: 2.5 },
    ...{ reference: 'in_vivo', thickness_measured: true, branches: 2, branch_at: 0.5, slack: 1.1 },
    grid: {
      size: [4, 4, 4],
      to_lps_mm: [
        [1, 0, 0, 0],
        [0, 1, 0, 0],
        [0, 0, 1, 0],
      ],
    },
  })
  expect((await filesToImport([], [], { ...SETTINGS, thickness: 1.5 })).thickness_mm).toBe(1.5)
  const points = await filesToImport([new File(['label,x,y,z'], 'seen.csv')], ['landmarks'], SETTINGS)
  expect(points.landmarks).toEqual({ name: 'seen.csv', text: 'label,x,y,z' })
  for (const text of ['', '4', '{"size": [4, 4]}', 'null']) expect(readGrid(text)).toBeNull()
})

test('the file that was taken for the anterior leaflet is known by the decision', () => {
  const decision = (value: string) => ({ subject: 'leaflets', value, reason: '', look: true, confidence: 1 })
  expect(anteriorFile({ decisions: [decision('file 2 is the anterior leaflet, file 1 the posterior one')] })).toBe(1)
  expect(anteriorFile({ decisions: [decision('label 1 is the anterior leaflet, label 2 the posterior one')] })).toBe(-1)
})

test('a control stands at the decision that it changes', () => {
  const control = (subject: string, about?: RegExp): DecisionControl => ({
    subject,
    ...(about && { about }),
    element: {} as HTMLElement,
  })
  const [tissue, state] = [control('state', /stress-free/), control('state')]
  const left = [tissue, state]
  expect(takeControl({ subject: 'frame', value: 'moved by 1 mm' }, left)).toBeUndefined()
  expect(takeControl({ subject: 'state', value: 'imaged open' }, left)).toBe(state)
  expect(takeControl({ subject: 'state', value: 'imaged open' }, left)).toBeUndefined()
  expect(takeControl({ subject: 'state', value: 'the imaged state is interpreted as stress-free' }, left)).toBe(tissue)
  expect(left).toEqual([])
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
