// The leak on finer and finer meshes, until it converges: asked for by a button, because it takes seconds to a minute.
import { proveLeak } from '../api/calls'
import type { Closure } from '../api/types'
import { h } from '../dom'
import { joined, number, seconds } from '../format'
import { term } from '../help/term'
import type { Workspace } from '../workspace'
import { valveQuestion } from './valve_question'
import parts from '../style/parts.module.css'

type Convergence = NonNullable<Closure['convergence']>
const ENDS: Record<Convergence['stop'], string> = {
  settled: 'It has converged.',
  most_meshes: 'It has not converged.',
  vertex_limit: 'It has not converged; the next mesh would have too many vertices.',
  not_closed: 'The last closure did not converge, so its leak is unreliable.',
}

export function makeSure(workspace: Workspace): HTMLElement {
  const question = valveQuestion(workspace, {
    label: 'Make sure',
    busy: 'Closing on finer meshes',
    ask: async (reference, signal) => {
      const { convergence } = await proveLeak(reference, signal)
      return convergence ? [sureWords(convergence)] : []
    },
    style: parts.hint,
  })
  return h(
    'div',
    { 'data-part': 'make-sure' },
    h('div', { class: parts.row }, question.button, term('finer', 'on finer meshes'), question.progress),
    question.answer,
  )
}

/// "The leak is 58.1 and 57.6 mm² on 648 and 2,592 triangles (0.1 and 1.4 s). It has converged."
export function sureWords({ levels, stop }: Convergence): string {
  const of = (words: (level: Convergence['levels'][number]) => string): string => joined(levels.map(words))
  const leaks = of(({ leak_mm2 }) => number(leak_mm2))
  const triangles = of((level) => level.triangles.toLocaleString('en'))
  const times = of((level) => number(level.seconds))
  const took = levels.reduce((sum, level) => sum + (level.seconds ?? 0), 0)
  return `The leak is ${leaks} mm² on ${triangles} triangles (${took < 60 ? `${times} s` : seconds(took)}). ${ENDS[stop]}`
}
