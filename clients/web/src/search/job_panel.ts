// One search: its progress while it runs, what it has found once it has ended.
import { getJson } from '../api/http'
import type { Job, JobProgress, SearchResult } from '../api/types'
import { h } from '../dom'
import { hasEnded } from '../jobs/calls'
import { followJob } from '../jobs/follow'
import { progressPanel, type ProgressPanel } from '../jobs/progress_panel'
import { valveOf } from '../jobs/valves'
import { problemList } from '../problems'
import { problemsOf } from '../workspace'
import type { CardContext } from './card'
import { costChart, liveSeries, type CostChart } from './cost_chart'
import { leadingPlan } from './leading'
import { Photos } from './photos'
import { searchResults } from './results'
import parts from '../style/parts.module.css'

const REDRAW_MS = 250 // of the chart while progress comes in

export interface SearchPanelContext extends Omit<CardContext, 'job' | 'photos'> {
  changed(job: Job): void // its state
}

/// Followed until `context.signal` aborts.
export function searchPanel(first: Job, context: SearchPanelContext): HTMLElement {
  const title = h('h1', {}, 'Search')
  const body = h('div', {})
  const curves = h('section', { class: parts.panel, 'aria-label': 'Lowest cost so far', hidden: true })
  const photos = new Photos(first.valve, context.signal)
  const leading = leadingPlan(photos)
  const seen: JobProgress[] = []
  let panel: ProgressPanel | null = null
  let chart: CostChart | null = null
  let redraw = 0
  void valveOf(first).then(({ label }) => (title.textContent = `Search: ${label}`))

  function change(job: Job): void {
    context.changed(job)
    if (hasEnded(job.state)) {
      void end(job)
    } else if (panel) {
      panel.change(job)
    } else {
      panel = progressPanel(job, 'search')
      body.replaceChildren(panel.element, leading.element, curves)
      draw()
    }
  }

  /// There is nothing to draw before the first plans are scored.
  function draw(): void {
    const now = seen.at(-1)
    if (now) leading.show(now)
    const series = liveSeries(seen)
    if (series.every((one) => one.x.length === 0)) return
    chart ??= costChart(series, context.signal)
    if (!chart.element.isConnected) curves.replaceChildren(chart.element)
    curves.hidden = false
    chart.show(series)
  }

  function progress(now: JobProgress): void {
    seen.push(now)
    panel?.show(now)
    redraw ||= window.setTimeout(() => {
      redraw = 0
      draw()
    }, REDRAW_MS)
  }

  async function end(job: Job): Promise<void> {
    clearTimeout(redraw)
    if (job.state === 'FAILED')
      return body.replaceChildren(
        h('section', { class: parts.panel }, h('h2', {}, 'The search failed'), problemList(job.problems)),
      )
    if (!job.links.result)
      return body.replaceChildren(h('p', { class: parts.panel }, 'The search was cancelled before it found a plan.'))
    try {
      const result = await getJson<SearchResult>(job.links.result, context.signal)
      body.replaceChildren(searchResults(result, { ...context, job, photos }))
    } catch (error) {
      if (!context.signal.aborted) complain(error)
    }
  }

  function complain(error: unknown): void {
    body.replaceChildren(h('section', { class: parts.panel }, problemList(problemsOf(error))))
  }

  followJob(first.id, { progress, changed: change }, context.signal).catch((error: unknown) => {
    if (!context.signal.aborted) complain(error)
  })
  return h('div', {}, title, body)
}
