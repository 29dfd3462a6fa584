// A trial of exam B (thesis 3.2.4): each of eight segments is tethered, normal or prolapsing. They may be judged while the valve
// is pulled.
import { button, h } from '../dom'
import { grabber } from '../live/controls'
import parts from '../style/parts.module.css'
import { Confidence, SegmentTable } from './answer'
import type { TrialParts } from './exam_a'
import { panel } from './frame'
import { lettersOf, rightLetters } from './trials'
import type { Analysed, CaseB, Judged } from './types'
import { Clock, pressed, unless } from './waits'

export async function trialB(made: CaseB, at: Omit<TrialParts, 'four'>): Promise<Judged> {
  const { frame, analysis, title, limit_s, aside, signal } = at
  await unless(signal, analysis.start(made.valve))
  const table = new SegmentTable((segment) => grabber(analysis.canvas, segment))
  const confidence = new Confidence(made.chance)
  const answer = button('Answer', () => {}, { class: parts.primary, disabled: true })
  analysis.hand.grid.hidden = true // the table has them
  table.onChange = () => (answer.disabled = table.answer === null)
  frame.show(
    title,
    'Pull each free edge towards the atrium: is it tethered, normal or prolapsing?',
    analysis.canvas.element,
    [
      panel('Time', analysis.clock),
      analysis.hand.element,
      table.element,
      panel('Overall', h('p', {}, 'Expected fraction of correct answers out of eight.'), confidence.element, answer),
      aside,
    ],
  )

  let analysed: Analysed | null = null
  let after: Clock | null = null
  analysis.begin(limit_s, () => {
    analysed = analysis.end(limit_s)
    after = new Clock(() => {})
    frame.say('Time is up. Answer the remaining segments.')
  })
  try {
    await pressed(answer, signal)
  } finally {
    analysed ??= analysis.end(limit_s)
  }
  const choosing_s = (after as Clock | null)?.stop() ?? 0
  const choice = lettersOf(table.answer ?? [])
  const truth = lettersOf(made.segments.map(({ mobility }) => mobility))
  return {
    ...(analysed as Analysed),
    choosing_s,
    choice,
    answer: truth,
    right: rightLetters(choice, truth),
    confidence: confidence.share,
  }
}
