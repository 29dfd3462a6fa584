// window.coapt.live: the hooks and the pressure for scripts and tests. Millimetres, newtons, mmHg.
import type { Vector } from '../api/types'
import type { LiveCanvas } from './canvas'

export interface LiveScripts {
  readonly stepsPerSecond: number
  grab(vertex: number, hook?: number): void
  moveTo(x: number, y: number, z: number, hook?: number): void
  forceN(hook?: number): number // 0: it holds nothing
  release(hook?: number): void
  pressure(mmhg: number): void
  vertices(): number[] // as they are drawn: x, y, z each
  state(hook?: number): object | null // null: nothing is drawn yet
}

export function liveScripts(canvas: LiveCanvas, setPressure: (mmhg: number) => void): LiveScripts {
  return {
    get stepsPerSecond() {
      return canvas.stepsPerSecond
    },
    grab: (vertex, hook = 0) => canvas.grabVertex(hook, vertex),
    moveTo: (x, y, z, hook = 0) => canvas.hooks.moveTo(hook, [x, y, z]),
    forceN: (hook = 0) => canvas.picture?.hooks[hook]?.force_n ?? 0,
    release: (hook = 0) => canvas.hooks.release(hook),
    pressure: setPressure,
    vertices: () => Array.from(canvas.vertices),
    state(hook = 0) {
      const { picture, latency_ms } = canvas
      if (!picture) return null
      const { pressure_mmhg, at_rest, beats, returns } = picture
      const held = picture.hooks[hook]
      const place = (vector: Vector | undefined) => vector ?? null
      return {
        pressure_mmhg,
        at_rest,
        beats,
        returns,
        spot: place(held?.spot_mm),
        hand: place(held?.hand_mm),
        force: place(held?.force),
        latency_ms,
        pictures_per_second: canvas.picturesPerSecond,
      }
    },
  }
}
