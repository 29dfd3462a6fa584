// What takes long to know of the valve that is open, or of its repair: asked for by a button, or one of some, answered below, and forgotten when
// there is another valve or plan.
import type { Plan } from '../api/types'
import { button, h } from '../dom'
import { problemList } from '../problems'
import { problemsOf, type Workspace } from '../workspace'

interface Asked {
  reference: string
  plan: Plan | null
}

interface Question<Choice extends string> {
  labels: readonly Choice[] // of the buttons
  busy: string // of the progress
  ask: (of: Asked, signal: AbortSignal, chosen: Choice) => Promise<(Node | string)[]>
  style: string | undefined // of the answer
  isRepaired?: boolean // it is asked of the valve with the present plan
}

interface ValveQuestion {
  buttons: HTMLButtonElement[]
  progress: HTMLProgressElement
  answer: HTMLElement
}

export function valveQuestion<Choice extends string>(
  workspace: Workspace,
  { labels, busy, ask, style, isRepaired = false }: Question<Choice>,
): ValveQuestion {
  let asked: AbortController | null = null
  let shown: string | null = null // the valve and plan that are answered for, or were
  const buttons = labels.map((label) => button(label, () => void answerIt(label)))
  const progress = h('progress', { 'aria-label': busy, hidden: true })
  const answer = h('div', { class: style, 'aria-live': 'polite' })
  const present = (): Asked | null =>
    workspace.valve && { reference: workspace.valve.reference, plan: isRepaired ? workspace.plan : null }
  workspace.subscribe(() => shown !== null && JSON.stringify(present()) !== shown && clear())

  async function answerIt(chosen: Choice): Promise<void> {
    const of = present()
    if (!of) return
    clear()
    shown = JSON.stringify(of)
    const mine = new AbortController()
    asked = mine
    setBusy(true)
    const parts = await ask(of, mine.signal, chosen).catch((error: unknown) => [problemList(problemsOf(error))])
    if (asked !== mine) return
    answer.replaceChildren(...parts)
    setBusy(false)
  }

  /// What was asked before is not waited for.
  function clear(): void {
    asked?.abort()
    asked = null
    shown = null
    answer.replaceChildren()
    setBusy(false)
  }

  function setBusy(isBusy: boolean): void {
    for (const go of buttons) go.disabled = isBusy
    progress.hidden = !isBusy
  }

  return { buttons, progress, answer }
}
