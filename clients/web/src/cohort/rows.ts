// Rows of the table of valves, their figures and their order. Without drawing.
import type { Closure, RankedPlan } from '../api/types'
import { number, percent, withError } from '../format'
import { describe } from '../repair/steps'

export interface Row {
  reference: string // a preset's name or a stored valve's id
  name: string
  closure: Closure | null // null: on its way
  problem: string | null // why it cannot be closed
  plan: RankedPlan | null // the first of its newest search
  isSearched: boolean // a search is on its way
}

export interface Column {
  title: string
  numeric?: boolean
  ofPlans?: boolean // only where there are searches
  words(row: Row): string
  order(row: Row): number | string | null // null comes last
}

const WAITING = '…'
const TYPES = ['I', 'II', 'IIIa', 'IIIb'] // Carpentier

export const COLUMNS: readonly Column[] = [
  { title: 'Valve', words: ({ name }) => name, order: ({ name }) => name.toLowerCase() },
  { title: 'Diagnosis', words: diagnosis, order: ({ closure }) => rankOf(closure) },
  {
    title: 'Leak, mm²',
    numeric: true,
    words: ({ closure, problem }) =>
      closure ? withError(closure.leak_mm2, closure.leak.error_mm2) : problem ? '' : WAITING,
    order: ({ closure }) => closure?.leak_mm2 ?? null,
  },
  {
    title: 'First plan',
    ofPlans: true,
    words: ({ plan, isSearched }) => (plan ? planWords(plan) : isSearched ? 'searching …' : ''),
    order: ({ plan }) => plan && planWords(plan),
  },
  {
    title: 'Probability of a leak below 5 mm²',
    numeric: true,
    ofPlans: true,
    words: ({ plan }) => (plan ? percent(plan.acceptable_probability) : ''),
    order: ({ plan }) => plan?.acceptable_probability ?? null,
  },
  {
    title: 'Reserve against progression, mm',
    numeric: true,
    ofPlans: true,
    words: ({ plan }) => (plan ? number(plan.durability_mm) : ''),
    order: ({ plan }) => plan?.durability_mm ?? null,
  },
]

export function newRow(reference: string, name: string): Row {
  return { reference, name, closure: null, problem: null, plan: null, isSearched: false }
}

function planWords({ plan }: RankedPlan): string {
  return plan.steps.map(describe).join('; ') || 'No repair'
}

function diagnosis({ closure, problem }: Row): string {
  if (problem) return problem
  if (!closure) return WAITING
  const { diagnosis } = closure
  if (!diagnosis) return 'unreliable'
  if (diagnosis.competent) return 'Competent'
  const where = diagnosis.segments.filter(({ finding }) => finding === 'prolapse' || finding === 'flail')
  const findings = where.map(({ name, finding }) => `${name} ${finding}`).join(', ')
  return `Type ${diagnosis.types.join(' and ')}${findings && `: ${findings}`}${diagnosis.type_sure ? '' : ' (uncertain)'}`
}

/// Competent valves first, then by Carpentier's types.
function rankOf(closure: Closure | null): number | null {
  if (!closure?.diagnosis) return null
  return closure.diagnosis.type === null ? 0 : 1 + TYPES.indexOf(closure.diagnosis.type)
}

/// Those that have all words of `asked` in them, ordered by a column; rows that are equal there stay in their order.
export function arranged(rows: readonly Row[], { order }: Column, isDown: boolean, asked: string): Row[] {
  const words = asked.toLowerCase().split(/\s+/)
  const found = rows.filter((row) => {
    const text = COLUMNS.map((column) => column.words(row))
      .join(' ')
      .toLowerCase()
    return words.every((word) => text.includes(word))
  })
  return found.sort((one, other) => {
    const [a, b] = [order(one), order(other)]
    if (a === null || b === null) return Number(a === null) - Number(b === null)
    const way = typeof a === 'number' && typeof b === 'number' ? a - b : String(a).localeCompare(String(b))
    return isDown ? -way : way
  })
}
