// Brand, views, the open valve, the theme.
import { h } from '../dom'
import { iconButton } from '../icons'
import type { Workspace } from '../workspace'
import { switchTheme } from './theme'
import { VIEWS, type ViewName, withheld } from './views'
import shellStyle from './shell.module.css'

const OF_NO_VALVE: readonly ViewName[] = ['cohort', 'train', 'farm'] // cases of the trainer are made of a valve of its own

export interface Header {
  element: HTMLElement
  mark(view: ViewName): void
  offer(view: ViewName, is: boolean): void // its link is there
  lead(addressOf: (view: ViewName) => string): void // where the links lead
  complain(message: string): void // in the place of a valve, until one is open
}

export function header(workspace: Workspace, openPalette: () => void): Header {
  const links = new Map<ViewName, HTMLElement>()
  const nav = h('nav', { 'aria-label': 'Views' })
  for (const [name, label] of VIEWS) {
    const link = h('a', { href: `#/${name}`, hidden: withheld.has(name) }, label)
    links.set(name, link)
    nav.append(link)
  }
  const valve = h(
    'span',
    { class: shellStyle.openValve, 'data-part': 'open-valve', 'aria-live': 'polite' },
    'opening a valve ...',
  )
  workspace.subscribe(() => {
    if (workspace.valve) valve.textContent = valve.title = workspace.valve.label
  })
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
      valve.style.visibility = OF_NO_VALVE.includes(view) ? 'hidden' : ''
      for (const [name, link] of links) {
        if (name === view) link.setAttribute('aria-current', 'page')
        else link.removeAttribute('aria-current')
      }
    },
    offer(view, is) {
      withheld[is ? 'delete' : 'add'](view)
      links.get(view)?.toggleAttribute('hidden', !is)
    },
    lead(addressOf) {
      for (const [name, link] of links) link.setAttribute('href', addressOf(name))
    },
    complain(message) {
      if (!workspace.valve) valve.textContent = valve.title = message
    },
  }
}
