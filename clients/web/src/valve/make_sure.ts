// The leak on finer and finer meshes, until it converges: asked for by a button, because it takes seconds to a minute.
import { proveLeak } from '../api/calls'
import type { Closure } from '../api/types'
import { button, h } from '../dom'
import { joined, number, seconds } from '../format'
import { term } from '../help/term'
import { problemList } from '../problems'
import { problemsOf, type Workspace } from '../workspace'
import parts from '../style/parts.module.css'

type Convergence = NonNullable<Closure['convergence']>
const ENDS: Record<Convergence['stop'], string> = {
  settled: 'It has converged.',
  most_meshes: 'It has not converged.',
  vertex_limit: 'It has not converged; the next mesh would have too many vertices.',
  not_closed: 'The last closure did not converge, so its leak is unreliable.',
}

export function makeSure(workspace: Workspace): HTMLElement {
  let asked: AbortController | null = null
  const ask = button('Make sure', () => void prove())
  const progress = h('progress', { 'aria-label': 'Closing on finer meshes', hidden: true })
  const answer = h('p', { class: parts.hint, 'aria-live': 'polite' })
  let shown: string | null = null
  workspace.subscribe(() => shown !== null && workspace.valve?.reference !== shown && clear())

  async function prove(): Promise<void> {
    const { valve } = workspace
    if (!valve) return
    clear()
    shown = valve.reference
    const mine = new AbortController()
    asked = mine
    setBusy(true)
    try {
      const { convergence } = await proveLeak(valve.reference, mine.signal)
      if (asked === mine && convergence) answer.replaceChildren(sureWords(convergence))
    } catch (error) {
      if (asked === mine) answer.replaceChildren(problemList(problemsOf(error)))
    }
    if (asked === mine) setBusy(false)
  }

  /// What is asked of another valve is not waited for.
  function clear(): void {
    asked?.abort()
    asked = null
    shown = null
    answer.replaceChildren()
    setBusy(false)
  }

  function setBusy(isBusy: boolean): void {
    ask.disabled = isBusy
    progress.hidden = !isBusy
  }

  return h(
    'div',
    { 'data-part': 'make-sure' },
    h('div', { class: parts.row }, ask, term('finer', 'on finer meshes'), progress),
    answer,
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
