// What was asked of a search, in a few words for the list of searches.
import { seconds } from '../format'
import { grouped } from '../jobs/progress_panel'
import { CHORDAL_STEPS, SUTURES } from './options'

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
    most !== undefined && (most === 0 ? 'no neochordae' : `at most ${most} ${most === 1 ? 'neochorda' : 'neochordae'}`),
    ...CHORDAL_STEPS.map(({ pointer, label }) => rules[pointer.replace('/rules/', '')] === true && label.toLowerCase()),
    fixed > 0 && `${fixed} fixed ${fixed === 1 ? 'step' : 'steps'}`,
    time !== undefined && `at most ${seconds(time)}`,
    evaluations !== undefined && `${grouped(evaluations)} closures`,
    weights && 'own weights',
  ].filter((words): words is string => typeof words === 'string')
  return said.length > 0 ? said.join(', ') : 'default options'
}

/// "annuloplasty:own" -> "own-shape ring"
function kindInShort(word: string): string {
  if (word === 'annuloplasty:own') return 'own-shape ring'
  const kind = word.replace(/^.*:/, '').replaceAll('_', ' ')
  return word.startsWith('papillary')
    ? `suture to ${kind}`
    : word.startsWith('neochorda')
      ? `neochorda to ${kind}`
      : kind
}
