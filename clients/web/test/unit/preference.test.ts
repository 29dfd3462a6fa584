import { afterEach, beforeEach, expect, test, vi } from 'vitest'
import type { LearnedWeights, Preference, PreferenceAnswer, RankedPlan } from '../../src/api/types'
import { canBeCompared, informedWeights, preferenceCase, standing } from '../../src/search/preference_case'
import { keepAnswers, keptAnswers } from '../../src/state/answers'
import { planOf, termsOf, WEIGHTS } from './plans'

let kept: Map<string, string>
beforeEach(() => {
  kept = new Map()
  vi.stubGlobal('localStorage', {
    getItem: (key: string) => kept.get(key) ?? null,
    setItem: (key: string, value: string) => kept.set(key, value),
  })
})
afterEach(() => vi.unstubAllGlobals())

const described = (rank: number): RankedPlan => ({
  ...planOf({ rank, terms: { step: rank }, mean: 0.5 }),
  description: [`${rank} steps`],
})

test('a case holds of each plan what is compared, at the place of its rank', () => {
  expect(preferenceCase('a job', [described(2), described(1)], { ...WEIGHTS, sd_share: 2 })).toEqual({
    schema: 'coapt.plans/2',
    name: 'a job',
    weights: { sd_share: 2 },
    plans: [1, 2].map((rank) => ({
      cost_terms: termsOf({ step: rank }),
      description: [`${rank} steps`],
      leak_mm2: { mean: 0.5 },
      opening_area_mm2: 300,
      durability_mm: 9,
    })),
  })
})

test('three plans or more are compared if all have the amounts', () => {
  const plans = [1, 2, 3].map(described)
  const { cost_terms: _, ...old } = described(4)
  expect(canBeCompared(plans)).toBe(true)
  expect(canBeCompared(plans.slice(1))).toBe(false)
  expect(canBeCompared([...plans, old as RankedPlan])).toBe(false)
})

const learned = (known: Partial<LearnedWeights>) => ({ weights: WEIGHTS, informed: [], ...known }) as LearnedWeights

test('of the weights those are told that the answers speak of', () => {
  expect(informedWeights(learned({}), WEIGHTS)).toEqual([])
  const found = learned({ informed: ['step', 'leak'], weights: { ...WEIGHTS, leak: 1.5, step: 0.5, margin: 9 } })
  expect(informedWeights(found, { ...WEIGHTS, step: 2 })).toEqual([
    { label: 'Leak, per mm² of mean + weighted sd', own: 1, learned: 1.5 },
    { label: 'Each step of the operation', own: 2, learned: 0.5 },
  ])
})

test('the standing tells how many were answered, and the likely favourite', () => {
  const after = (answers: number) =>
    standing({
      first_places: [{ case: 'a job', rank: 2, probability: 0.614 }],
      learned: learned({ answers }),
    } as Preference)
  expect(after(0)).toBe('No question answered yet.')
  const favourite = 'Plan 2 is most likely your preferred plan (probability 61 %).'
  expect(after(1)).toBe(`1 question answered. ${favourite}`)
  expect(after(12)).toBe(`12 questions answered. ${favourite}`)
})

test('answers are kept by the job, and taken back', () => {
  const answer = (first: number): PreferenceAnswer => ({ case: 'a', first, second: 3, answer: 'unable' })
  expect(keptAnswers('a')).toEqual([])
  keepAnswers('a', [answer(1), answer(2)])
  keepAnswers('b', [answer(2)])
  keepAnswers('a', keptAnswers('a').slice(0, -1))
  expect(keptAnswers('a')).toEqual([answer(1)])
  expect(keptAnswers('b')).toEqual([answer(2)])
  keepAnswers('a', [])
  keepAnswers('b', [])
  expect([...kept.values()]).toEqual(['{}'])
})
