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

export const SHADES = 9 // of heat maps: heat0 is nothing, heat8 the most

/// The shade of `value` in a scale from 0 to `most`.
export function shadeOf(value: number, most: number): number {
  if (!(most > 0)) return 0
  return Math.max(0, Math.min(SHADES - 1, Math.round((value / most) * (SHADES - 1))))
}

/// Calls `changed` whenever the colours are others, until `signal` says so.
export function onTheme(changed: () => void, signal: AbortSignal): void {
  document.addEventListener('themechange', changed, { signal })
  matchMedia('(prefers-color-scheme: dark)').addEventListener('change', changed, { signal })
}
