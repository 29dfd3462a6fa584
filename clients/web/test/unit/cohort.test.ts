import { expect, test } from 'vitest'
import type { Closure, RankedPlan } from '../../src/api/types'
import { arranged, COLUMNS, type Column, newRow, type Row } from '../../src/cohort/rows'

const [byName, byDiagnosis, byLeak, byPlan, byProbability] = COLUMNS as unknown as [
  Column,
  Column,
  Column,
  Column,
  Column,
]
const closure = (leak_mm2: number, type: string | null, segments: object[] = []) =>
  ({
    leak_mm2,
    leak: { error_mm2: 1 },
    diagnosis: { competent: type === null, type, types: type ? [type] : [], type_sure: true, segments },
  }) as unknown as Closure
const row = (name: string, some: Partial<Row>): Row => ({ ...newRow(name, name), ...some })
const flail = row('flail', {
  closure: closure(96, 'II', [
    { name: 'P2', finding: 'flail' },
    { name: 'A1', finding: 'normal' },
  ]),
})
const sound = row('sound', { closure: closure(0.1, null) })
const waiting = row('waiting', {})
const wrong = row('wrong', { problem: 'must have chordae' })
const names = (rows: Row[]) => rows.map(({ name }) => name)

test('rows are ordered by any column, what is not known last both ways', () => {
  const rows = [waiting, flail, sound]
  expect(names(arranged(rows, byLeak, false, ''))).toEqual(['sound', 'flail', 'waiting'])
  expect(names(arranged(rows, byLeak, true, ''))).toEqual(['flail', 'sound', 'waiting'])
  expect(names(arranged(rows, byDiagnosis, false, ''))).toEqual(['sound', 'flail', 'waiting'])
  expect(names(arranged(rows, byProbability, false, ''))).toEqual(['waiting', 'flail', 'sound'])
})

test('a filter finds names and diagnoses', () => {
  const rows = [waiting, flail, sound, wrong]
  expect(names(arranged(rows, byName, false, 'type ii p2'))).toEqual(['flail'])
  expect(names(arranged(rows, byName, false, 'COMPETENT'))).toEqual(['sound'])
  expect(names(arranged(rows, byName, false, ''))).toEqual(['flail', 'sound', 'waiting', 'wrong'])
})

test('a row says what is known of it', () => {
  const words = (of: Row) => COLUMNS.map((column) => column.words(of))
  expect(words(flail)).toEqual(['flail', 'Type II: P2 flail', '96.0 ± 1.0', '', '', ''])
  expect(words(waiting)).toEqual(['waiting', '…', '…', '', '', ''])
  expect(words(wrong)).toEqual(['wrong', 'must have chordae', '', '', '', ''])
  const ring = { step: 'annuloplasty', shape: 'own', sizes_below: 2 } as const
  const plan = { plan: { schema: 'coapt.plan/1', steps: [ring] }, acceptable_probability: 0.97, durability_mm: 6.25 }
  const searched = { ...sound, plan: plan as unknown as RankedPlan }
  expect(words(searched).slice(3)).toEqual(["Ring in the annulus's own shape, undersized by 2 sizes", '97 %', '6.3'])
  expect(byPlan.words({ ...sound, isSearched: true })).toBe('searching …')
})
