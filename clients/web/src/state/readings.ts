// What a view shows that no closure holds, for the texts of a story and for scripts: forces at a hook, how far off a step may be.
import type { Opening } from '../api/types'

export interface ToleranceWords {
  handle: string // what may end elsewhere
  margin: string | null // "1.5 mm", "at least 3.0 mm"; null: it leaks as planned
  leak_off: string // the largest leak a millimetre off
}

export interface Readings {
  force_n: number | null // of the first hook
  height_mm: number | null // of what it holds, above the annular plane
  tolerance: ToleranceWords | null
  opening: Opening | null // of the valve with the plan
}

const listeners: (() => void)[] = []
export const readings: Readings = { force_n: null, height_mm: null, tolerance: null, opening: null }

export function tellReadings(some: Partial<Readings>): void {
  const isSame = Object.entries(some).every(([name, value]) => readings[name as keyof Readings] === value)
  if (isSame) return
  Object.assign(readings, some)
  for (const listener of listeners) listener()
}

export function onReadings(listener: () => void): void {
  listeners.push(listener)
}
