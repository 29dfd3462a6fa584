// What the answers of the reader say of the weights, and what can be done with it: order the plans, save a file.
import type { LearnedWeights } from '../api/types'
import { dataTable, figure } from '../charts/data_table'
import { button, h } from '../dom'
import { number } from '../format'
import { saveJson } from '../jobs/downloads'
import { informedWeights } from './preference_case'
import type { Weights } from './price'
import parts from '../style/parts.module.css'
import searchStyle from './search.module.css'

export interface LearnedBoard {
  element: HTMLElement
  show(learned: LearnedWeights): void
}

/// Not shown before there is an answer. `ordered` hears the weights by which plans should be ordered, null: the search's.
export function learnedBoard(own: Weights, ordered: (learned: Partial<Weights> | null) => void): LearnedBoard {
  let learned: LearnedWeights | null = null
  const said = h('div', { 'data-part': 'informed' })
  const tick = h('input', { type: 'checkbox', onchange: () => order() })
  const order = () => ordered(tick.checked && learned ? learned.weights : null)
  const element = h(
    'div',
    { class: searchStyle.learned, 'data-part': 'learned', hidden: true },
    h('h3', {}, 'Learned weights'),
    said,
    h('label', { class: parts.check }, tick, 'Rank plans by the learned weights'),
    h('p', { class: parts.hint }, 'Acceptable plans that open far enough still come first.'),
    h(
      'div',
      { class: parts.row },
      button('Save the weights (JSON)', () => saveJson('weights.json', learned)),
      h(
        'span',
        { class: parts.hint },
        'For a search with them: ',
        h('code', {}, 'coapt plan VALVE --weights weights.json'),
      ),
    ),
  )

  function show(shown: LearnedWeights): void {
    const wasOrdered = tick.checked
    learned = shown
    element.hidden = shown.answers === 0
    if (element.hidden) tick.checked = false // nobody could untick it
    const rows = informedWeights(shown, own)
    said.replaceChildren(
      rows.length > 0
        ? dataTable(
            'Weights constrained by the answers',
            [
              { label: 'Weight', sentences: true },
              { label: 'Default', numeric: true },
              { label: 'Learned', numeric: true },
              { label: 'Factor', numeric: true },
            ],
            rows.map(({ label, own, learned }) => [
              label,
              figure(own),
              figure(learned),
              own > 0 ? `× ${number(learned / own, 2)}` : '',
            ]),
          )
        : h('p', {}, 'Your answers have not narrowed any weight yet; about ten are usually needed.'),
    )
    if (wasOrdered) order()
  }

  return { element, show }
}
