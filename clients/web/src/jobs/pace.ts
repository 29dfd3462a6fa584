// How much longer a job takes, from how fast its present stage has been.
import type { JobProgress } from '../api/types'

const LEAST_SECONDS = 1 // before that a guess says nothing

export class Pace {
  private stage: string | null = null
  private from = { closures: 0, seconds: 0 }

  /// Seconds that are left of the stage; null while that cannot be told.
  left(now: JobProgress): number | null {
    if (now.stage !== this.stage || now.closures < this.from.closures) {
      this.stage = now.stage
      this.from = { closures: now.closures, seconds: now.seconds }
    }
    const done = now.closures - this.from.closures
    const took = now.seconds - this.from.seconds
    const missing = now.closures_planned - now.closures
    if (done <= 0 || took < LEAST_SECONDS || missing < 0) return null
    return (missing * took) / done
  }
}
