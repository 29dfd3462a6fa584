// After a trial, in practice: what was right, and why.
import { button, h } from '../dom'
import { number, withUnit } from '../format'
import parts from '../style/parts.module.css'
import type { FourValves } from './four_valves'
import { type Frame, panel } from './frame'
import { type CaseA, type CaseB, type Judged, MOBILITIES, SEGMENTS } from './types'
import { pressed } from './waits'

export interface FeedbackParts {
  frame: Frame
  four: FourValves
  title: string
  aside: HTMLElement
  signal: AbortSignal
}

export async function feedbackA(
  made: CaseA,
  judged: Judged,
  { frame, four, title, aside, signal }: FeedbackParts,
): Promise<void> {
  const next = button('Next', () => {}, { class: parts.primary })
  four.tell(made.answer, Number(judged.choice))
  const leaks = h(
    'table',
    {},
    h('tr', {}, h('th', { scope: 'col' }, 'Closed'), h('th', { scope: 'col' }, 'Leak')),
    ...made.choices.map(({ choice, leak_mm2 }) =>
      h('tr', {}, h('th', { scope: 'row' }, `Valve ${choice}`), h('td', {}, withUnit(leak_mm2, 'mm²'))),
    ),
  )
  const words = judged.right === 1 ? 'Right.' : `Not right: it was valve ${made.answer}.`
  frame.show(title, words, four.element, [panel('Answer', leaks, next), aside])
  await pressed(next, signal)
}

export async function feedbackB(
  made: CaseB,
  judged: Judged,
  { frame, title, aside, signal }: Omit<FeedbackParts, 'four'>,
): Promise<void> {
  const next = button('Next', () => {}, { class: parts.primary })
  const { pull_n, limit_mm } = made.limits
  frame.show(
    title,
    `${judged.right} of ${SEGMENTS.length} segments are right.`,
    panel(
      'Segments',
      segmentsTruth(made, judged.choice),
      h(
        'p',
        { class: parts.hint },
        `Each free edge was pulled towards the atrium with ${pull_n} N; more than ${limit_mm} mm lower than in the valve without lesions is tethered, as much higher prolapsing. Heights are above the annular plane.`,
      ),
    ),
    [panel('Answer', next), aside],
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
