// What this browser's trials say: shares of right answers against chance, confidence, time, ability; each trial; the table as a file.
import { button, download, h } from '../dom'
import { number, percent } from '../format'
import { labelledButton } from '../icons'
import { problemList } from '../problems'
import { problemsOf } from '../workspace'
import parts from '../style/parts.module.css'
import type { TrainEngine } from './engine'
import { panel } from './frame'
import trainStyle from './train.module.css'
import { deleteTrials, keptTrials, trialsCsv } from './trials'
import type { Score, Trial } from './types'

type Column<T> = readonly [title: string, of: (row: T) => string]

const SCORES: readonly Column<Score>[] = [
  ['Learner', ({ learner }) => String(learner)],
  ['Exam', ({ exam }) => exam],
  ['Block', ({ block }) => block ?? 'all'],
  ['Right', ({ right, answers }) => `${right} of ${answers}`],
  ['Share (95 %)', ({ share, interval95: [from, to] }) => `${percent(share)} (${percent(from)} to ${percent(to)})`],
  ['Chance', ({ chance }) => percent(chance)],
  ['By chance', ({ by_chance }) => number(by_chance, 3)],
  ['Brier', ({ brier }) => number(brier, 3)],
  ['Seconds', ({ seconds }) => number(seconds, 0)],
  ['Path, mm', ({ path_mm }) => number(path_mm, 0)],
  ['Largest, N', ({ largest_n }) => number(largest_n, 2)],
  ['Ability', ({ ability, ability_se }) => `${number(ability)} ± ${number(ability_se)}`],
]

const TRIALS: readonly Column<Trial>[] = [
  ['Learner', ({ learner }) => String(learner)],
  ['Trial', ({ trial }) => String(trial)],
  ['Block', ({ block }) => block],
  ['Case', ({ exam, seed }) => `${exam} ${seed}`],
  ['Valve', ({ valve }) => valve],
  ['Answer', ({ choice }) => choice],
  ['True', ({ answer }) => answer],
  ['Right', ({ right }) => String(right)],
  ['Sure', ({ confidence }) => percent(confidence)],
  ['Analysis, s', ({ seconds }) => number(seconds, 0)],
  ['Choice, s', ({ choosing_s }) => number(choosing_s, 0)],
  ['Path, mm', ({ path_mm }) => number(path_mm, 0)],
  ['Largest, N', ({ largest_n }) => number(largest_n, 2)],
  ['Visited', ({ visited }) => visited.join(' ')],
  ['From P1', ({ visited }) => (visited[0] === 'P1' ? 'yes' : 'no')],
]

export class Results {
  readonly element = h('div', { class: trainStyle.results })

  constructor(private readonly engine: TrainEngine) {}

  show(): void {
    const trials = keptTrials()
    if (trials.length === 0) {
      this.element.replaceChildren(panel('Results', h('p', {}, 'No trials yet.')))
      return
    }
    const scores = h('div', {}, 'Computing scores ...')
    this.element.replaceChildren(
      panel('Scores', scores),
      panel('Trials', this.tools(trials), table('Trials', TRIALS, [...trials].reverse())),
    )
    const ordered = [...trials].sort((a, b) => a.learner - b.learner || a.trial - b.trial)
    this.engine.scores(trialsCsv(ordered)).then(
      (said) => scores.replaceChildren(table('Scores', SCORES, said.scores), explained()),
      (error: unknown) => scores.replaceChildren(problemList(problemsOf(error))),
    )
  }

  private tools(trials: readonly Trial[]): HTMLElement {
    const save = labelledButton('save', 'Export CSV', 'Export CSV of all trials', () =>
      download('trials.csv', new Blob([trialsCsv(trials)], { type: 'text/csv' })),
    )
    const ask = labelledButton('remove', 'Delete all', 'Delete all trials', () => row.replaceChildren(save, sure, keep))
    const sure = button(`Delete ${trials.length === 1 ? 'the trial' : `${trials.length} trials`} for good`, () => {
      deleteTrials()
      this.show()
    })
    const keep = button('Keep', () => row.replaceChildren(save, ask))
    const row = h('p', { class: parts.row }, save, ask)
    return row
  }
}

function table<T>(name: string, columns: readonly Column<T>[], rows: readonly T[]): HTMLElement {
  return h(
    'div',
    { class: parts.scroll, tabindex: 0, role: 'group', 'aria-label': name },
    h(
      'table',
      { class: trainStyle.table, 'data-part': name.toLowerCase() },
      h('tr', {}, ...columns.map(([title]) => h('th', { scope: 'col' }, title))),
      ...rows.map((row) => h('tr', {}, ...columns.map(([, of]) => h('td', {}, of(row))))),
    ),
  )
}

function explained(): HTMLElement {
  return h(
    'details',
    { class: parts.more },
    h('summary', {}, 'Explanation of the columns'),
    h(
      'ul',
      { class: parts.hint },
      h('li', {}, 'Share: fraction of correct answers with its 95 % interval (Wilson); chance: by guessing.'),
      h('li', {}, 'By chance: probability of at least as many correct answers by guessing.'),
      h('li', {}, 'Brier: mean squared difference between confidence and result; 0 is best.'),
      h(
        'li',
        {},
        'Ability (Rasch model with guessing): difficulty at which the learner scores halfway between chance and 100 %.',
      ),
    ),
  )
}
