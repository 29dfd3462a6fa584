// Trials, kept by this browser alone, and their table for `coapt train score`.
import { store, stored } from '../state/stored'
import { type Case, type Judged, MOBILITIES, type Mobility, type Trial } from './types'

const KEY = 'coapt-training-trials'
const LARGEST_N = 100 // that the table takes
const LARGEST_PATH_MM = 1e6

/// In the order in which they were done.
export function keptTrials(): Trial[] {
  return stored<Trial[]>(KEY, [])
}

/// Where the browser keeps no more the trial is lost: that is said to the caller (DOMException).
export function keepTrial(learner: number, block: string, made: Case, judged: Judged): Trial {
  const trials = keptTrials()
  const trial = {
    ...judged,
    path_mm: Math.min(judged.path_mm, LARGEST_PATH_MM),
    largest_n: Math.min(judged.largest_n, LARGEST_N),
    learner,
    block,
    trial: nextNumber(trials, learner),
    valve: made.name,
    exam: made.exam,
    seed: made.seed,
    difficulty: made.difficulty,
  }
  store(KEY, [...trials, trial])
  return trial
}

export function deleteTrials(): void {
  store(KEY, [])
}

export function nextNumber(trials: readonly Trial[], learner: number): number {
  return Math.max(0, ...trials.filter((trial) => trial.learner === learner).map(({ trial }) => trial)) + 1
}

const COLUMNS: readonly (readonly [name: string, of: (trial: Trial) => string | number])[] = [
  ['learner', ({ learner }) => learner],
  ['block', ({ block }) => block],
  ['trial', ({ trial }) => trial],
  ['valve', ({ valve }) => valve],
  ['exam', ({ exam }) => exam],
  ['seed', ({ seed }) => seed],
  ['difficulty', ({ difficulty }) => difficulty],
  ['choice', ({ choice }) => choice],
  ['answer', ({ answer }) => answer],
  ['right', ({ right }) => right],
  ['confidence', ({ confidence }) => confidence],
  ['seconds', ({ seconds }) => rounded(seconds)],
  ['path_mm', ({ path_mm }) => rounded(path_mm)],
  ['largest_n', ({ largest_n }) => rounded(largest_n)],
  ['visited', ({ visited }) => visited.join(' ')],
]

/// One row a trial, as `coapt train score` reads it.
export function trialsCsv(trials: readonly Trial[]): string {
  const lines = trials.map((trial) => COLUMNS.map(([, of]) => cell(of(trial))).join(','))
  return [COLUMNS.map(([name]) => name).join(','), ...lines].map((line) => `${line}\n`).join('')
}

/// As other tables of coapt have it (io/picture/csv_lines.h): text that a spreadsheet would compute has an apostrophe before it.
function cell(value: string | number): string {
  const text = typeof value === 'string' && /^[=+\-@\t\r]/.test(value) ? `'${value}` : String(value)
  return /[",\n\r]/.test(text) ? `"${text.replaceAll('"', '""')}"` : text
}

function rounded(value: number): number {
  return Math.round(1000 * value) / 1000
}

const LETTERS = 'TNP'

/// A letter a segment.
export function lettersOf(mobilities: readonly Mobility[]): string {
  return mobilities.map((mobility) => LETTERS[MOBILITIES.indexOf(mobility)]).join('')
}

export function rightLetters(choice: string, answer: string): number {
  return [...choice].filter((letter, i) => letter === answer[i]).length
}
