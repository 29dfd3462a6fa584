import { expect, test } from 'vitest'
import { differing, inShort } from '../../src/search/in_short'
import {
  ANCHORS,
  ANSWER,
  EVIDENCE,
  LEAFLETS,
  LIMITS,
  NEOCHORDAE,
  OPTIMISER,
  placeOf,
  ringKinds,
  searchOf,
  SUTURES,
  WEIGHTS,
  type Choices,
} from '../../src/search/options'
import { NO_PLAN } from '../../src/workspace'
import schema from '../../../../io/schema/search.schema.json'

const all = [...ANSWER, NEOCHORDAE, ...LIMITS, ...OPTIMISER, ...WEIGHTS]
const none: Choices = { numbers: new Map(), switches: new Map(), forbidden: [], fixed: null }

/// What the schema says of an option.
function said(pointer: string): { minimum: number; maximum: number; default: number } {
  const [, first = '', second] = pointer.split('/')
  const defs = schema.$defs as Record<string, { properties: Record<string, unknown> }>
  const properties = second ? defs[first]?.properties : schema.properties
  return (properties as Record<string, unknown>)[second ?? first] as {
    minimum: number
    maximum: number
    default: number
  }
}

test('defaults make an empty search', () => {
  expect(
    searchOf({
      ...none,
      numbers: new Map(all.map((option) => [option, option.fallback])),
      switches: new Map([[EVIDENCE, true]]),
    }),
  ).toEqual({})
})

test('what differs from the defaults stands where its pointer says', () => {
  const [closures] = OPTIMISER
  const [leak] = WEIGHTS
  if (!closures || !leak) throw new Error('no options')
  const search = searchOf({
    numbers: new Map([
      [closures, 200],
      [leak, 2],
      [NEOCHORDAE, 0],
    ]),
    switches: new Map([[EVIDENCE, false]]),
    forbidden: ['annuloplasty:own'],
    fixed: { schema: 'coapt.plan/1', steps: [] },
  })
  expect(search).toEqual({
    evaluations: 200,
    evidence: false,
    weights: { leak: 2 },
    rules: { most_neochordae: 0, forbidden: ['annuloplasty:own'], fixed: { schema: 'coapt.plan/1', steps: [] } },
  })
})

test('an empty field leaves the option out', () => {
  expect(searchOf({ ...none, numbers: new Map(ANSWER.map((option) => [option, null])) })).toEqual({})
})

test('a target of zero is a target', () => {
  const target = OPTIMISER.find(({ pointer }) => pointer === '/target_mm2')
  if (!target) throw new Error('no target')
  expect(searchOf({ ...none, numbers: new Map([[target, 0]]) })).toEqual({ target_mm2: 0 })
})

test.each(all.map((option) => [option.pointer, option] as const))(
  '%s has the range and the default of the schema',
  (pointer, option) => {
    const { minimum, maximum, default: fallback } = said(pointer)
    if (option.fallback !== null) expect(option.fallback).toBe(fallback)
    expect(option.least).toBe(option.fallback === null ? Math.max(0, minimum) : minimum)
    if (pointer !== '/seed') expect(option.most).toBe(maximum) // a seed may be larger than a number of the browser
  },
)

test('what can be forbidden is a word of the rules', () => {
  const kinds = [
    ...ringKinds([{ name: 'generic-classic', note: 'flat, 3 : 4, as most; no saddle' }]),
    ...ANCHORS,
    ...LEAFLETS,
  ]
  const words = [...kinds.map(({ word }) => word), ...SUTURES.flatMap(({ forbidden }) => forbidden)]
  expect(words).toContain('annuloplasty:generic-classic')
  expect(kinds[1]?.hint).toBe('flat, 3 : 4')
  for (const word of words) expect(word).toMatch(/^(annuloplasty|papillary_approximation|neochorda)(:|$)/)
})

test('what was asked is said in short', () => {
  expect(inShort({})).toBe('default options')
  expect(
    inShort({
      evaluations: 2500,
      seconds: 30,
      rules: { forbidden: ['papillary_approximation', 'annuloplasty:own'], most_neochordae: 2 },
    }),
  ).toBe('no sutures, without annulus-shaped ring, at most 2 neochordae, at most 30 s, 2,500 closures')
  expect(inShort({ rules: { forbidden: ['papillary_approximation:anterolateral'], chordal_excision: true } })).toBe(
    'sutures of the posteromedial muscle only, cut strut chordae',
  )
})

test('what was asked is found again in what the service repeats', () => {
  const repeated = {
    evaluations: 300,
    seconds: 0,
    target_mm2: -1,
    plans: 5,
    rules: { fixed: NO_PLAN, forbidden: ['annuloplasty:own'], most_neochordae: 4, chordal_excision: true },
    weights: { leak: 1, tension: 2 },
  }
  expect(differing(repeated)).toEqual({
    evaluations: 300,
    rules: { forbidden: ['annuloplasty:own'], chordal_excision: true },
    weights: { tension: 2 },
  })
  expect(differing({ rules: { fixed: NO_PLAN } })).toEqual({})
})

test('a problem belongs to the option that its pointer leads into', () => {
  const problem = (path: string) => ({ code: 'out_of_range', path, message: '' })
  expect(placeOf(problem('/search/plans'), ['/plan', '/plans'])).toBe('/plans')
  expect(placeOf(problem('/search/rules/forbidden/0'), ['/rules/forbidden'])).toBe('/rules/forbidden')
  expect(placeOf(problem('/valve'), ['/plans'])).toBeNull()
})
