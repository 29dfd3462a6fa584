// Valve analysis as it is done: the free edge of a segment is lifted towards the atrium until the hook pulls with so many
// newtons, held there, and let go.
import type { Vector } from '../api/types'
import type { Picture } from '../engine/picture'
import type { LiveCanvas } from '../live/canvas'
import { plus, times } from '../viewer/geometry'

const LIFT_MM = 0.25 // a picture
const MOST_MM = 40
const HOLD_MS = 2500

export class ShownPull {
  private up: Vector = [0, 0, 1]
  private pull_n = 0.2
  private lifted_mm = 0
  private isRunning = false
  private timer = 0 // runs since the force was reached; 0: it was not

  constructor(private readonly canvas: LiveCanvas) {}

  /// `up`: towards the atrium, as long as 1.
  set(up: Vector, pull_n: number): void {
    this.end()
    this.up = up
    this.pull_n = pull_n
  }

  begin(segment: string): void {
    this.stop()
    this.canvas.hooks.releaseAll()
    this.canvas.grabEdge(segment)
    this.lifted_mm = 0
    this.isRunning = this.canvas.hooks.isHeld(0)
  }

  /// With each picture.
  follow({ hooks }: Picture): void {
    const hook = hooks[0]
    if (!this.isRunning || !hook) return // the picture may be of before
    if (!this.canvas.hooks.isHeld(0) || this.canvas.hooks.isDragged)
      this.stop() // another hand has it
    else if (this.timer === 0 && hook.force_n < this.pull_n && this.lifted_mm < MOST_MM) {
      this.lifted_mm += LIFT_MM
      this.canvas.hooks.moveTo(0, plus(hook.hand_mm, times(LIFT_MM, this.up)))
    } else if (this.timer === 0) this.timer = window.setTimeout(() => this.end(), HOLD_MS)
  }

  end(): void {
    if (this.isRunning) this.canvas.hooks.releaseAll()
    this.stop()
  }

  private stop(): void {
    clearTimeout(this.timer)
    this.timer = 0
    this.isRunning = false
  }
}
