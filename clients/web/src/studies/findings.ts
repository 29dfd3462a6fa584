// What the thesis found beside what this valve shows.
import type { Finding, StudyResult } from '../api/types'
import { dataTable } from '../charts/data_table'
import { h } from '../dom'
import { grouped, seconds, typeset } from '../format'
import parts from '../style/parts.module.css'

const MOST_OPEN = 6 // a longer table stands folded above the figures

export function findingsTable(result: StudyResult): HTMLElement {
  const { findings } = result
  const facts: [string, string][] = [
    ['findings that agree', `${result.agree} of ${findings.length}`],
    ['configurations', grouped(result.configurations)],
    ['newly closed', grouped(result.closures - result.closures_known)],
    ['unreliable', grouped(result.untrusted)],
    ['time', seconds(result.seconds)],
  ]
  return h(
    'section',
    { class: parts.panel, 'aria-label': 'Findings' },
    h('h2', {}, 'Findings of the thesis on this valve'),
    h(
      'dl',
      { class: parts.figures },
      ...facts.map(([name, value]) => h('div', {}, h('dt', {}, name), h('dd', {}, value))),
    ),
    findings.length === 0
      ? h('p', {}, 'None, because no displacement causes a leak large enough to repair.')
      : h(
          'details',
          { class: parts.more, open: findings.length <= MOST_OPEN },
          h(
            'summary',
            {},
            `${findings.length} findings: ${result.agree} agree, ${findings.length - result.agree} ${findings.length - result.agree === 1 ? 'differs' : 'differ'}`,
          ),
          dataTable(
            'Findings',
            [
              { label: 'finding' },
              { label: 'section' },
              { label: 'thesis', sentences: true },
              { label: 'here', sentences: true },
              { label: 'verdict' },
              { label: 'criterion', sentences: true },
            ],
            findings.map((finding) => [
              finding.finding.replaceAll('-', ' ').replace('/', ': '),
              finding.section,
              typeset(finding.thesis),
              typeset(finding.ours),
              verdict(finding),
              typeset(finding.judged),
            ]),
          ),
        ),
  )
}

function verdict(finding: Finding): HTMLElement {
  return finding.agrees
    ? h('span', { class: `${parts.verdict} ${parts.good}`, 'data-part': 'verdict' }, '✓ agrees')
    : h('span', { class: `${parts.verdict} ${parts.warn}`, 'data-part': 'verdict' }, '≠ differs')
}
