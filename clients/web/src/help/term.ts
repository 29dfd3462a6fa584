// Words that explain themselves: under the pointer, and when they are pressed.
import { h } from '../dom'
import { GLOSSARY, type Term } from './glossary'
import helpStyle from './help.module.css'

const WIDTH_PX = 300
const WIDE_PX = 430 // of tables

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

export function explain(word: HTMLElement, text: string): void {
  show(word, text, WIDTH_PX)
}

/// What is more than words: it is entered at its first control.
export function openBubble(word: HTMLElement, content: HTMLElement): void {
  show(word, content, WIDE_PX).querySelector<HTMLElement>('button, a, input')?.focus()
}

/// Below `word`.
function show(word: HTMLElement, content: string | Node, width_px: number): HTMLElement {
  shown ??= bubble()
  if (!shown.isConnected) document.body.append(shown)
  shown.replaceChildren(content)
  const box = word.getBoundingClientRect()
  shown.style.width = `${width_px}px`
  shown.style.left = `${Math.max(8, Math.min(box.left, innerWidth - width_px - 8))}px`
  shown.style.top = `${box.bottom + 6}px`
  shown.showPopover()
  const over = shown.getBoundingClientRect().bottom - innerHeight + 8
  if (over > 0) shown.style.top = `${Math.max(8, box.bottom + 6 - over)}px`
  return shown
}
