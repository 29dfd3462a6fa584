// Brand, views, the open valve, the theme.
import { button, h } from '../dom'
import type { Workspace } from '../workspace'

export const VIEWS = [
  ['valve', 'Valve'],
  ['repair', 'Repair'],
  ['search', 'Search'],
  ['studies', 'Studies'],
] as const
export type ViewName = (typeof VIEWS)[number][0]

const THEME = 'coapt-theme'

export interface Header {
  element: HTMLElement
  mark(view: ViewName): void
  complain(message: string): void
}

export function header(workspace: Workspace): Header {
  const links = new Map<ViewName, HTMLElement>()
  const nav = h('nav', { 'aria-label': 'Views' })
  for (const [name, label] of VIEWS) {
    const link = h('a', { href: `#${name}` }, label)
    links.set(name, link)
    nav.append(link)
  }
  const valve = h('span', { class: 'open-valve', 'aria-live': 'polite' }, 'opening a valve ...')
  workspace.subscribe(() => {
    if (workspace.valve) valve.textContent = workspace.valve.label
  })
  applyTheme(localStorage.getItem(THEME))
  const element = h(
    'header',
    { class: 'bar' },
    h('span', { class: 'brand' }, h('img', { src: '/favicon.svg', alt: '', width: 24, height: 24 }), 'coapt'),
    nav,
    valve,
    button('Light or dark', switchTheme, { class: 'quiet theme' }),
  )
  return {
    element,
    mark(view) {
      for (const [name, link] of links) {
        if (name === view) link.setAttribute('aria-current', 'page')
        else link.removeAttribute('aria-current')
      }
    },
    complain(message) {
      valve.textContent = message
    },
  }
}

function applyTheme(theme: string | null): void {
  if (theme === null) delete document.documentElement.dataset['theme']
  else document.documentElement.dataset['theme'] = theme
}

/// The other one than what is shown now; the system's choice holds until then.
function switchTheme(): void {
  const system = matchMedia('(prefers-color-scheme: dark)').matches ? 'dark' : 'light'
  const theme = (document.documentElement.dataset['theme'] ?? system) === 'dark' ? 'light' : 'dark'
  localStorage.setItem(THEME, theme)
  applyTheme(theme)
  document.dispatchEvent(new Event('themechange'))
}
