// After a trial, in practice: what was right, and why.
import { button, h } from '../dom'
import { number } from '../format'
import parts from '../style/parts.module.css'
import type { Analysis } from './analysis'
import type { FourValves } from './four_valves'
import { type Frame, panel } from './frame'
import { type Telling, telling } from './telling'
import { type CaseA, type CaseB, type Judged, MOBILITIES, SEGMENTS } from './types'
import { pressed } from './waits'

export interface FeedbackParts {
  frame: Frame
  analysis: Analysis
  four: FourValves
  title: string
  aside: HTMLElement
  learn(seed?: number): void // shows exemplars of the kinds, of this case of exam B
  signal: AbortSignal
}

export async function feedbackA(
  made: CaseA,
  judged: Judged,
  { frame, analysis, four, title, aside, learn, signal }: FeedbackParts,
): Promise<void> {
  const next = button('Next', () => {}, { class: parts.primary })
  const told = tellingOf(made, judged, analysis)
  four.tell(made.answer, Number(judged.choice))
  const show = (): void => {
    if (told) four.mark(told.segment)
    frame.show(title, words, four.element, [panel('Answer', why, leaks, pull, exemplar, next), aside])
  }
  const leaks = h(
    'table',
    {},
    h('tr', {}, h('th', { scope: 'col' }, 'Closed'), h('th', { scope: 'col' }, 'Leak, mm²')),
    ...made.choices.map(({ choice, leak_mm2 }) =>
      h('tr', {}, h('th', { scope: 'row' }, `Valve ${choice}`), h('td', {}, number(leak_mm2))),
    ),
  )
  const words = judged.right === 1 ? 'Right.' : `Wrong: it was valve ${made.answer}.`
  const why = h('p', { 'data-part': 'why' }, told ? whyWords(made, judged, told) : '')
  const pull = h(
    'p',
    { class: parts.row, hidden: told === null },
    button(`Pull ${told?.segment} once more`, () => {
      if (!told) return
      const back = button('Back to the four valves', () => {
        analysis.canvas.hide()
        show()
      })
      frame.show(title, `Lift the free edge of ${told.segment}.`, analysis.canvas.element, [
        analysis.hand.element,
        panel('Answer', back),
        aside,
      ])
      analysis.canvas.show()
      analysis.canvas.grabEdge(told.segment)
    }),
  )
  const exemplar = h(
    'p',
    {},
    button('Feel an exemplar of each kind', () => learn()),
  )
  show()
  await pressed(next, signal)
  four.mark(null)
}

interface Told extends Telling {
  other: number // the valve with which the right one is compared
}

/// Against what was chosen; of a right answer against the valve that is most like it. Null where the valve is no longer there.
function tellingOf({ answer, choices }: CaseA, judged: Judged, { valve }: Analysis): Told | null {
  const closed = (choice: number): number[] => choices.find((one) => one.choice === choice)?.closed_mm ?? []
  const others = judged.right === 1 ? choices.map(({ choice }) => choice) : [Number(judged.choice)]
  const told = others
    .filter((other) => other !== answer)
    .flatMap((other) => (valve ? [{ ...telling(valve.scene, closed(answer), closed(other)), other }] : []))
  return told.sort((a, b) => Math.abs(a.higher_mm) - Math.abs(b.higher_mm))[0] ?? null
}

/// "P2 gives it away: its free edge closes 3.1 mm higher than in valve 1, your answer. You did not pull P2."
function whyWords({ answer }: CaseA, judged: Judged, { segment, higher_mm, other }: Told): string {
  const apart = `${number(Math.abs(higher_mm))} mm ${higher_mm > 0 ? 'higher' : 'lower'}`
  const compared = judged.right === 1 ? `valve ${other}, the most similar one` : `valve ${other}, your answer`
  const pulled = judged.visited.includes(segment) ? '' : ` You did not pull ${segment}.`
  return `${segment} distinguishes valve ${answer}: its free edge closes ${apart} than in ${compared}.${pulled}`
}

export async function feedbackB(
  made: CaseB,
  judged: Judged,
  { frame, title, aside, learn, signal }: Omit<FeedbackParts, 'four' | 'analysis'>,
): Promise<void> {
  const next = button('Next', () => {}, { class: parts.primary })
  const { pull_n, limit_mm } = made.limits
  frame.show(
    title,
    `${judged.right} of ${SEGMENTS.length} segments are correct.`,
    panel(
      'Segments',
      segmentsTruth(made, judged.choice),
      h(
        'p',
        { class: parts.hint },
        `Each free edge was pulled towards the atrium with ${pull_n} N. A segment more than ${limit_mm} mm lower than in the valve without lesions is tethered; one as much higher is prolapsing. Heights are above the annular plane.`,
      ),
    ),
    [
      panel(
        'Answer',
        h(
          'p',
          {},
          button('Feel the exemplars of this case', () => learn(made.seed)),
        ),
        next,
      ),
      aside,
    ],
  )
  await pressed(next, signal)
}

/// `choice`: letters of a learner.
function segmentsTruth({ segments }: CaseB, choice: string): HTMLElement {
  const said = (i: number): string => MOBILITIES.find((name) => name.startsWith((choice[i] ?? '').toLowerCase())) ?? ''
  return h(
    'div',
    { class: parts.scroll, tabindex: 0, role: 'group', 'aria-label': 'Segments, answers and heights' },
    h(
      'table',
      { 'data-part': 'truth' },
      h(
        'tr',
        {},
        ...['Segment', 'You', 'Is', 'Height, mm', 'Without lesions'].map((name) => h('th', { scope: 'col' }, name)),
      ),
      ...segments.map(({ segment, mobility, height_mm, normal_mm }, i) =>
        h(
          'tr',
          {},
          h('th', { scope: 'row' }, segment),
          h('td', { class: said(i) === mobility ? parts.good : parts.bad }, said(i)),
          h('td', {}, mobility),
          h('td', {}, number(height_mm)),
          h('td', {}, number(normal_mm)),
        ),
      ),
    ),
  )
}
