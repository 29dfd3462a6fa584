// In the place of a view that the page cannot show without coapt-server.
import { h } from '../dom'
import parts from '../style/parts.module.css'
import type { View } from '../view'

export function needsService(title: string, sentence: string): View {
  const element = h('section', { class: parts.panel }, h('h1', {}, title), h('p', {}, sentence))
  return { element, show: () => {}, hide: () => {} }
}
