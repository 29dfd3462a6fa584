// A trial of exam A (thesis 3.2.2): four closed valves, one of them flaccid under the hook, the four again and a choice. The closed ones
// have an echo; that of the flaccid one would show heights that are to be felt.
import { button, h } from '../dom'
import parts from '../style/parts.module.css'
import type { Analysis } from './analysis'
import { Confidence } from './answer'
import type { FourValves } from './four_valves'
import { type Frame, panel } from './frame'
import type { Analysed, CaseA, Judged } from './types'
import { Clock, pressed, unless } from './waits'

export interface TrialParts {
  frame: Frame
  analysis: Analysis
  four: FourValves
  title: string // of the trial
  limit_s: number // of analysis; 0: none
  aside: HTMLElement // is there in each step
  signal: AbortSignal
}

export async function trialA(made: CaseA, at: TrialParts): Promise<Judged> {
  const { frame, analysis, four, title, aside, signal } = at
  const { scene } = await unless(signal, analysis.start(made.valve))

  four.set(
    scene,
    made.choices.map(({ closed_mm }) => closed_mm),
  )
  four.ask(false)
  const go = button('Continue to the flaccid valve', () => {}, { class: parts.primary })
  const look = panel(
    '1. Look',
    h('p', {}, 'One of these four valves follows, without pressure. There is no time limit.'),
    go,
  )
  frame.show(title, 'Four valves under pressure. Rotate them as you like; they rotate together.', four.element, [
    look,
    four.echo.element,
    aside,
  ])
  await pressed(go, signal)

  analysis.hand.grid.hidden = false
  const done = button('I have seen enough', () => {}, { class: parts.primary })
  frame.show(
    title,
    'The flaccid valve seen from the atrium: pull on it to find out how it closes.',
    analysis.canvas.element,
    [panel('2. Pull', analysis.clock, done), analysis.hand.element, aside],
  )
  analysis.begin(at.limit_s, () => done.click())
  let analysed: Analysed
  try {
    await pressed(done, signal)
  } finally {
    analysed = analysis.end(at.limit_s)
  }

  const confidence = new Confidence(made.chance)
  const answer = button('Answer', () => {}, { class: parts.primary, disabled: true })
  let choice = 0
  four.onChoice = (chosen) => {
    choice = chosen
    answer.disabled = false
  }
  four.ask(true)
  frame.show(title, 'Which of the four does the valve become under pressure?', four.element, [
    panel('3. Choose', h('p', {}, 'Choose a valve below its picture.'), confidence.element, answer),
    four.echo.element,
    aside,
  ])
  const clock = new Clock(() => {})
  await pressed(answer, signal).finally(() => clock.stop())
  return {
    ...analysed,
    choosing_s: clock.stop(),
    choice: String(choice),
    answer: String(made.answer),
    right: choice === made.answer ? 1 : 0,
    confidence: confidence.share,
  }
}
