// The controls of a beat: a slider from open to closed, the closing or a whole beat played, and both ends of it.
import type { Opening } from '../api/types'
import { field, h } from '../dom'
import { icon } from '../icons'
import parts from '../style/parts.module.css'

const CLOSING_MS = 1800
const BEAT_MS = 4500
const OPEN = -1
const CLOSED = 1

/// Of a beat that begins and ends open: how it divides. Slowed down as much as the closing, and no more real time than that.
const CLOSES = { from: 0.2, to: 0.45 }
const OPENS = { from: 0.65, to: 0.95 }

/// Where a beat is at `phase` (0 to 1) of it: -1 open, 0 unstressed, 1 closed.
export function shareAt(phase: number): number {
  const closing = eased((phase - CLOSES.from) / (CLOSES.to - CLOSES.from))
  const opening = eased((phase - OPENS.from) / (OPENS.to - OPENS.from))
  return OPEN + (CLOSED - OPEN) * (closing - opening)
}

/// From 0 to 1, slow at both ends.
function eased(share: number): number {
  const part = Math.min(Math.max(share, 0), 1)
  return part * part * (3 - 2 * part)
}

interface Player {
  name: string
  label: HTMLElement
  button: HTMLButtonElement
  duration_ms: number
  shareAt: (phase: number) => number
}

export class Motion {
  readonly element: HTMLElement
  onChange: () => void = () => {}
  private readonly slider = h('input', {
    type: 'range',
    min: 0,
    max: CLOSED,
    step: 0.005,
    value: CLOSED,
    oninput: () => this.onChange(),
  })
  private readonly closing = this.player('Play the closing', CLOSING_MS, (phase) => phase)
  private readonly beat = this.player('Play a beat', BEAT_MS, shareAt)
  private readonly open = this.end('Open', OPEN)
  private readonly closed = this.end('Closed', CLOSED)
  private playing: Player | null = null
  private wasOpen = false // before another valve took the place of the one shown

  constructor() {
    this.element = h(
      'div',
      { 'data-part': 'motion' },
      field('Open to closed', this.slider),
      h('p', { class: parts.row, role: 'group', 'aria-label': 'State of the valve' }, this.open, this.closed),
      h('p', { class: parts.row }, this.closing.button, this.beat.button),
      h('p', { class: parts.hint }, 'path to equilibrium, not real time'),
    )
    this.setOpening(null)
  }

  get share(): number {
    return Number(this.slider.value)
  }

  /// Without one the valve opens to its unstressed state alone.
  setOpening(opening: Opening | null): void {
    const known = opening !== null && opening.scene.motion_mm.length > 1
    this.stop()
    if (!known) this.wasOpen ||= this.share === OPEN
    this.slider.min = String(known ? OPEN : 0)
    for (const button of [this.open, this.beat.button]) button.disabled = !known
    if (known && this.wasOpen) this.slider.value = String(OPEN)
    if (known) this.wasOpen = false
    this.tell()
  }

  /// Which end the valve stands at.
  tell(): void {
    this.open.setAttribute('aria-pressed', String(this.share === OPEN))
    this.closed.setAttribute('aria-pressed', String(this.share === CLOSED))
  }

  private end(name: string, share: number): HTMLButtonElement {
    const onclick = (): void => {
      this.stop()
      this.move(share)
    }
    return h('button', { type: 'button', onclick }, name)
  }

  private player(name: string, duration_ms: number, share: (phase: number) => number): Player {
    const label = h('span', {}, name)
    const onclick = (): void => this.playOrStop(player)
    const button = h('button', { type: 'button', class: parts.labelled, onclick }, icon('animation'), label)
    const player: Player = { name, label, button, duration_ms, shareAt: share }
    return player
  }

  private move(share: number): void {
    this.slider.value = String(share)
    this.onChange()
  }

  private playOrStop(player: Player): void {
    const wasPlaying = this.playing === player
    this.stop()
    if (wasPlaying) return
    const started = performance.now()
    this.playing = player
    player.label.textContent = 'Stop'
    const step = (now: number): void => {
      if (this.playing !== player) return
      const phase = Math.min(Math.max((now - started) / player.duration_ms, 0), 1)
      this.move(player.shareAt(phase))
      if (phase < 1) requestAnimationFrame(step)
      else this.stop()
    }
    requestAnimationFrame(step)
  }

  private stop(): void {
    if (this.playing) this.playing.label.textContent = this.playing.name
    this.playing = null
  }
}
