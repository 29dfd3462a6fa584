// The trainer's own thread of the engine: cases, the order of an exam, scores. A case takes some seconds: the next one is made
// while a learner is busy with the one before.
import { refusal } from '../api/http'
import { engineWords, requireSimd, startThreads } from '../engine/thread'
import type { Threads } from '../engine/threads'
import { valveText } from '../state/valves'
import type { Case, CaseA, CaseB, Exam, LaidExam, Schedule, Scores } from './types'

const decoder = new TextDecoder()

export class TrainEngine {
  private threads: Threads | null = null
  private dropped = new AbortController()
  private readonly making = new Set<string>() // of the cases
  private readonly cases = new Map<string, Promise<Case>>()

  /// `valve`: a preset's name or the id of an opened valve. The same three give the same case.
  make(valve: string, exam: 'A', seed: number): Promise<CaseA>
  make(valve: string, exam: 'B', seed: number): Promise<CaseB>
  make(valve: string, exam: Exam, seed: number): Promise<Case>
  make(valve: string, exam: Exam, seed: number): Promise<Case> {
    const key = `${exam} ${seed} ${valve}`
    const known = this.cases.get(key)
    if (known) return known
    const { signal } = this.dropped
    const made = valveText(valve).then((text) =>
      this.answer<Case>('/v1/training/cases', `{"valve":${text},"exam":"${exam}","seed":${seed}}`, signal),
    )
    this.cases.set(key, made)
    this.making.add(key)
    made.catch(() => this.cases.delete(key)).finally(() => this.making.delete(key))
    return made
  }

  /// Cases that are being made are given up: nobody hears of them.
  drop(): void {
    if (this.making.size === 0) return
    this.dropped.abort()
    this.dropped = new AbortController()
    for (const key of this.making) this.cases.delete(key)
    this.making.clear()
  }

  layOut(schedule: Schedule, seed: number, first_case: number): Promise<LaidExam> {
    return this.answer('/v1/training/exams', JSON.stringify({ schedule, seed, first_case }))
  }

  scores(trials_csv: string): Promise<Scores> {
    return this.answer('/v1/training/scores', JSON.stringify({ trials_csv }))
  }

  private async answer<T>(path: string, body: string, signal?: AbortSignal): Promise<T> {
    requireSimd()
    this.threads ??= startThreads()
    const answered = await this.threads.ask({ path, body, signal }).catch((error: unknown) => {
      if (signal?.aborted) return new Promise<never>(() => {})
      throw new Error(engineWords(error instanceof Error ? error.message : String(error)))
    })
    const said: unknown = JSON.parse(decoder.decode(answered.body))
    if (answered.status === 200) return said as T
    throw refusal(answered.status, said)
  }
}
