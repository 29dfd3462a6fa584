import { expect, test } from 'vitest'
import { knownDigits, withError } from '../../src/format'

test('an area has the digits that are known', () => {
  expect(withError(45.678, 2.13, 'mm²')).toBe('45.7 ± 2.1 mm²')
  expect(withError(45.678, 5.2, 'mm²')).toBe('46 ± 5 mm²')
  expect(withError(45.678, 0.97, 'mm²')).toBe('45.7 ± 1.0 mm²')
  expect(withError(45.678, 0.36, 'mm²')).toBe('45.7 ± 0.4 mm²')
  expect(withError(-0.01, 0.5, 'mm²')).toBe('0.0 ± 0.5 mm²')
  expect(knownDigits(45.678, 5.2)).toBe('46')
})
test('an area has one place where no error is known', () => {
  expect(withError(45.678, null, 'mm²')).toBe('45.7 mm²')
  expect(withError(null, 1, 'mm²')).toBe(withError(null, null, 'mm²'))
})
