// What if it ends elsewhere? Of the handle that was grabbed last: the surface around it, its margin, the leak over each way to miss.
import { close } from '../api/calls'
import type { Plan, Rings, Step, Vector } from '../api/types'
import { lineChart, type DrawnChart } from '../charts/line_chart'
import type { Series } from '../charts/series'
import { h, select } from '../dom'
import { counted, number, withUnit } from '../format'
import { HAS_SERVICE } from '../mode'
import { tellReadings, type ToleranceWords } from '../state/readings'
import type { BubbleSurface } from '../viewer/bubble'
import { BALANCED, type Scale } from '../viewer/colours'
import { plus, times } from '../viewer/geometry'
import { legend } from '../viewer/legend'
import type { Viewer } from '../viewer/viewer'
import type { Workspace } from '../workspace'
import { missesOf, type Misses, widened } from './errors'
import { handlesOf } from './handles'
import { leakAt, sampleOf, type Tolerance, TRACE_MM2, varied, wordsOf } from './tolerance'
import parts from '../style/parts.module.css'

const NONE = ''
const AT_ONCE = HAS_SERVICE ? 2 : 1 // closures: the engine beside the page has one thread
const REST_MS = 250 // the hand rests
const UNITS = 3 // how far the surface reaches
const ROWS = 6
const ANGLES = 32
const ABOVE_MM = 2 // a band around the annulus lies upon the ring
const SCALE_MM2 = 10 // of the surface around a handle

export class TolerancePanel {
  readonly element: HTMLElement
  private readonly said = h('p', { 'data-part': 'tolerance', 'aria-live': 'polite' })
  private readonly progress = h('p', { class: parts.hint, 'data-part': 'tolerance-progress' })
  private readonly scale = h('div', {})
  private readonly curves = h('div', {})
  private readonly choice = select([[NONE, 'nothing']], NONE, (key) => this.grab(key))
  private chart: DrawnChart | null = null
  private key = NONE // of the handle that was grabbed
  private asked = '' // valve, plan and handle that are varied
  private work = new AbortController()

  constructor(
    private readonly workspace: Workspace,
    private readonly viewer: Viewer,
    private readonly rings: () => Rings,
  ) {
    this.choice.setAttribute('aria-label', 'Step with an error of execution')
    this.element = h(
      'section',
      { class: parts.panel, 'aria-label': 'Error of execution' },
      h('h2', {}, 'Error of execution'),
      h('label', { class: parts.field }, h('span', {}, 'Vary'), this.choice),
      this.said,
      this.scale,
      this.curves,
      this.progress,
    )
    this.tellNothing()
  }

  /// A handle's key, or none.
  grab(key: string): void {
    this.key = key
    this.follow()
  }

  /// The plan at hand, once it is closed and no value is dragged.
  follow(): void {
    const { valve, plan, before, after, isAnswered, isDragging } = this.workspace
    if (!before || !after || !valve || plan.steps.length === 0) {
      this.end()
      return
    }
    if (!isAnswered || isDragging) return
    const handles = handlesOf(plan, { before, ringed: after }, this.rings())
    this.list(handles.map(({ handle: { key, name } }) => [key, name] as const))
    const found = handles.find(({ handle }) => handle.key === this.key)
    if (!found) {
      this.end()
      return
    }
    const asked = JSON.stringify([valve.reference, plan.steps, this.key])
    if (asked === this.asked) return
    this.stop()
    this.asked = asked
    const first = handles.findIndex(({ step }) => step === found.step)
    const misses = missesOf(
      plan.steps[found.step] as Step,
      handles.indexOf(found) - first,
      { before, ringed: after },
      this.rings(),
    )
    if (misses) void this.vary(misses, found.step, plan, valve.reference)
  }

  /// Nothing is varied any more.
  end(): void {
    if (this.asked === '' && this.choice.value === NONE) return
    this.stop()
    this.key = NONE
    this.list([])
    this.tellNothing()
  }

  private list(handles: (readonly [key: string, name: string])[]): void {
    this.choice.replaceChildren(
      ...[[NONE, 'nothing'] as const, ...handles].map(([key, name]) => h('option', { value: key }, name)),
    )
    this.choice.value = this.key
  }

  private stop(): void {
    this.work.abort()
    this.work = new AbortController()
    this.asked = ''
    this.chart = null
    this.viewer.bubble(null)
    this.viewer.mark([])
    tellReadings({ tolerance: null })
  }

  private tellNothing(): void {
    this.said.textContent =
      'Grab a handle on the repaired valve, or choose a step here, to close the valve with errors in its placement.'
    for (const part of [this.scale, this.curves, this.progress]) part.replaceChildren()
  }

  private async vary(misses: Misses, i: number, plan: Plan, valve: string): Promise<void> {
    const { after } = this.workspace
    const { signal } = this.work
    if (!after) return
    this.said.textContent = 'Closing the valve with errors in its placement ...'
    for (const part of [this.scale, this.curves, this.progress]) part.replaceChildren()
    await new Promise((rest) => setTimeout(rest, REST_MS))
    if (signal.aborted) return
    const planned = sampleOf(
      misses.ways.map(() => 0),
      after.closure,
    )
    const closed = (step: Step) => {
      const steps = plan.steps.map((other, at) => (at === i ? step : other))
      return close(valve, { ...plan, steps }, signal)
    }
    await varied(misses, planned, closed, (known) => this.show(misses, known), { atOnce: AT_ONCE, signal })
  }

