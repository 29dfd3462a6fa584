// What takes long to know of the valve that is open: asked for by a button, or one of some, answered below, and forgotten when another valve is opened.
import { button, h } from '../dom'
import { problemList } from '../problems'
import { problemsOf, type Workspace } from '../workspace'

interface Question<Choice extends string> {
  labels: readonly Choice[] // of the buttons
  busy: string // of the progress
  ask: (reference: string, signal: AbortSignal, chosen: Choice) => Promise<(Node | string)[]>
  style: string | undefined // of the answer
}

interface ValveQuestion {
  buttons: HTMLButtonElement[]
  progress: HTMLProgressElement
  answer: HTMLElement
}

export function valveQuestion<Choice extends string>(
  workspace: Workspace,
  { labels, busy, ask, style }: Question<Choice>,
): ValveQuestion {
  let asked: AbortController | null = null
  let shown: string | null = null // the reference of the valve that is answered for, or was
  const buttons = labels.map((label) => button(label, () => void answerIt(label)))
  const progress = h('progress', { 'aria-label': busy, hidden: true })
  const answer = h('div', { class: style, 'aria-live': 'polite' })
  workspace.subscribe(() => shown !== null && workspace.valve?.reference !== shown && clear())

  async function answerIt(chosen: Choice): Promise<void> {
    const { valve } = workspace
    if (!valve) return
    clear()
    shown = valve.reference
    const mine = new AbortController()
    asked = mine
    setBusy(true)
    const parts = await ask(valve.reference, mine.signal, chosen).catch((error: unknown) => [
      problemList(problemsOf(error)),
    ])
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
    for (const go of buttons) go.disabled = isBusy
    progress.hidden = !isBusy
  }

  return { buttons, progress, answer }
}
