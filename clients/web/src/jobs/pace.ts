// How much longer a job takes. The pace is that of the last seconds of its stage; what is told follows it slowly, since
// the first closures of a stage are slower than the rest and other programs come and go.
import type { JobProgress } from '../api/types'

const LEAST_S = 2 // before that a guess says nothing
const WINDOW_S = 15
const SETTLING_S = 8 // of what is told, towards what the pace says

/// By stage, the part of its planned closures that takes the time of all at its pace. Ranking starts from known closures,
/// which is faster than searching, and closes 76 to 80 % of what is planned at most (human-functional-mr and
/// human-p2-prolapse with default options).
export const SEARCH_SHARES: Readonly<Record<string, number>> = { searching: 0.65, ranking: 0.85 }

export class Pace {
  private stage: string | null = null
  private begun = 0 // closures at the start of the stage
  private recent: JobProgress[] = []
  private told: { left: number; at: number } | null = null

  /// Without `shares` each stage has closures of its own, and its end is foretold.
  constructor(private readonly shares: Readonly<Record<string, number>> | null = null) {}

  /// Seconds that are left, at most to `limit_s`; null while that cannot be told.
  left(now: JobProgress, limit_s: number | null = null): number | null {
    const left = this.byPace(now)
    if (limit_s === null) return left
    const most = Math.max(0, limit_s - now.seconds)
    return left === null ? most : Math.min(left, most)
  }

  private byPace(now: JobProgress): number | null {
    const before = this.recent.at(-1)
    if (now.stage !== this.stage || now.closures < (before?.closures ?? 0)) {
      if (this.shares === null) this.told = null
      this.stage = now.stage
      this.begun = now.closures
      this.recent = []
    }
    this.recent.push(now)
    while (this.recent.length > 2 && now.seconds - (this.recent[1]?.seconds ?? 0) >= WINDOW_S) this.recent.shift()
    const from = this.recent[0] ?? now
    const done = now.closures - from.closures
    const took = now.seconds - from.seconds
    const needed = (this.shares?.[now.stage] ?? 1) * (now.closures_planned - this.begun)
    const missing = Math.max(0, this.begun + needed - now.closures)
    if (done > 0 && took >= LEAST_S) this.tell((missing * took) / done, now.seconds)
    return this.told && Math.max(0, this.told.left - (now.seconds - this.told.at))
  }

  private tell(left: number, at: number): void {
    if (this.told === null) {
      this.told = { left, at }
      return
    }
    const passed = at - this.told.at
    const expected = this.told.left - passed
    const weight = 1 - Math.exp(-passed / SETTLING_S)
    this.told = { left: expected + weight * (left - expected), at }
  }
}

/// "about 45 s", "about 2 min": no more exact than it is known.
export function roughly(left: number): string {
  if (left < 8) return 'a few seconds'
  if (left < 57.5) return `about ${5 * Math.round(left / 5)} s`
  const halves = Math.round(left / 30)
  if (halves < 10) return `about ${halves / 2} min`
  const minutes = Math.round(left / 60)
  return minutes < 90 ? `about ${minutes} min` : `about ${Math.round(minutes / 60)} h`
}
