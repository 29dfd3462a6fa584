// The valve that is open beside what was measured in hearts: a row for each quantity.
import { comparePhysiology } from '../api/calls'
import type { Physiology, PhysiologyRow } from '../api/types'
import { dataTable, figure } from '../charts/data_table'
import { h, type Child } from '../dom'
import { number, typeset } from '../format'
import { explained } from '../help/term'
import type { Workspace } from '../workspace'
import { valveQuestion } from './valve_question'
import parts from '../style/parts.module.css'
import valveStyle from './valve.module.css'

const VERDICTS: Record<PhysiologyRow['verdict'], readonly [sign: string, tone: string]> = {
  met: ['✓ met', 'good'],
  below: ['↓ below', 'warn'],
  above: ['↑ above', 'warn'],
  unknown: ['? unknown', 'soft'],
  'no range': ['– no range', 'soft'],
}
const KINDS: Record<Physiology['kind'], string> = {
  healthy: 'healthy valves',
  functional: 'valves with functional regurgitation',
  prolapse: 'valves with prolapse',
}

export function heartsPanel(workspace: Workspace): HTMLElement {
  const question = valveQuestion(workspace, {
    labels: ['Compare with measurements'],
    busy: 'Comparing with measurements',
    ask: async ({ reference }, signal) => rowsOf(await comparePhysiology(reference, signal)),
    style: valveStyle.hearts,
  })
  return h(
    'section',
    { class: parts.panel, 'aria-label': 'Comparison with measurements', 'data-part': 'hearts' },
    h('h2', {}, 'Comparison with measured hearts'),
    h(
      'p',
      { class: parts.hint },
      'Compares loads, strains, rings, opening and clips of this valve with published measurements. The valve is closed and opened 17 times, which takes some seconds.',
    ),
    ...question.buttons,
    question.progress,
    question.answer,
  )
}

function rowsOf({ kind, kind_judged, species, rows }: Physiology): HTMLElement[] {
  const met = rows.filter(({ verdict }) => verdict === 'met').length
  const ranges = rows.filter(({ low }) => low !== null).length
  const judged = kind_judged ? ', inferred from the closed valve' : ''
  return [
    h('p', {}, h('strong', { 'data-part': 'met' }, `${met} of ${ranges} quantities are within their ranges.`)),
    h(
      'p',
      { class: parts.hint },
      `The ranges are those of ${species} ${KINDS[kind]}${judged}. Press a quantity to read the source of its range.`,
    ),
    dataTable(
      'This valve compared with measured hearts',
      [{ label: 'Quantity' }, { label: over('This valve', 'measured'), numeric: true }, { label: 'Verdict' }],
      rows.map((row) => [name(row), over(value(row), range(row)), verdict(row)]),
    ),
  ]
}

/// One line over another, softer one.
function over(words: string, below: string): HTMLElement {
  return h('div', {}, words, h('div', { class: parts.hint }, below))
}

function name({ what, source }: PhysiologyRow): Child {
  return source === null ? typeset(what) : explained(typeset(what), typeset(source))
}

function verdict({ verdict }: PhysiologyRow): Child {
  const [words, tone] = VERDICTS[verdict]
  return h('span', { class: `${parts.verdict} ${parts[tone]}` }, words)
}

function value({ value, unit }: PhysiologyRow): string {
  return value === null ? number(value) : withUnit(figure(value), unit)
}

/// In the unit that the value tells above it, if there is one.
function range({ value, low, high, unit }: PhysiologyRow): string {
  return low === null ? '' : withUnit(`${low} to ${high}`, value === null ? unit : '')
}

function withUnit(figures: string, unit: string): string {
  return unit === '' ? figures : `${figures} ${typeset(unit)}`
}
