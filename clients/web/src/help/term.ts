// Words that explain themselves: under the pointer, and when they are pressed.
import { h } from '../dom'
import { GLOSSARY, type Term } from './glossary'
import helpStyle from './help.module.css'

const WIDTH_PX = 300

const bubble = () => h('div', { popover: 'auto', class: helpStyle.bubble, role: 'note', 'data-part': 'help' })
let shown: HTMLElement | null = null

export function term(of: Term, words: string): HTMLElement {
  return explained(words, GLOSSARY[of])
}

export function explained(words: string, text: string): HTMLElement {
  const element = h('button', { type: 'button', class: helpStyle.term, title: text }, words)
  element.addEventListener('click', () => explain(element, text))
  return element
}

/// Below `word`.
export function explain(word: HTMLElement, text: string): void {
  shown ??= bubble()
  if (!shown.isConnected) document.body.append(shown)
  shown.textContent = text
  const box = word.getBoundingClientRect()
  shown.style.left = `${Math.max(8, Math.min(box.left, innerWidth - WIDTH_PX - 8))}px`
  shown.style.top = `${box.bottom + 6}px`
  shown.showPopover()
  const over = shown.getBoundingClientRect().bottom - innerHeight + 8
  if (over > 0) shown.style.top = `${Math.max(8, box.bottom + 6 - over)}px`
}
