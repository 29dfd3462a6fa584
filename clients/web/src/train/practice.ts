// Which case comes next in practice: one that was not right and is due again, else a new one that the learner gets right with a
// probability of about 0.6 (docs/training.md).
import type { TrainEngine } from './engine'
import { keptTrials, trialsCsv } from './trials'
import type { Exam, Learner, Trial } from './types'

const CANDIDATES = 3 // new cases of which the one nearest to the wanted difficulty is taken

export interface Practice {
  engine: TrainEngine
  learner: Learner
  exam: Exam
  first_case: number // the lowest seed
}

export async function nextSeed(practice: Practice): Promise<number> {
  const { engine, learner, exam, first_case } = practice
  const own = ownTrials(practice)
  if (own.length === 0) return first_case
  const { next } = await engine.scores(trialsCsv(own))
  const seeds = newSeeds(own, first_case, CANDIDATES)
  const cases = await Promise.all(seeds.map((seed) => engine.make(learner.valve, exam, seed)))
  const due = next[0]?.repeat.find(({ due_in, valve }) => due_in === 0 && valve === cases[0]?.name)
  return due ? due.seed : nearest(cases, next[0]?.difficulty ?? 0)
}

/// The cases that may come after that of `seed`, while it is done.
export function makeAhead(practice: Practice, seed: number): void {
  const { engine, learner, exam, first_case } = practice
  for (const other of newSeeds([...ownTrials(practice), { seed }], first_case, CANDIDATES))
    engine.make(learner.valve, exam, other).catch(() => {}) // said when its turn comes
}

function ownTrials({ learner, exam }: Practice): Trial[] {
  return keptTrials().filter((trial) => trial.learner === learner.number && trial.exam === exam)
}

/// The lowest seeds from `first` on that were not done yet.
export function newSeeds(done: readonly { seed: number }[], first: number, count: number): number[] {
  const known = new Set(done.map(({ seed }) => seed))
  const seeds: number[] = []
  for (let seed = first; seeds.length < count; ++seed) if (!known.has(seed)) seeds.push(seed)
  return seeds
}

/// The seed of the case whose difficulty is nearest.
export function nearest(cases: readonly { seed: number; difficulty: number }[], difficulty: number): number {
  const away = (made: { difficulty: number }): number => Math.abs(made.difficulty - difficulty)
  return cases.reduce((best, made) => (away(made) < away(best) ? made : best)).seed
}
