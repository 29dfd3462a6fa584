// Brand, views, the open valve, the theme.
import { h } from '../dom'
import { iconButton } from '../icons'
import type { Workspace } from '../workspace'
import { applyTheme, switchTheme } from './theme'
import { VIEWS, type ViewName } from './views'
import shellStyle from './shell.module.css'

export interface Header {
  element: HTMLElement
  mark(view: ViewName): void
  reveal(view: ViewName): void // a link that is hidden at first
  lead(addressOf: (view: ViewName) => string): void // where the links lead
  complain(message: string): void // in the place of a valve, until one is open
}

export function header(workspace: Workspace, openPalette: () => void): Header {
  const links = new Map<ViewName, HTMLElement>()
  const nav = h('nav', { 'aria-label': 'Views' })
  for (const [name, label] of VIEWS) {
    const link = h('a', { href: `#/${name}`, hidden: name === 'farm' }, label)
    links.set(name, link)
    nav.append(link)
  }
  const valve = h(
    'span',
    { class: shellStyle.openValve, 'data-part': 'open-valve', 'aria-live': 'polite' },
    'opening a valve ...',
  )
  workspace.subscribe(() => {
    if (workspace.valve) valve.textContent = workspace.valve.label
  })
  applyTheme()
  const element = h(
    'header',
    { class: shellStyle.bar },
    h(
      'span',
      { class: shellStyle.brand },
      h('img', { src: `${import.meta.env.BASE_URL}favicon.svg`, alt: '', width: 24, height: 24 }),
      h('span', {}, 'coapt'),
    ),
    nav,
    valve,
    iconButton('palette', 'Find anything (Ctrl+K)', openPalette),
    iconButton('theme', 'Light or dark', switchTheme),
  )
  return {
    element,
    mark(view) {
      for (const [name, link] of links) {
        if (name === view) link.setAttribute('aria-current', 'page')
        else link.removeAttribute('aria-current')
      }
    },
    reveal(view) {
      links.get(view)?.removeAttribute('hidden')
    },
    lead(addressOf) {
      for (const [name, link] of links) link.setAttribute('href', addressOf(name))
    },
    complain(message) {
      if (!workspace.valve) valve.textContent = message
    },
  }
}
