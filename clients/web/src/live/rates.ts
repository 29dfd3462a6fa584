// How fast the valve moves and the picture follows, over the last pictures.
const WINDOW_MS = 1000

/// A count that grows with a clock that stands still between whiles: so many a second, over its last second.
export class Rate {
  private samples: { count: number; ms: number }[] = []

  add(count: number, ms: number): void {
    this.samples.push({ count, ms })
    while ((this.samples[1]?.ms ?? ms) < ms - WINDOW_MS) this.samples.shift()
  }

  /// 0 while nothing is known.
  get aSecond(): number {
    const [first, last] = [this.samples[0], this.samples.at(-1)]
    return first && last && last.ms > first.ms ? (1000 * (last.count - first.count)) / (last.ms - first.ms) : 0
  }
}

/// Pictures a second, of those that followed each other: a pause is none.
const PAUSE_MS = 250

export class Pictures {
  private readonly rate = new Rate()
  private count = 0
  private clock_ms = 0 // without pauses
  private last_ms = -Infinity

  drawn(now_ms: number): void {
    const since_ms = now_ms - this.last_ms
    this.last_ms = now_ms
    if (since_ms > PAUSE_MS) return
    this.clock_ms += since_ms
    this.rate.add(++this.count, this.clock_ms)
  }

  get aSecond(): number {
    return this.rate.aSecond
  }
}
