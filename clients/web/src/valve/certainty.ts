// Time against the numerical error of the leak, in three words: each with what it will take and leave, then with what it took and left.
import { CERTAINTIES, closeWith, type Certainty } from '../api/calls'
import type { Closure } from '../api/types'
import { h } from '../dom'
import { joined, knownDigits, number, seconds, withError } from '../format'
import { term } from '../help/term'
import type { Workspace } from '../workspace'
import { valveQuestion } from './valve_question'
import parts from '../style/parts.module.css'
import valveStyle from './valve.module.css'

type Convergence = NonNullable<Closure['convergence']>
const ENDS: Record<Convergence['stop'], string> = {
  settled: 'It has converged.',
  most_meshes: 'It has not converged on two meshes.',
  vertex_limit: 'It has not converged; the next mesh would have too many vertices.',
  not_closed: 'The last closure did not converge, so its leak is unreliable.',
}

/// Times of the closure that is shown: medians over the presets (docs/concepts/certainty.md).
const TIMES: Record<Certainty, number> = { quick: 1, sure: 5, proof: 20 }
/// Errors of it: (650 / triangles)^0.6 on four and sixteen times the triangles (docs/researcher/accuracy.md).
const ERRORS: Record<Certainty, number> = { quick: 1, sure: 4 ** -0.6, proof: 16 ** -0.6 }

/// `isRepaired`: of the valve with the present plan.
export function certainty(workspace: Workspace, isRepaired: boolean): HTMLElement {
  const question = valveQuestion(workspace, {
    labels: CERTAINTIES,
    busy: 'Closing',
    ask: async ({ reference, plan }, signal, chosen) => [
      certaintyWords(await closeWith(chosen, reference, plan, signal)),
    ],
    style: parts.hint,
    isRepaired,
  })
  const trades = CERTAINTIES.map(() => h('span', { class: parts.hint }))
  const element = h(
    'div',
    { 'data-part': 'certainty', role: 'group', 'aria-label': 'Time or certainty' },
    h('p', {}, term('certainty', 'Time or certainty'), ' ', question.progress),
    ...question.buttons.map((go, i) => h('div', { class: `${parts.row} ${valveStyle.trade}` }, go, trades[i])),
    question.answer,
  )
  function tell(): void {
    const closure = (isRepaired ? workspace.after : workspace.before)?.closure
    element.hidden = !closure
    for (const [i, word] of CERTAINTIES.entries()) if (closure) trades[i]?.replaceChildren(tradeWords(word, closure))
  }
  workspace.subscribe(tell)
  tell() // a valve may be open already
  return element
}

/// "about 0.3 s, ± 2.5 mm²": what this choice will take and leave of the error of this closure.
export function tradeWords(choice: Certainty, { seconds: took, leak }: Pick<Closure, 'seconds' | 'leak'>): string {
  const time = `about ${shortTime(TIMES[choice] * took)}`
  if (leak.error_mm2 === null) return time
  const error = ERRORS[choice] * leak.error_mm2
  return `${time}, ± ${knownDigits(error, error)} mm²`
}

/// "The leak is 57.6 ± 0.5 mm² (58.1 and 57.6 on 648 and 2,592 triangles, in 0.10 and 1.4 s). It has converged."
export function certaintyWords({ convergence, leak, triangles, seconds: took }: Closure): string {
  const finest = convergence?.levels.at(-1)
  if (!convergence || !finest)
    return `The leak is ${withError(leak.area_mm2, leak.error_mm2, 'mm²')} (on ${grouped(triangles)} triangles, in ${shortTime(took)}).`
  const of = (words: (level: Convergence['levels'][number]) => string): string => joined(convergence.levels.map(words))
  const total = convergence.levels.reduce((sum, level) => sum + (level.seconds ?? 0), 0)
  const times = total < 60 ? `${of((level) => shortTime(level.seconds ?? 0).replace(' s', ''))} s` : seconds(total)
  const leaks = of(({ leak_mm2 }) => number(leak_mm2))
  return `The leak is ${withError(finest.leak_mm2, convergence.leak_error_mm2, 'mm²')} (${leaks} on ${of((level) => grouped(level.triangles))} triangles, in ${times}). ${ENDS[convergence.stop]}${otherEnd(convergence)}`
}

const NAMED_MM2 = 0.5

function otherEnd({ other_end_mm2: change }: Convergence): string {
  if (change === null || Math.abs(change) < NAMED_MM2) return ''
  return ` Closed at half the speed, the first mesh leaks ${number(Math.abs(change))} mm² ${change > 0 ? 'more' : 'less'}.`
}

const grouped = (count: number): string => count.toLocaleString('en')
const shortTime = (value: number): string => (value < 60 ? `${number(value, value < 1 ? 2 : 1)} s` : seconds(value))
