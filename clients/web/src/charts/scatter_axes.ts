// Where points of a scatter chart stand: round ends of both axes, and pixels.
import { roundUp } from './rounds'

export interface Axis {
  from: number
  to: number
  ticks: number[]
  digits: number // of ticks, after the point
}

const INTERVALS = 5 // between ticks, at most
const exact = (value: number) => Number(value.toPrecision(12))

/// Holds all of `values`, over a span of `least` or more, between round ends; not below 0 where they are not.
export function axisOf(values: number[], least: number): Axis {
  const [low, high] = [Math.min(...values), Math.max(...values)]
  const lack = Math.max(0, least - (high - low))
  const start = low >= 0 ? Math.max(0, low - lack / 2) : low - lack / 2
  const end = Math.max(high, start + least)
  const step = roundUp((end - start) / INTERVALS)
  const first = Math.floor(start / step + 1e-9)
  const last = Math.ceil(end / step - 1e-9)
  const ticks = Array.from({ length: last - first + 1 }, (_, i) => exact((first + i) * step))
  const digits = Math.max(0, -Math.floor(Math.log10(step) + 1e-9))
  return { from: ticks[0] as number, to: ticks.at(-1) as number, ticks, digits }
}

/// From a value to pixels between `near`, the axis's start, and `far`.
export function placeOn({ from, to }: Pick<Axis, 'from' | 'to'>, near: number, far: number): (value: number) => number {
  return (value) => near + ((value - from) / (to - from)) * (far - near)
}
