// Moves a valve in the engine's thread, in batches short enough that messages are read between them. It sleeps while the
// valve is at rest, and sends a picture each time that one is asked for and there is something new.
import type { Vector } from '../api/types'
import { minus, plus } from '../viewer/geometry'
import type { EngineAnswer, LiveEngine } from './module'
import { readPicture } from './picture'

/// `at_mm`: where the hand took hold: a hook holds the tissue around, whose mean is a little elsewhere, and moves go from there.
/// Null: moves say where the hand is to be.
export type LiveCommand =
  | { live: 'start' | 'change'; body: string; id: number } // answered with that id
  | { live: 'pressure'; mmhg: number }
  | { live: 'grab'; hook: number; vertex: number; at_mm: Vector | null }
  | { live: 'grab cable'; hook: number; cable: number; share: number; at_mm: Vector | null }
  | { live: 'move'; hook: number; to_mm: Vector; asked_ms: number }
  | { live: 'release'; hook: number }
  | { live: 'picture' } // the next one is wanted

export type LiveReply =
  | ({ live: 'started'; id: number } & EngineAnswer)
  | {
      live: 'picture'
      numbers: Float32Array<ArrayBuffer>
      steps: number // since the thread began
      running_ms: number // while the valve moved, from the first step to the last, pauses for messages included
      asked_ms: number | null // of the last move that is in it
    }
  | { live: 'failed'; message: string }

const BATCH_MS = 4 // a quarter of the time between two pictures
const NOWHERE: Vector = [0, 0, 0]
const STEPS = 30 // between two looks at the clock, and for crossings

export interface LoopParts {
  send(reply: LiveReply): void
  later(does: () => void): void // after messages that wait
  now(): number
}

export class LiveLoop {
  private isRunning = false
  private isNew = false // there is something to show
  private isWanted = false
  private steps = 0
  private running_ms = 0
  private last_ms = 0 // end of the last batch
  private asked_ms: number | null = null // of the last move; no step has followed it yet
  private readonly shifts: Vector[] = [] // of each hook: from where the hand took hold to the middle of what is held
  private shown_ms: number | null = null // of the last move that the valve has felt

  constructor(
    private readonly engine: LiveEngine,
    private readonly parts: LoopParts,
  ) {}

  take(command: LiveCommand): void {
    switch (command.live) {
      case 'start':
      case 'change':
        this.parts.send({ live: 'started', id: command.id, ...this.engine[command.live](command.body) })
        break
      case 'pressure':
        this.engine.pressure(command.mmhg)
        break
      case 'grab':
        this.engine.grab(command.hook, command.vertex)
        this.hold(command)
        break
      case 'grab cable':
        this.engine.grabCable(command.hook, command.cable, command.share)
        this.hold(command)
        break
      case 'move':
        this.engine.move(command.hook, ...plus(command.to_mm, this.shifts[command.hook] ?? NOWHERE))
        this.asked_ms = command.asked_ms
        break
      case 'release':
        this.engine.release(command.hook)
        break
      case 'picture':
        this.isWanted = true
        if (!this.isRunning) this.show() // else after the batch, which has felt what came before
        return
    }
    this.isNew = true
    if (this.isRunning) return
    this.isRunning = true
    this.last_ms = this.parts.now()
    this.parts.later(() => this.run())
  }

  private hold({ hook, at_mm }: Extract<LiveCommand, { at_mm: unknown }>): void {
    const spot_mm = readPicture(this.engine.picture(), 0).hooks[hook]?.spot_mm
    this.shifts[hook] = at_mm && spot_mm ? minus(spot_mm, at_mm) : NOWHERE
  }

  private run(): void {
    const end_ms = this.parts.now() + BATCH_MS
    do {
      this.engine.advance(STEPS)
      this.steps += STEPS
    } while (!this.engine.isAtRest() && this.parts.now() < end_ms)
    const now_ms = this.parts.now()
    this.running_ms += now_ms - this.last_ms
    this.last_ms = now_ms
    this.isNew = true
    this.shown_ms = this.asked_ms ?? this.shown_ms
    this.asked_ms = null
    this.show()
    this.isRunning = !this.engine.isAtRest()
    if (this.isRunning) this.parts.later(() => this.run())
  }

  private show(): void {
    if (!this.isWanted || !this.isNew) return
    const numbers = this.engine.picture()
    if (numbers.length === 0) return // before a start
    this.parts.send({
      live: 'picture',
      numbers,
      steps: this.steps,
      running_ms: this.running_ms,
      asked_ms: this.shown_ms,
    })
    this.isWanted = this.isNew = false
    this.shown_ms = null
  }
}
