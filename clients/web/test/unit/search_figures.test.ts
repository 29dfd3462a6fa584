import { expect, test } from 'vitest'
import type { RankedPlan } from '../../src/api/types'
import {
  doubts,
  FIGURES,
  judge,
  leakFigures,
  lengthName,
  marginWords,
  shownFigure,
  tieWords,
} from '../../src/search/figures'

interface Given {
  rank?: number
  mean?: number | null
  sd?: number | null
  tension?: number | null
  angle?: number | null
  tie?: boolean
  ahead?: number | null
}

function plan({ rank = 1, mean = 1, sd = 0, tension = 1, angle = 1, tie = false, ahead = null }: Given): RankedPlan {
  const statistics = { nominal: mean, mean, sd, worst: mean, p95: mean, below_5: 1, below_10: 1, below_20: 1 }
  return {
    rank,
    plan: { schema: 'coapt.plan/1', steps: [] },
    leak_mm2: statistics,
    measure: { leak_mm2: mean, tension_max_n: tension, coaptation: {} },
    margin_to_leak: { suture_length_mm: null, angle_deg: angle, share: null },
    tie_with_next: tie,
    probability_outranks_next: ahead,
    status: 'converged',
    crossing: false,
    region_closures: 65,
    region_failures: 0,
  } as unknown as RankedPlan
}

function figure(label: string) {
  const found = FIGURES.find((one) => one.label === label)
  if (!found) throw new Error(`no figure ${label}`)
  return found
}

test('less tension is better', () => {
  expect(judge(figure('Highest chordal tension'), plan({ tension: 1 }), plan({ tension: 2 }))).toBe('first')
  expect(judge(figure('Highest chordal tension'), plan({ tension: 2 }), plan({ tension: 1 }))).toBe('second')
})

test('a larger margin is better', () => {
  expect(judge(figure('Margin to leak, angle'), plan({ angle: 1 }), plan({ angle: 2 }))).toBe('second')
})

test('what looks the same is the same', () => {
  expect(judge(figure('Highest chordal tension'), plan({ tension: 1.001 }), plan({ tension: 1.004 }))).toBe('same')
})

test('means that differ by less than their spread are not told apart', () => {
  const mean = figure('Leak with errors of execution, mean')
  expect(judge(mean, plan({ mean: 1, sd: 0.5 }), plan({ mean: 1.4, sd: 0.1 }))).toBe('within')
  expect(judge(mean, plan({ mean: 1, sd: 0.5 }), plan({ mean: 1.6, sd: 0.1 }))).toBe('first')
})

test('one closure does not tell half a square millimetre', () => {
  const leak = figure('Leak as planned')
  expect(judge(leak, plan({ mean: 1 }), plan({ mean: 1.5 }))).toBe('within')
  expect(judge(leak, plan({ mean: 1 }), plan({ mean: 1.6 }))).toBe('first')
})

test('what is not known is not compared', () => {
  expect(judge(figure('Highest chordal tension'), plan({ tension: null }), plan({}))).toBe('unknown')
})

test('a margin at the border of the region may be larger', () => {
  const wide = { ...plan({}), margin_to_leak: { suture_length_mm: 1, angle_deg: 2.5, share: null } }
  expect(marginWords(wide)).toBe('tip to trigone distance more than 1.00 mm, angle 2.5°')
  expect(shownFigure(figure('Margin to leak, angle'), plan({ angle: 5 }))).toBe('≥ 5.0°')
})

test('errors of length are of sutures where there are some', () => {
  const tied = (...sides: ('anterolateral' | 'posteromedial')[]): RankedPlan => ({
    ...plan({}),
    plan: {
      schema: 'coapt.plan/1',
      steps: sides.map((side) => ({
        step: 'papillary_approximation' as const,
        side,
        anchor: 'saddle_peak' as const,
        suture_length_mm: 30,
      })),
    },
  })
  expect(lengthName(tied())).toBe('tip to trigone distance')
  expect(lengthName(tied('anterolateral'))).toBe('suture or tip to trigone distance')
  expect(lengthName(tied('anterolateral'), 'anterolateral')).toBe('suture')
  expect(lengthName(tied('anterolateral', 'posteromedial'))).toBe('suture')
})

test('a leak is told with the widest of its errors, then by each cause', () => {
  const leak = { area_mm2: 0.3, numerical: [0, 1.4], tissue: [0.1, 3.5], execution: [0, 14.2] } as const
  expect(leakFigures({ ...plan({}), leak } as unknown as RankedPlan)).toEqual([
    ['Leak as planned', '0 mm²; 0 to 14 mm² with errors of execution (5 to 95 %)'],
    ['Leak with errors of execution, 5 to 95\u00a0%', '0 to 14 mm²'],
    ['Leak with tissue error, 5 to 95\u00a0%', '0.1 to 3.5 mm²'],
    ['Leak with numerical error, 5 to 95\u00a0%', '0.0 to 1.4 mm²'],
  ])
  const [planned, execution] = leakFigures(plan({ mean: 0.3 })) // of a release that stated no intervals
  expect([planned?.[1], execution?.[1]]).toEqual(['0.3 mm²', 'unknown'])
})

test('plans of a class cannot be told apart, also across ranks between', () => {
  const tied = [plan({ rank: 1, tie: true, ahead: 0.75 }), plan({ rank: 2, tie: true }), plan({ rank: 3 })] as const
  expect(tieWords(tied[0], tied[1], [...tied])).toBe('Plans 1 and 2 are equivalent.')
  expect(tieWords(tied[0], tied[2], [...tied])).toBe('Plans 1 and 3 are equivalent.')
  const apart = [plan({ rank: 1, ahead: 1 }), plan({ rank: 2 }), plan({ rank: 3 })] as const
  expect(tieWords(apart[0], apart[1], [...apart])).toBe('Plan 1 is better than plan 2 with a probability of 100 %.')
  expect(tieWords(apart[0], apart[2], [...apart])).toBeNull()
})

test('a plan whose closures failed is doubted', () => {
  expect(doubts(plan({}))).toEqual([])
  expect(
    doubts({ ...plan({}), status: 'step_limit', crossing: true, region_failures: 2, region_closures: 65 }),
  ).toEqual([
    'The closure did not converge (step limit).',
    'The leaflets cross.',
    '2 of 65 closures with errors of execution failed and are excluded.',
  ])
})
