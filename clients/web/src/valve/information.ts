// What measuring more of the valve would tell of its leak: the best measurement in a sentence, all of them in a table, and where
// what was measured is entered.
import type { Information } from '../api/types'
import { dataTable } from '../charts/data_table'
import { button, h } from '../dom'
import { counted, number, percent, typeset } from '../format'
import { openBubble } from '../help/term'
import { HAS_SERVICE } from '../mode'
import helpStyle from '../help/help.module.css'
import parts from '../style/parts.module.css'
import valveStyle from './valve.module.css'

const TELLING = 0.3 // of the variance: what tells less of it is not named
const PATIENCE = 200 // frames until another view is there

/// What tells of all measurements when it is pressed.
export function narrowing(drawn: Information): HTMLElement {
  const words = narrowingWords(drawn)
  const element = button(words, () => openBubble(element, table(drawn)), {
    class: helpStyle.term,
    'data-part': 'narrowing',
    'aria-haspopup': 'dialog',
  })
  return element
}

/// The measurement of the valve that would tell most of it.
export function narrowingWords({ rows: [first] }: Pick<Information, 'rows'>): string {
  return first && (first.share_removed ?? 0) >= TELLING
    ? `To narrow it, measure first: ${typeset(first.measurement)}`
    : 'What would narrow it'
}

function table({ rows, leak, draws, observed }: Information): HTMLElement {
  const seen = observed.length > 0 ? `, weighted by what was observed (${observed.map(typeset).join('; ')})` : ''
  return h(
    'div',
    {
      class: valveStyle.hearts,
      'data-part': 'information',
      role: 'dialog',
      'aria-label': 'What would narrow the leak',
    },
    h(
      'p',
      {},
      `The leak has a standard deviation of ${number(leak.sd_mm2)} mm² over ${counted(draws, 'variant')} of tissue and chordae${seen}. The share of this variance that one more measurement would remove, and what it would leave:`,
    ),
    dataTable(
      'Measurements, most informative first',
      [{ label: 'Measured' }, { label: 'removes', numeric: true }, { label: 'leaves, mm²', numeric: true }],
      rows.map((row) => [typeset(row.measurement), percent(row.share_removed), number(row.remaining_mm2)]),
    ),
    h(
      'p',
      { class: parts.row },
      button('Enter what images show', () => void unfold('observed')),
      HAS_SERVICE && button('Fit to closed leaflets', () => void unfold('import')),
    ),
  )
}

/// Opens a fold of the Valve view, from whatever view.
async function unfold(part: 'observed' | 'import'): Promise<void> {
  const find = () => document.querySelector<HTMLDetailsElement>(`details[data-part=${part}]`)
  if (!find()) location.hash = '#/valve'
  for (let i = 0; i < PATIENCE && !find(); ++i) await new Promise(requestAnimationFrame)
  const fold = find()
  if (!fold) return
  document.querySelector<HTMLElement>('[data-part=help]')?.hidePopover()
  fold.open = true
  fold.scrollIntoView({ block: 'nearest' })
  fold.querySelector<HTMLElement>('input:not([type=file]), button')?.focus()
}
