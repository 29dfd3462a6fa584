// What the farm's tables and its headline say.
import type { Farm } from '../api/types'
import { dataTable } from '../charts/data_table'
import { h, type Child } from '../dom'
import { grouped, number, seconds } from '../format'
import { roughly } from '../jobs/pace'
import parts from '../style/parts.module.css'

type Run = Farm['runs'][number]
type Worker = Farm['workers'][number]

const DIGITS_BELOW = 10 // of a rate that has one after the point

function itemsPerS(per_s: number): string {
  return number(per_s, per_s < DIGITS_BELOW ? 1 : 0)
}

export function rate(per_s: number): string {
  return `${itemsPerS(per_s)}/s`
}

/// "3 workers compute 240 items a second; 2 runs are open."
export function headline({ runs, workers }: Farm): string {
  const alive = workers.filter((worker) => worker.alive && !worker.barred)
  const open = runs.filter((run) => run.state === 'open').length
  const together = alive.reduce((sum, worker) => sum + worker.rate_per_s, 0)
  const standing = open === 0 ? 'no run is open' : open === 1 ? 'one run is open' : `${open} runs are open`
  if (alive.length === 0) return `No worker is running; ${standing}.`
  return `${alive.length === 1 ? 'One worker computes' : `${alive.length} workers compute`} ${itemsPerS(together)} items a second; ${standing}.`
}

const STATES: Record<Run['state'], [words: string, tone: string]> = {
  open: ['running', 'soft'],
  done: ['done', 'good'],
  holes: ['incomplete', 'bad'],
  cancelled: ['cancelled', 'warn'],
}

function badge(words: string, tone: string): HTMLElement {
  return h('span', { class: `${parts.badge} ${parts[tone]}` }, words)
}

function stateOf(run: Run): HTMLElement {
  return run.waits_for_workers ? badge('waiting for workers', 'warn') : badge(...STATES[run.state])
}

function progressOf(run: Run): HTMLElement {
  const said = `${grouped(run.done)} of ${grouped(run.items)}`
  return h('span', {}, h('progress', { max: run.items, value: run.done, 'aria-label': `Run ${run.run}` }), ` ${said}`)
}

function troubleOf(run: Run): string {
  const said: string[] = []
  if (run.tasks_disputed > 0) said.push(`${run.tasks_disputed} with conflicting results`)
  if (run.tasks_poison > 0) said.push(`${run.tasks_poison} abandoned`)
  return said.join(', ')
}

export function runsTable(runs: Run[]): HTMLElement {
  if (runs.length === 0) return h('p', {}, 'None yet.')
  const columns = [
    { label: 'Run' },
    { label: 'For' },
    { label: 'State' },
    { label: 'Items' },
    { label: 'Rate', numeric: true },
    { label: 'Left' },
    { label: 'Tasks in trouble' },
  ]
  const rows = runs.map((run): Child[] => [
    `${run.run} (${run.kind})`,
    run.label,
    stateOf(run),
    progressOf(run),
    run.state === 'open' ? rate(run.rate_per_s) : '',
    run.eta_s === null ? '' : roughly(run.eta_s),
    troubleOf(run),
  ])
  return dataTable('Runs of the farm', columns, rows)
}

export function workersTable(workers: Worker[]): HTMLElement {
  if (workers.length === 0) return h('p', {}, 'None in the last day.')
  const columns = [
    { label: 'Worker' },
    { label: 'State' },
    { label: 'Rate', numeric: true },
    { label: 'Items', numeric: true },
    { label: 'Last seen' },
  ]
  const rows = workers.map((worker): Child[] => [
    worker.name,
    worker.barred ? badge('barred', 'bad') : worker.alive ? badge('alive', 'good') : badge('gone', 'soft'),
    rate(worker.rate_per_s),
    grouped(worker.items),
    `${seconds(worker.seen_s)} ago`,
  ])
  return dataTable('Workers of the farm', columns, rows)
}
