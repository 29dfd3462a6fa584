// Icons of lucide (ISC licence), put into the page by the build.
import animation from 'lucide-static/icons/play.svg?raw'
import anterior from 'lucide-static/icons/arrow-left-to-line.svg?raw'
import atrial from 'lucide-static/icons/arrow-down-to-line.svg?raw'
import close from 'lucide-static/icons/x.svg?raw'
import distance from 'lucide-static/icons/ruler.svg?raw'
import keep from 'lucide-static/icons/bookmark.svg?raw'
import lateral from 'lucide-static/icons/arrow-right-to-line.svg?raw'
import oblique from 'lucide-static/icons/rotate-3d.svg?raw'
import picture from 'lucide-static/icons/camera.svg?raw'
import palette from 'lucide-static/icons/search.svg?raw'
import redo from 'lucide-static/icons/redo-2.svg?raw'
import remove from 'lucide-static/icons/trash-2.svg?raw'
import save from 'lucide-static/icons/download.svg?raw'
import stop from 'lucide-static/icons/square.svg?raw'
import theme from 'lucide-static/icons/sun-moon.svg?raw'
import undo from 'lucide-static/icons/undo-2.svg?raw'
import ventricular from 'lucide-static/icons/arrow-up-to-line.svg?raw'
import { h, type Attributes } from './dom'
import parts from './style/parts.module.css'

const ICONS = {
  animation,
  anterior,
  atrial,
  close,
  distance,
  keep,
  lateral,
  oblique,
  palette,
  picture,
  redo,
  remove,
  save,
  stop,
  theme,
  undo,
  ventricular,
}
export type IconName = keyof typeof ICONS

export function icon(name: IconName): Element {
  const drawing = new DOMParser().parseFromString(ICONS[name], 'image/svg+xml').documentElement
  drawing.setAttribute('aria-hidden', 'true')
  drawing.setAttribute('class', parts.icon ?? '')
  return drawing
}

/// Its label is said to those who hear it and shown over it.
export function iconButton(
  name: IconName,
  label: string,
  onclick: () => void,
  attributes: Attributes = {},
): HTMLButtonElement {
  return h(
    'button',
    { type: 'button', class: parts.tool, title: label, 'aria-label': label, onclick, ...attributes },
    icon(name),
  )
}

/// Beside its label; `title` is shown over it.
export function labelledButton(
  name: IconName,
  label: string,
  title: string,
  onclick: () => void,
  attributes: Attributes = {},
): HTMLButtonElement {
  const { class: more = '', ...others } = attributes
  const named = { title, 'aria-label': title, class: `${parts.labelled} ${more}` }
  return h('button', { type: 'button', onclick, ...named, ...others }, icon(name), h('span', {}, label))
}
