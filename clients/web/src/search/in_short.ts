// What was asked of a search, in a few words for the list of searches.
import type { Plan, SearchResult } from '../api/types'
import { counted, seconds } from '../format'
import {
  ANSWER,
  STEPS_ON_REQUEST,
  LIMITS,
  NEOCHORDAE,
  OPTIMISER,
  searchOf,
  SUTURES,
  WEIGHTS,
  type NumberOption,
} from './options'

interface Asked {
  evaluations?: number
  seconds?: number
  weights?: object
  rules?: { forbidden?: string[]; fixed?: { steps: unknown[] }; most_neochordae?: number } & Record<string, unknown>
}

/// "no sutures, at most 2 neochordae, at most 30 s"; `search`: what differs from the defaults.
export function inShort(search: Record<string, unknown>): string {
  const { evaluations, seconds: time, weights, rules = {} } = search as Asked
  const forbidden = rules.forbidden ?? []
  const sutures = SUTURES.find((choice) => choice.forbidden.some((word) => forbidden.includes(word)))
  const others = forbidden.filter((word) => word !== sutures?.forbidden[0])
  const most = rules.most_neochordae
  const fixed = rules.fixed?.steps.length ?? 0
  const said = [
    sutures && (sutures.name === 'none' ? 'no sutures' : `sutures of the ${sutures.label}`),
    others.length > 0 && `without ${others.map(kindInShort).join(', ')}`,
    most !== undefined && (most === 0 ? 'no neochordae' : `at most ${counted(most, 'neochorda', 'neochordae')}`),
    ...STEPS_ON_REQUEST.map(
      ({ pointer, label }) => rules[pointer.replace('/rules/', '')] === true && label.toLowerCase(),
    ),
    fixed > 0 && counted(fixed, 'fixed step'),
    time !== undefined && `at most ${seconds(time)}`,
    evaluations !== undefined && counted(evaluations, 'closure'),
    weights && 'own weights',
  ].filter((words): words is string => typeof words === 'string')
  return said.length > 0 ? said.join(', ') : 'default options'
}

/// What differs from the defaults in a search as the service repeats it, with all its fields.
export function differing(search: SearchResult['reproduce']['search']): Record<string, unknown> {
  const found = new Map<NumberOption, number>()
  for (const option of NUMBERS) {
    const value = valueAt(search, option.pointer)
    const isLimit = option.fallback !== null || (typeof value === 'number' && value > 0)
    if (typeof value === 'number' && isLimit) found.set(option, value)
  }
  const { forbidden = [], fixed } = search.rules ?? {}
  const switches = new Map(STEPS_ON_REQUEST.map((option) => [option, valueAt(search, option.pointer) === true]))
  const steps = fixed?.steps ?? []
  const plan: Plan | null = steps.length > 0 ? { schema: 'coapt.plan/1', steps } : null
  return searchOf({ numbers: found, switches, forbidden, fixed: plan })
}

const NUMBERS = [...ANSWER, NEOCHORDAE, ...LIMITS, ...OPTIMISER, ...WEIGHTS]

function valueAt(search: object, pointer: string): unknown {
  const names = pointer.slice(1).split('/')
  return names.reduce<unknown>((at, name) => (at as Record<string, unknown> | undefined)?.[name], search)
}

/// "annuloplasty:own" -> "annulus-shaped ring"
function kindInShort(word: string): string {
  if (word === 'annuloplasty:own') return 'annulus-shaped ring'
  const kind = word.replace(/^.*:/, '').replaceAll('_', ' ')
  return word.startsWith('papillary')
    ? `suture to ${kind}`
    : word.startsWith('neochorda')
      ? `neochorda to ${kind}`
      : kind
}