  private show(misses: Misses, known: Tolerance): void {
    const scale: Scale = { title: 'leak if placed here', unit: 'mm²', from: 0, to: SCALE_MM2, stops: BALANCED }
    const words = wordsOf(known, misses, TRACE_MM2)
    tellReadings({ tolerance: words })
    this.viewer.bubble(this.surface(misses, known, scale))
    const at_mm = misses.placeAt(misses.ways.map(() => 0))
    const label = words?.margin ? `margin ${words.margin}` : 'leaks as planned'
    if (words && at_mm) this.viewer.mark([{ point_mm: at_mm, text: label, kind: 'distance' }])
    this.said.textContent = words ? sentence(words, misses) : ''
    this.scale.replaceChildren(legend('leaflets', scale, []))
    const untrusted = known.samples.filter(({ leak_mm2 }) => leak_mm2 === null).length
    this.progress.textContent =
      `${counted(known.samples.length, 'closure')}${known.isDone ? '' : ', more in progress'}.` +
      (untrusted > 0 ? ` ${untrusted} of them ${untrusted === 1 ? 'is' : 'are'} unreliable and excluded.` : '')
    this.drawCurves(misses, known)
  }

  private drawCurves(misses: Misses, known: Tolerance): void {
    const series = curves(misses, known)
    const summary = series.map(curveWords).join(' ')
    if (this.chart) {
      this.chart.show(series, summary)
      return
    }
    this.chart = lineChart(
      {
        title: 'Leak versus error of execution',
        summary,
        x: { label: 'error, mm', lowest: -UNITS * misses.unit.mm, highest: UNITS * misses.unit.mm },
        y: { label: 'leak, mm²' },
        series,
      },
      this.work.signal,
    )
    this.curves.replaceChildren(
      this.chart.element,
      h(
        'ul',
        { class: parts.hint },
        ...misses.ways.map(({ name, signs: [less, more] }) =>
          h('li', {}, `${name}: below zero ${less}, above it ${more}`),
        ),
      ),
    )
  }

  private surface(misses: Misses, { samples }: Tolerance, scale: Scale): BubbleSurface | null {
    const { after } = this.workspace
    if (!after) return null
    const reach = UNITS * misses.unit.mm
    if (misses.around) {
      const errors = Array.from({ length: 2 * ROWS + 1 }, (_, row) => reach * (row / ROWS - 1))
      const rows = errors.map((error) => {
        const around = widened(after, error).map((point): Vector => plus(point, times(ABOVE_MM, after.plane.normal)))
        return [...around, around[0] ?? null]
      })
      const values = errors.map((error, row) => {
        const leak = misses.stepAt([Math.round(error / misses.unit.mm) * misses.unit.mm])
          ? leakAt(samples, [error])
          : null
        return (rows[row] ?? []).map(() => leak)
      })
      return { rows, values, scale }
    }
    const at = (row: number, column: number): [number, number] => {
      const angle = (2 * Math.PI * column) / ANGLES
      return [((reach * row) / ROWS) * Math.cos(angle), ((reach * row) / ROWS) * Math.sin(angle)]
    }
    const grid = Array.from({ length: ROWS + 1 }, (_, row) =>
      Array.from({ length: ANGLES + 1 }, (_, column) => at(row, column)),
    )
    return {
      rows: grid.map((row) => row.map((errors) => misses.placeAt(errors))),
      values: grid.map((row) => row.map((errors) => leakAt(samples, errors))),
      scale,
    }
  }
}

/// One a way, and the limit.
function curves({ ways, unit }: Misses, { samples }: Tolerance): Series[] {
  const reach = UNITS * unit.mm
  const lines = ways.map(({ name }, way): Series => {
    const on = samples
      .filter(({ errors }) => errors.every((part, i) => i === way || part === 0))
      .map(({ errors, leak_mm2 }) => [errors[way] ?? 0, leak_mm2] as const)
      .sort(([one], [other]) => one - other)
    return { label: name, hue: way as 0 | 1 | 2, x: on.map(([x]) => x), y: on.map(([, y]) => y) }
  })
  const limit: Series = {
    label: `none or trace below ${number(TRACE_MM2, 0)} mm²`,
    hue: 'ink',
    look: 'dashed',
    x: [-reach, reach],
    y: [TRACE_MM2, TRACE_MM2],
  }
  return [...lines, limit]
}

function curveWords({ label, x, y }: Series): string {
  return `${label}: ${x.map((error, i) => `${number(y[i])} mm² at ${number(error)} mm`).join(', ')}.`
}

function sentence({ margin, leak_off }: ToleranceWords, { unit }: Misses): string {
  const limit = withUnit(TRACE_MM2, 'mm²', 0)
  return margin === null
    ? `It leaks more than ${limit} as planned; with an error of ${unit.words}, the leak is at most ${leak_off}.`
    : `The margin to a leak of ${limit} is ${margin}; with an error of ${unit.words}, the leak is at most ${leak_off}.`
}
