import { expect, test } from 'vitest'
import { filesToImport, guessedRoles, placed } from '../../src/valve/parts'

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
  expect(await filesToImport(files, ['anterior', 'annulus'], 'mine', 500)).toEqual({
    name: 'mine',
    triangles: 500,
    leaflets: [{ name: 'a.stl', base64: 'AP8Q' }],
    annulus: { name: 'annulus.csv', text: '1,2,3' },
  })
})
