// Light or dark: the system's choice, until another is made here. Style sheets say each colour as light-dark(); who draws on a
// canvas listens here.
const THEME = 'coapt-theme'
const listeners = new Set<() => void>()

type Theme = 'light' | 'dark'

const isDark = (): MediaQueryList => matchMedia('(prefers-color-scheme: dark)')

/// Once, when the page starts.
export function followSystem(): void {
  isDark().addEventListener('change', apply)
  apply()
}

export function theme(): Theme {
  const chosen = localStorage.getItem(THEME)
  return chosen === 'light' || chosen === 'dark' ? chosen : isDark().matches ? 'dark' : 'light'
}

export function switchTheme(): void {
  localStorage.setItem(THEME, theme() === 'dark' ? 'light' : 'dark')
  apply()
}

/// Calls `changed` whenever it is the other one, until `signal` says so.
export function onTheme(changed: () => void, signal?: AbortSignal): void {
  listeners.add(changed)
  signal?.addEventListener('abort', () => listeners.delete(changed))
}

function apply(): void {
  document.documentElement.style.colorScheme = theme()
  for (const changed of listeners) changed()
}
