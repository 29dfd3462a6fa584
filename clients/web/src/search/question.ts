// Which of two ranked plans the reader would rather do: both side by side, a button for each, one between them.
import type { Preference, PreferenceAnswer, RankedPlan } from '../api/types'
import { button, h } from '../dom'
import { photo, type CardContext } from './card'
import { FIGURES, shownFigure } from './figures'
import parts from '../style/parts.module.css'
import searchStyle from './search.module.css'

/// As the service's own question has them.
const SHOWN = ['Leak with errors of execution, mean', 'Opening in diastole', 'Reserve against progression']

export interface QuestionBoard {
  element: HTMLElement
  show(question: Preference['question']): void
  hideFigures(hidden: boolean): void
  focus(): void // its heading: no answer is given by pressing a key once more
}

/// `answered` hears what to add to the answers.
export function questionBoard(
  plans: RankedPlan[],
  context: CardContext,
  answered: (answer: PreferenceAnswer) => void,
): QuestionBoard {
  const heading = h('h3', { tabindex: -1 }, 'No question yet.')
  const board = h('div', { class: searchStyle.question })
  const pictures = new Map<number, HTMLElement>() // by rank: each is drawn once
  let figures: HTMLElement[] = []
  let areHidden = false

  function picturesOf(plan: RankedPlan): HTMLElement {
    const known = pictures.get(plan.rank) ?? drawPictures(plan, context)
    pictures.set(plan.rank, known)
    return known
  }

  function show(question: Preference['question']): void {
    const [first, second] = [question?.first, question?.second].map((rank) => plans.find((plan) => plan.rank === rank))
    heading.textContent =
      first && second
        ? `Plan ${first.rank} or plan ${second.rank}?`
        : 'No question is left; all pairs have been compared.'
    figures = []
    board.replaceChildren()
    if (!question || !first || !second) return
    const give = (answer: PreferenceAnswer['answer']) => () =>
      answered({ case: question.case, first: question.first, second: question.second, answer })
    board.append(
      side(first, give('first')),
      h('div', { class: searchStyle.between }, button('Cannot decide', give('unable'))),
      side(second, give('second')),
    )
    hideFigures(areHidden)
  }

  function side(plan: RankedPlan, prefer: () => void): HTMLElement {
    const these = button('This one', prefer, { class: parts.primary })
    these.append(h('span', { class: parts.unseen }, ` plan ${plan.rank}`))
    const known = FIGURES.filter(({ label }) => SHOWN.includes(label)).map((figure) =>
      h('div', {}, h('dt', {}, figure.label), h('dd', {}, shownFigure(figure, plan))),
    )
    const fold = h('div', {}, h('dl', { class: searchStyle.planFigures }, ...known)) // a grid is not hidden
    figures.push(fold)
    return h(
      'div',
      { class: searchStyle.side, role: 'group', 'aria-label': `Plan ${plan.rank}` },
      picturesOf(plan),
      h('h4', {}, `Plan ${plan.rank}`),
      h(
        'ul',
        { class: searchStyle.steps },
        ...(plan.description.length > 0 ? plan.description : ['no repair']).map((step) => h('li', {}, step)),
      ),
      fold,
      these,
    )
  }

  function hideFigures(hidden: boolean): void {
    areHidden = hidden
    for (const fold of figures) fold.hidden = hidden
    board.toggleAttribute('data-plain', hidden) // nor does the cut tell how high the leaflets meet
  }

  return {
    element: h('div', { 'data-part': 'question' }, heading, board),
    show,
    hideFigures,
    focus: () => heading.focus({ preventScroll: true }),
  }
}

/// The valve as the plan leaves it: closed, open, cut.
function drawPictures(plan: RankedPlan, context: CardContext): HTMLElement {
  const { photos } = context
  const named = (name: string, picture: HTMLElement) => h('figure', {}, picture, h('figcaption', {}, name))
  const of = `after plan ${plan.rank}`
  return h(
    'div',
    { class: searchStyle.pictures },
    named('Closed, seen from the atrium', photo(plan, context)),
    named(
      'Open in diastole',
      photos.photo(plan.plan, `The valve open in diastole, seen from the atrium ${of}`, 'open'),
    ),
    named(
      'Closed, mid-valve section',
      photos.section(plan.plan, `Section through the middle of the closed valve ${of}`),
    ),
  )
}
