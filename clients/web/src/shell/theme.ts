// Light or dark: the system's choice, until another is made here.
const THEME = 'coapt-theme'

export function applyTheme(): void {
  const theme = localStorage.getItem(THEME)
  if (theme === null) delete document.documentElement.dataset.theme
  else document.documentElement.dataset.theme = theme
}

/// The other one than what is shown now.
export function switchTheme(): void {
  const system = matchMedia('(prefers-color-scheme: dark)').matches ? 'dark' : 'light'
  const theme = (document.documentElement.dataset.theme ?? system) === 'dark' ? 'light' : 'dark'
  localStorage.setItem(THEME, theme)
  applyTheme()
  document.dispatchEvent(new Event('themechange'))
}
