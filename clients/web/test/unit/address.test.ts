import { expect, test } from 'vitest'
import type { Step } from '../../src/api/types'
import { readAddress, writeAddress } from '../../src/state/address'

const steps: Step[] = [{ step: 'annuloplasty', shape: 'own', sizes_below: 2 }]

test('what is written into an address is read from it', () => {
  const shown = {
    view: 'repair',
    valve: 'größe?&#',
    steps,
    job: 'a/b',
    story: { reference: '~a_b', slide: 2 },
  } as const
  expect(readAddress(writeAddress({ ...shown, steps }))).toEqual({ ...shown, faults: [] })
})

test('a plan without steps is not written', () => {
  expect(writeAddress({ view: 'valve', valve: 'a', steps: [], job: null, story: null })).toBe('#/valve?valve=a')
})

test('an address without a view is that of the valve', () => {
  expect(readAddress('')).toMatchObject({ view: 'valve', valve: null, steps: null, job: null, story: null, faults: [] })
  expect(readAddress('#repair')).toMatchObject({ view: 'repair', faults: [] })
})

test('what cannot be read is said', () => {
  expect(readAddress('#/somewhere').faults).toEqual(['There is no view named “somewhere”.'])
  for (const plan of ['%', 'e30', 'W251bGxd', '!']) // no percent code, {}, [null], no base64
    expect(readAddress(`#/repair?plan=${plan}`)).toMatchObject({
      steps: null,
      faults: ['The plan in the address cannot be read.'],
    })
})
