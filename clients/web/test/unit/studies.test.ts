import { expect, test } from 'vitest'
import { distinct, mean, median, numberIn, parseCsv } from '../../src/studies/csv'
import { alone, largestByAxes, places, slice, spread } from '../../src/studies/displacements'
import { studyOf, type StudyChoices } from '../../src/studies/options'

test('a table is read by its header, with quoted cells and empty ones', () => {
  expect(parseCsv('a,b\n1,\n"x, ""y""",2\n')).toEqual([
    { a: '1', b: '' },
    { a: 'x, "y"', b: '2' },
  ])
  expect(parseCsv('a,b\r\n,\r\n')).toEqual([{ a: '', b: '' }])
  expect(parseCsv('')).toEqual([])
})

test('an empty cell is not zero', () => {
  expect(numberIn({ a: '' }, 'a')).toBeNull()
  expect(numberIn({ a: '0' }, 'a')).toBe(0)
  expect(numberIn({ a: 'word' }, 'a')).toBeNull()
  expect(numberIn({}, 'a')).toBeNull()
})

test('means, medians and spreads leave out what is not known', () => {
  expect(mean([1, null, 3])).toBe(2)
  expect(mean([null])).toBeNull()
  expect(median([5, 1, null, 3])).toBe(3)
  expect(median([4, 1])).toBe(2.5)
  expect(spread([2, null, 6, 1])).toEqual({ median: 2, low: 1, high: 6 })
})

// Two places along each axis; the orifice is 1 mm2 for transverse, 2 for posterior, 4 for apical displacement.
const grid = [0, 3].flatMap((transverse) =>
  [0, 3].flatMap((posterior) =>
    [0, 3].map((apical) => ({
      transverse_mm: String(transverse),
      posterior_mm: String(posterior),
      apical_mm: String(apical),
      orifice_mm2: String(transverse / 3 + (2 * posterior) / 3 + (4 * apical) / 3),
    })),
  ),
)

test('one axis alone is read off the grid in its order', () => {
  expect(places(grid, 'apical_mm')).toEqual([0, 3])
  expect(alone(grid, 'posterior_mm').map((row) => row.orifice_mm2)).toEqual(['0', '2'])
})

test('a slice has posterior displacements downwards from the largest, transverse ones across', () => {
  expect(slice(grid, 3, 'orifice_mm2')).toEqual([
    [6, 7],
    [4, 5],
  ])
})

test('the largest orifices come by displaced axes', () => {
  expect(largestByAxes(grid)).toEqual([1, 2, 4, 3, 5, 6, 7])
})

test('a study says only what differs from its defaults', () => {
  const usual: StudyChoices = {
    name: 'approximation',
    protocols: ['lookup-extended', 'lookup-clamped'],
    displacement_step_mm: 1,
    region_points: null,
    scan_sites: null,
  }
  expect(studyOf(usual)).toEqual({ name: 'approximation' })
  expect(studyOf({ ...usual, name: 'ring', region_points: 65 })).toEqual({ name: 'ring' })
  expect(
    studyOf({ ...usual, protocols: ['closed'], displacement_step_mm: 6, region_points: 65, scan_sites: 0 }),
  ).toEqual({
    name: 'approximation',
    protocols: ['closed'],
    displacement_step_mm: 6,
    region_points: 65,
    scan_sites: 0,
  })
})

test('the values of a column are told once', () => {
  expect(distinct([{ a: 'x' }, { a: 'y' }, { a: 'x' }], 'a')).toEqual(['x', 'y'])
})
