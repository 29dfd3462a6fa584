// Colours of charts. They are classes of charts.module.css, so that they follow the theme; a canvas asks what they are now.
import chartsStyle from './charts.module.css'

/// 'ink': the text's colour, for what is no series of its own.
export type Hue = 0 | 1 | 2 | 3 | 4 | 5 | 'ink'

export function hueClass(hue: Hue): string {
  return chartsStyle[hue === 'ink' ? 'hueInk' : `hue${hue}`] ?? ''
}

/// The colour that `element` has now; it may be a part that is not shown.
export function colourOf(element: Element): string {
  return getComputedStyle(element).color
}

export const SHADES = 8 // of heat maps: heat0 is the least

/// Where the shades change, of a scale from 0 to `most`.
export function evenLimits(most: number): number[] {
  return Array.from({ length: SHADES - 1 }, (_, i) => (most * (i + 1)) / SHADES)
}

/// 0 to SHADES - 1; `limits` are ascending, a value at a limit has the shade above it.
export function shadeOf(value: number, limits: number[]): number {
  return limits.filter((limit) => value >= limit).length
}
