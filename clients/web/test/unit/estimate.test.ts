import { expect, test } from 'vitest'
import type { Estimate } from '../../src/api/types'
import { estimateWords, leakEstimate, leakInFull, leakInShort } from '../../src/estimate'

const said = (estimate: Estimate) => Object.values(estimateWords(estimate)).join(' | ')

test('an estimate is said by its widest part, in the words of the command line', () => {
  // The same in tests/core/metrics/estimate_test.cpp.
  const leak: Estimate = { value: 0.3, numerical: null, tissue: null, execution: null }
  expect(said(leak)).toBe('0.3 |  | ')
  leak.numerical = [0, 1.4]
  expect(said(leak)).toBe('0.3 ± 1.1 |  | ± numerical error')
  leak.numerical = [0.4, 1.5]
  expect(said(leak)).toBe('0.3 | 0.4 to 1.5 | with numerical error (5 to 95 %)')
  leak.tissue = [0.1, 3.5]
  expect(said(leak)).toBe('0.3 | 0.1 to 3.5 | with tissue error (5 to 95 %)')
  leak.execution = [0, 14.2]
  expect(said(leak)).toBe('0 | 0 to 14 | with errors of execution (5 to 95 %)')
  const close: Estimate = { value: 0.31, numerical: null, tissue: [0.13, 0.44], execution: null }
  expect(said(close)).toBe('0.3 | 0.1 to 0.4 | with tissue error (5 to 95 %)')
})

test('tissue that excludes the value takes its place', () => {
  const leak: Estimate = { value: 58, numerical: [52, 64], tissue: [21.2, 37.4], execution: null }
  expect(said(leak)).toBe('21 to 37 | 58 | with the tissue of its file')
  expect(leakInFull(leak)).toBe('21 to 37 mm²; 58 mm² with the tissue of its file')
  expect(leakInShort(leak)).toBe('21 to 37 mm²')
  expect(said({ ...leak, tissue: [21.2, 53] })).toBe('58 | 21 to 53 | with tissue error (5 to 95 %)')
})

test('a leak without intervals has that of its numerical error, which does not reach below zero', () => {
  const leak = leakEstimate({ leak_mm2: 0.3, leak: { area_mm2: 0.3, error_mm2: 1.1 } })
  expect(leak.numerical).toEqual([0, 1.4000000000000001])
  expect(leakInFull(leak)).toBe('0.3 ± 1.1 mm² (numerical error; tissue error not known)')
  expect(leakInFull(leakEstimate({ leak_mm2: 12 }))).toBe('12.0 mm²')
  expect(leakInFull(leakEstimate({ leak_mm2: null }))).toBe('unknown')
})
