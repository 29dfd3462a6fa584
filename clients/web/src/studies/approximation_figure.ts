// Papillary sutures to the trigone against the saddle peak (figure 4.10 of the thesis), and anchors around the annulus.
import { dataTable, figure } from '../charts/data_table'
import { lineChart } from '../charts/line_chart'
import type { Hue } from '../charts/colours'
import { field, h, select } from '../dom'
import { number, percent, words } from '../format'
import { classesIn, classTitle } from './classes'
import { distinct, mean, numberIn, type Row } from './csv'
import { histogram } from './histogram'
import chartsStyle from '../charts/charts.module.css'
import parts from '../style/parts.module.css'
import studiesStyle from './studies.module.css'

const BINS = 16
const MEASURES = [
  ['region_mean_mm2', 'mean orifice of the region, mm²'],
  ['region_sd_mm2', 'sd of the orifice in the region, mm²'],
] as const
type Measure = (typeof MEASURES)[number][0]

/// Redrawn for each protocol and measure; what is drawn belongs to `signal`.
export function approximationFigure(rows: Row[], signal: AbortSignal): HTMLElement {
  const protocols = distinct(rows, 'protocol')
  let [protocol = ''] = protocols
  let measure: Measure = MEASURES[0][0]
  const charts = h('div', { class: chartsStyle.charts })
  let drawn = new AbortController()
  signal.addEventListener('abort', () => drawn.abort())

  function draw(): void {
    drawn.abort()
    drawn = new AbortController()
    const of = rows.filter((row) => row.protocol === protocol)
    charts.replaceChildren(
      ...classesIn(of).map((name) =>
        samplesChart(
          of.filter((row) => row.class === name),
          name,
          measure,
          drawn.signal,
        ),
      ),
    )
  }
  const choose =
    <T extends string>(set: (value: T) => void) =>
    (value: string) => {
      set(value as T)
      draw()
    }
  draw()
  return h(
    'div',
    {},
    h(
      'p',
      { class: parts.hint },
      'Number of displaced configurations by the mean (or sd) of the orifice over their region of interest after repair; further left is better.',
    ),
    h(
      'div',
      { class: studiesStyle.sliceChoice },
      field(
        'Protocol',
        select(
          protocols.map((name): [string, string] => [name, words(name)]),
          protocol,
          choose((value) => (protocol = value)),
        ),
      ),
      field(
        'Measure',
        select(
          MEASURES,
          measure,
          choose<Measure>((value) => (measure = value)),
        ),
      ),
    ),
    charts,
  )
}

function samplesChart(rows: Row[], name: string, measure: Measure, signal: AbortSignal): HTMLElement {
  const anchors = distinct(rows, 'anchor')
  const samples = anchors.map((anchor) =>
    rows.filter((row) => row.anchor === anchor).map((row) => numberIn(row, measure)),
  )
  const { edges, counts } = histogram(samples, BINS)
  const means = anchors.map((anchor, i) => `${anchor} ${number(mean(samples[i] ?? []))} mm²`).join(', ')
  const label = MEASURES.find(([column]) => column === measure)?.[1] ?? ''
  return lineChart(
    {
      title: `${classTitle(name)} (${samples[0]?.length ?? 0})`,
      summary: `Means: ${means}.`,
      x: { label },
      y: { label: 'configurations' },
      series: anchors.map((anchor, i) => ({
        label: `${anchor}, mean ${number(mean(samples[i] ?? []))}`,
        hue: i as Hue,
        look: 'steps',
        x: edges,
        y: [...(counts[i] ?? []), 0],
      })),
    },
    signal,
  ).element
}

/// anchors.csv: each anchor over all displaced configurations of a class.
export function anchorsTable(rows: Row[]): HTMLElement {
  const columns = [
    ['mean_mm2', 'mean'],
    ['sd_mm2', 'sd'],
    ['sd_of_means_mm2', 'sd of means'],
    ['length_slope_mm2_per_mm', 'slope by length'],
    ['swing_slope_mm2_per_mm', 'slope by swing'],
    ['movement_mm', 'movement, mm'],
    ['suture_mm', 'suture, mm'],
  ] as const
  return dataTable(
    'Anchors; mm², slopes in mm² per mm of tip movement',
    [
      { label: 'protocol' },
      { label: 'displaced' },
      { label: 'anchor' },
      { label: 'repaired' },
      ...columns.map(([, label]) => ({ label, numeric: true })),
      { label: 'outside the grid', numeric: true },
    ],
    rows.map((row) => [
      row.protocol,
      row.class,
      row.anchor,
      `${row.repaired ?? ''} of ${row.configurations ?? ''}`,
      ...columns.map(([column]) => figure(numberIn(row, column))),
      percent(numberIn(row, 'clamped_share')),
    ]),
  )
}

/// anchor-scan.csv: mean and sd once around the annulus, by class; `levels` are trigone and saddle peak.
export function scanFigure(rows: Row[], levels: Row[], signal: AbortSignal): HTMLElement {
  const protocol = rows[0]?.protocol ?? ''
  const same = levels.filter((row) => row.protocol === protocol)
  const panels = (
    [
      ['mean_mm2', 'mean orifice, mm²'],
      ['sd_mm2', 'sd of the orifice, mm²'],
    ] as const
  ).flatMap(([column, label]) => classesIn(rows).map((name) => scanChart(name, column, label, rows, same, signal)))
  return h(
    'div',
    {},
    h(
      'p',
      { class: parts.hint },
      'Position: fraction of the annulus from the posteromedial commissure (0) over the saddle peak (0.25) to the anterolateral commissure (0.5) and onwards; mirrored for the anterolateral muscle.',
    ),
    h('div', { class: chartsStyle.charts }, ...panels),
  )
}

function scanChart(
  name: string,
  column: string,
  label: string,
  rows: Row[],
  levels: Row[],
  signal: AbortSignal,
): HTMLElement {
  const of = rows
    .filter((row) => row.class === name)
    .sort((a, b) => (numberIn(a, 'around') ?? 0) - (numberIn(b, 'around') ?? 0))
  const known = of.map((row) => ({ at: numberIn(row, 'around') ?? 0, value: numberIn(row, column) }))
  if (known[0]?.at === 0) known.push({ ...known[0], at: 1 }) // once around
  const least = known.reduce(
    (best, one) => (one.value !== null && (best.value === null || one.value < best.value) ? one : best),
    { at: 0, value: null as number | null },
  )
  return lineChart(
    {
      title: classTitle(name),
      summary: `Minimum: ${number(least.value)} mm² at ${number(least.at, 2)}.`,
      x: { label: 'anchor position', lowest: 0, highest: 1 },
      y: { label },
      series: [
        { label: 'on the annulus', hue: 2, x: known.map(({ at }) => at), y: known.map(({ value }) => value) },
        ...levels
          .filter((row) => row.class === name)
          .map((row, i) => ({
            label: row.anchor ?? '',
            hue: i as Hue,
            look: 'dashed' as const,
            x: [0, 1],
            y: [numberIn(row, column), numberIn(row, column)],
          })),
      ],
    },
    signal,
  ).element
}
