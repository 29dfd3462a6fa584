// What the page prints of a plan and a closure is what their documents state, in the words of the command line. One valve is stored, with
// two plans; tests/python/test_one_number.py has six made anew.
import { expect, test, vi } from 'vitest'
import type { Closure, SearchResult } from '../../src/api/types'
import { leakEstimate, leakInFull } from '../../src/estimate'
import { typeset } from '../../src/format'
import { FIGURES, leakFigures, leakOf, shownFigure } from '../../src/search/figures'
import { reweightedCost, type Weights } from '../../src/search/price'
import { leakWords } from '../../src/valve/headline'
import { MEASURES } from '../../src/valve/measures'
import { WEIGHTS } from './plans'

interface Printed {
  scored: SearchResult
  words: string // of `coapt evaluate`
  closed: Closure // with the first plan
  closed_words: string // of `coapt close`
}

const { readFileSync } = await vi.importActual<{ readFileSync(file: string | URL): string }>('node:fs')
const stored = new URL('one_number.json', import.meta.url)
const printed: Printed = JSON.parse(String(readFileSync(import.meta.env.VITE_PRINTED ?? stored)))
const { scored, closed } = printed
const words = typeset(printed.words.replaceAll(/\s+/g, ' '))
const closedWords = typeset(printed.closed_words)

/// That the text has the number, to the digits that it shows.
function expectShown(text: string, ...numbers: number[]): void {
  const shown = text.match(/\d+(\.\d+)?/g) ?? []
  expect(shown).toEqual(numbers.map((value, i) => value.toFixed(shown[i]?.split('.')[1]?.length ?? 0)))
}

test('the leak of a card is the estimate of the document, in the words of the command line', () => {
  for (const plan of scored.plans) {
    const [planned, ...causes] = leakFigures(plan)
    expect(words).toContain(`leak as planned: ${planned?.[1]}`)
    expect(leakOf(plan).value).toBe(plan.measure.leak_mm2)
    const { execution, tissue, numerical } = plan.leak as NonNullable<typeof plan.leak>
    for (const [i, interval] of [execution, tissue, numerical].entries())
      if (interval) expectShown(causes[i]?.[1] ?? '', ...interval)
  }
})

test('so is that of the valve before', () => {
  expect(words).toContain(`Before: leak ${leakInFull(leakEstimate(scored.before))},`)
})

test('the headline and the measures have the leak of the closure', () => {
  const leak = /\n +leak +(.*? mm²)/.exec(closedWords)?.[1]
  expect(leakWords(closed)).toBe(leak)
  expect(leakWords(scored.before as unknown as Closure, closed)).toMatch(new RegExp(`^\\d+(\\.\\d+)? → ${leak}$`))
  expect(`${measured('Leak ± numerical error, mm²')} mm²`).toBe(leak)
  expect(closed.leak_mm2).toBe(scored.plans[0]?.measure.leak_mm2)
})

test('the measures are those that the command line prints', () => {
  const [mean, least] = ['mean', 'minimum'].map((which) => measured(`Coaptation height, ${which}, mm`))
  expect(closedWords).toContain(`height min ${least}, mean ${mean} mm`)
  expect(closedWords).toContain(
    `highest tension ${measured('Highest chordal tension, N')} N, sum ${measured('Total chordal tension, N')} N`,
  )
})

test('cost, opening and gradient of a plan have one value', () => {
  const weights = (scored.weights as Weights | undefined) ?? WEIGHTS
  for (const plan of scored.plans) {
    expect(reweightedCost(plan, weights, weights)).toBe(plan.ranked_cost)
    expectShown(shown('Cost', plan), plan.ranked_cost as number)
    expect(plan.row?.opening).toBe(
      [shown('Opening in diastole', plan), shown('Mean gradient at rest', plan)].join(', '),
    )
  }
})

function measured(name: string): string {
  return MEASURES.find(([label]) => label === name)?.[1](closed) ?? `no measure ${name}`
}

function shown(label: string, plan: SearchResult['plans'][number]): string {
  const figure = FIGURES.find((one) => one.label === label)
  return figure ? shownFigure(figure, plan) : `no figure ${label}`
}
