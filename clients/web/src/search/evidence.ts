// What speaks for and against one plan: its leak over the region, further remodelling, the rules of practice.
import type { Gate, LeakMap, RankedPlan } from '../api/types'
import { dataTable } from '../charts/data_table'
import { heatMap, heatScale } from '../charts/heat_map'
import { lineChart } from '../charts/line_chart'
import type { Hue } from '../charts/colours'
import { h, type Child } from '../dom'
import { number, percent, typeset, words } from '../format'
import { lengthName } from './figures'
import parts from '../style/parts.module.css'
import searchStyle from './search.module.css'

// Of all leak maps, here and in the report (io/picture/evidence_figure.cpp): none or trace below 1, mild below 5.
export const LEAK_LIMITS_MM2 = [0.5, 1, 2, 3, 5, 10, 20]

const signed = (value: number, digits: number) => (value > 0 ? '+' : '') + number(value, digits)

export function leakMap(map: LeakMap, plan: RankedPlan): HTMLElement {
  const length = lengthName(plan, map.muscle)
  const muscle =
    map.muscle === 'both'
      ? 'Both muscles, same error'
      : `${map.muscle[0]?.toUpperCase()}${map.muscle.slice(1)} muscle alone`
  const lengths = [...map.suture_length_mm].reverse() // the longest above, as in the report
  return heatMap({
    title: `${muscle}: leak, mm².`,
    unit: 'mm²',
    rows: { label: `${length}, mm`, ticks: lengths.map((value) => signed(value, 2)) },
    columns: { label: 'muscle outwards, degrees', ticks: map.outwards_deg.map((value) => signed(value, 0)) },
    values: [...map.leak_mm2].reverse(),
    limits: LEAK_LIMITS_MM2,
    marked: { row: lengths.indexOf(0), column: map.outwards_deg.indexOf(0) },
  })
}

export function evidence(plan: RankedPlan, signal: AbortSignal): HTMLElement {
  return h(
    'div',
    { class: searchStyle.evidence },
    ...maps(plan),
    ...remodelling(plan, signal),
    ...sobol(plan),
    ...gates(plan.gates),
  )
}

function maps(plan: RankedPlan): Child[] {
  if (plan.leak_map.length === 0) return []
  const alone = plan.independent_leak_mm2
  return [
    h('h4', {}, `Leak when ${lengthName(plan)} and position of the muscles deviate from the plan`),
    h('div', { class: searchStyle.maps }, ...plan.leak_map.map((map) => leakMap(map, plan))),
    heatScale(LEAK_LIMITS_MM2, 'mm²'),
    alone.mean !== null &&
      h(
        'p',
        { class: parts.hint },
        `With independent errors of each muscle, the ring and its sutures, and neochordae, the leak is ${number(alone.mean)} mm² on average, below ${number(alone.p95)} mm² in 95 % of cases, and ${number(alone.worst)} mm² at worst.`,
      ),
  ]
}

function remodelling(plan: RankedPlan, signal: AbortSignal): Node[] {
  const curves = plan.remodelling.filter((curve) => curve.leak_mm2.some((leak) => leak !== null))
  if (curves.length === 0) return []
  const ends = curves.map((curve) => `${curve.direction} ${number(curve.leak_mm2.at(-1))} mm²`).join('; ')
  const chart = lineChart(
    {
      title: 'Leak with further ventricular remodelling',
      summary: `Leak at the end of further remodelling: ${ends}.`,
      x: { label: 'further remodelling, mm' },
      y: { label: 'leak, mm²' },
      series: curves.map((curve, i) => ({
        label: words(curve.direction),
        hue: (i % 6) as Hue,
        x: curve.leak_mm2.map((_, mm) => mm),
        y: curve.leak_mm2,
      })),
    },
    signal,
  )
  return [chart.element]
}

function sobol(plan: RankedPlan): Node[] {
  const axes = [
    ['suture_length', lengthName(plan)],
    ['outwards', 'angle outwards'],
    ['posterior', 'angle to posterior'],
  ] as const
  const { first, total } = plan.sobol
  if (axes.every(([axis]) => total[axis] === null)) return []
  return [
    h('h4', {}, 'Sensitivity to errors of execution'),
    dataTable(
      'Sobol indices of the leak',
      [{ label: 'error of' }, { label: 'alone', numeric: true }, { label: 'total', numeric: true }],
      axes.map(([axis, label]) => [label, percent(first[axis]), percent(total[axis])]),
    ),
  ]
}

const VERDICTS: Record<Gate['severity'], [words: string, tone: string]> = {
  pass: ['✓ pass', 'good'],
  warn: ['! warn', 'warn'],
  reject: ['✗ reject', 'bad'],
  not_assessed: ['– not assessed', 'soft'],
}

function gates(list: Gate[]): Node[] {
  if (list.length === 0) return []
  return [
    h('h4', {}, 'Rules of practice'),
    dataTable(
      'Rules of practice',
      [{ label: 'rule' }, { label: 'verdict' }, { label: 'finding', sentences: true }, { label: 'source' }],
      list.map((gate) => {
        const [verdict, tone] = VERDICTS[gate.severity]
        return [
          words(gate.rule),
          h('span', { class: `${parts.verdict} ${parts[tone]}`, 'data-part': 'verdict' }, verdict),
          typeset(gate.finding),
          gate.source,
        ]
      }),
    ),
  ]
}
