// The flaccid valve of a trial: seen from the atrium, pulled with hooks, for so long. What was done is recorded.
import { h } from '../dom'
import { LiveCanvas } from '../live/canvas'
import type { LiveValve } from '../live/client'
import { liveScripts } from '../live/scripting'
import { namesAround } from '../viewer/marks'
import { offer } from '../shell/scripting'
import trainStyle from './train.module.css'
import { HandPanel } from './hand_panel'
import { segmentOf } from './segments'
import type { Analysed, SegmentName } from './types'
import { Clock, clockWords } from './waits'

export class Analysis {
  readonly canvas = new LiveCanvas({
    label: 'The flaccid valve seen from the atrium: press and drag it; Enter grabs the centre',
    view: 'atrial',
    isFixed: true,
    look: { strain: false, prolapse: false, plane: false, cut: null, noChordae: true }, // they would tell the lesions
  })
  readonly hand = new HandPanel(this.canvas)
  readonly clock = h('p', { class: trainStyle.clock, role: 'timer', 'data-part': 'clock' })
  private visited: SegmentName[] = []
  private running: Clock | null = null
  valve: LiveValve | null = null // that was started last

  constructor() {
    const { canvas } = this
    canvas.onPicture = (picture) => this.hand.tell(picture)
    canvas.hooks.onGrab = (grip) => {
      const segment = this.valve && this.running ? segmentOf(this.valve, grip) : null
      if (segment && this.visited.at(-1) !== segment) this.visited.push(segment)
    }
  }

  /// `document`: coapt.valve/1. It comes to rest without pressure while something else is shown.
  async start(document: object): Promise<LiveValve> {
    this.valve = await this.canvas.start(JSON.stringify(document), null, 0)
    this.canvas.name(namesAround(this.valve.scene, (segment) => segment))
    return this.valve
  }

  /// The clock runs. `limit_s` 0: without a limit; else `onEnd` is called then, and the hooks let go.
  begin(limit_s: number, onEnd: () => void): void {
    this.visited = []
    this.canvas.hooks.path_mm = this.canvas.hooks.largest_n = 0
    this.canvas.show()
    offer({ live: liveScripts(this.canvas, () => {}) })
    this.running = new Clock((seconds) => {
      this.clock.textContent =
        limit_s > 0 ? `${clockWords(limit_s - seconds)} left` : `${clockWords(Math.floor(seconds))} so far`
      if (limit_s > 0 && seconds >= limit_s && this.running) onEnd()
    })
  }

  end(limit_s = 0): Analysed {
    const clock = this.running
    this.running = null
    const { path_mm, largest_n } = this.canvas.hooks
    this.canvas.hide()
    this.hand.tell(null)
    const seconds = clock?.stop() ?? 0
    return { seconds: limit_s > 0 ? Math.min(seconds, limit_s) : seconds, path_mm, largest_n, visited: this.visited }
  }
}
