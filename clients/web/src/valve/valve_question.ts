// What takes long to know of the valve that is open: asked for by a button, answered below it, and forgotten when another valve is opened.
import { button, h } from '../dom'
import { problemList } from '../problems'
import { problemsOf, type Workspace } from '../workspace'

interface Question {
  label: string // of the button
  busy: string // of the progress
  ask: (reference: string, signal: AbortSignal) => Promise<(Node | string)[]>
  style: string | undefined // of the answer
}

interface ValveQuestion {
  button: HTMLButtonElement
  progress: HTMLProgressElement
  answer: HTMLElement
}

export function valveQuestion(workspace: Workspace, { label, busy, ask, style }: Question): ValveQuestion {
  let asked: AbortController | null = null
  let shown: string | null = null // the reference of the valve that is answered for, or was
  const go = button(label, () => void answerIt())
  const progress = h('progress', { 'aria-label': busy, hidden: true })
  const answer = h('div', { class: style, 'aria-live': 'polite' })
  workspace.subscribe(() => shown !== null && workspace.valve?.reference !== shown && clear())

  async function answerIt(): Promise<void> {
    const { valve } = workspace
    if (!valve) return
    clear()
    shown = valve.reference
    const mine = new AbortController()
    asked = mine
    setBusy(true)
    const parts = await ask(valve.reference, mine.signal).catch((error: unknown) => [problemList(problemsOf(error))])
    if (asked !== mine) return
    answer.replaceChildren(...parts)
    setBusy(false)
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
    go.disabled = isBusy
    progress.hidden = !isBusy
  }

  return { button: go, progress, answer }
}
