// Which plans the reader prefers, asked two by two: the service says after each answer what it tells of the weights, and
// what to ask next. It keeps nothing: each request brings the plans and all answers, which this browser keeps.
import { learnPreference } from '../api/calls'
import { ApiError } from '../api/http'
import type { Preference, PreferenceAnswer, Problem, RankedPlan } from '../api/types'
import { button, h } from '../dom'
import { problemList } from '../problems'
import { keepAnswers, keptAnswers } from '../state/answers'
import { problemsOf } from '../workspace'
import type { CardContext } from './card'
import { learnedBoard } from './learned'
import { preferenceCase, standing } from './preference_case'
import type { Weights } from './price'
import { questionBoard } from './question'
import parts from '../style/parts.module.css'
import searchStyle from './search.module.css'

/// `ordered` hears by which weights the plans should be ordered, null: those of the search. Asks for nothing until it is
/// opened.
export function learning(
  plans: RankedPlan[],
  own: Weights,
  context: CardContext,
  ordered: (learned: Partial<Weights> | null) => void,
): HTMLElement {
  const { job, signal } = context
  const of = preferenceCase(job.id, plans, own)
  let answers = keptAnswers(job.id)
  let preference: Preference | null = null

  const question = questionBoard(plans, context, (answer) => void go([...answers, answer]))
  const learned = learnedBoard(own, ordered)
  const status = h('p', { role: 'status', 'data-part': 'standing' })
  const told = h('div', {})
  const hide = h('input', { type: 'checkbox', onchange: () => question.hideFigures(hide.checked) })
  const back = button('Undo the last answer', () => void go(answers.slice(0, -1)))
  const anew = button('Start again', () => void go([]))
  const controls = h(
    'fieldset', // disabled as a whole
    { class: searchStyle.learning, 'aria-label': 'Pairwise comparison of plans' },
    h('label', { class: parts.check }, hide, 'Hide figures'),
    question.element,
    h('div', { class: parts.row }, back, anew),
  )

  /// The buttons may lose the focus, as they are disabled or gone.
  function go(given: PreferenceAnswer[]): Promise<void> {
    question.focus()
    return ask(given)
  }

  /// Of answers that the service does not take nothing is kept; the question before remains.
  async function ask(given: PreferenceAnswer[]): Promise<void> {
    controls.disabled = true
    try {
      preference = await learnPreference(of, given, hide.checked, signal)
      answers = given
      keepAnswers(job.id, answers)
      question.show(preference.question)
      learned.show(preference.learned)
      status.textContent = standing(preference)
      told.replaceChildren()
      controls.hidden = false // the service may have become newer
    } catch (error) {
      controls.hidden = isOlderService(error)
      if (!signal.aborted) told.replaceChildren(problemList(refusal(error)))
    }
    controls.disabled = false
    back.disabled = answers.length === 0
    anew.disabled = answers.length === 0 && preference !== null
  }

  const details = h(
    'details',
    { class: parts.more },
    h('summary', {}, 'Compare plans in pairs to learn your preferences'),
    h(
      'p',
      { class: parts.hint },
      'Your answers determine the weights of leak, opening, reserve and operative effort. They are stored only in this browser.',
    ),
    status,
    controls,
    told,
    learned.element,
  )
  details.addEventListener('toggle', () => {
    if (details.open && preference === null && !controls.disabled) void ask(answers)
  })
  return h(
    'section',
    { class: parts.panel, 'data-part': 'learning', 'aria-label': 'Which plan do you prefer?' },
    details,
  )
}

function isOlderService(error: unknown): boolean {
  return error instanceof ApiError && (error.status === 404 || error.status === 405)
}

function refusal(error: unknown): Problem[] {
  if (!isOlderService(error)) return problemsOf(error)
  const message = 'This service cannot learn preferences because it is older than this page.'
  return [{ code: 'failed', path: '', message }]
}
