// Waiting for a person, until `signal` aborts.

/// Resolves when it is pressed.
export function pressed(button: HTMLButtonElement, signal: AbortSignal): Promise<void> {
  return new Promise((resolve, reject) => {
    signal.throwIfAborted()
    button.addEventListener('click', () => resolve(), { once: true, signal })
    signal.addEventListener('abort', () => reject(signal.reason), { once: true })
  })
}

/// Of what takes time; the work itself goes on.
export function unless<T>(signal: AbortSignal, work: Promise<T>): Promise<T> {
  return new Promise((resolve, reject) => {
    signal.addEventListener('abort', () => reject(signal.reason), { once: true })
    work.then(resolve, reject)
  })
}

/// Seconds since it was made, and a call each quarter of a second until it is stopped.
export class Clock {
  private readonly start_ms = performance.now()
  private readonly timer: number

  constructor(private readonly tick: (seconds: number) => void) {
    this.timer = window.setInterval(() => tick(this.seconds), 250)
    tick(0)
  }

  get seconds(): number {
    return (performance.now() - this.start_ms) / 1000
  }

  stop(): number {
    clearInterval(this.timer)
    const { seconds } = this
    this.tick(seconds)
    return seconds
  }
}

/// "2:05"
export function clockWords(seconds: number): string {
  const whole = Math.max(0, Math.ceil(seconds))
  return `${Math.floor(whole / 60)}:${String(whole % 60).padStart(2, '0')}`
}
