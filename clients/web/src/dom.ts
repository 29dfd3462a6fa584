// Elements without a framework: what is made here is what the browser shows.
import parts from './style/parts.module.css'

export type Child = Node | string | number | null | undefined | false
type Attribute = string | number | boolean | null | undefined | ((event: never) => void)
export type Attributes = Record<string, Attribute>

/// Attributes by their HTML names; `onclick` and the like take functions; true sets one without a value, false, null and
/// undefined leave it out. Inline styles are not allowed by the page's policy: use `element.style` instead.
export function h<K extends keyof HTMLElementTagNameMap>(
  tag: K,
  attributes: Attributes = {},
  ...children: Child[]
): HTMLElementTagNameMap[K] {
  const element = document.createElement(tag)
  setAttributes(element, attributes)
  element.append(...present(children))
  return element
}

const SVG = 'http://www.w3.org/2000/svg'

export function svg<K extends keyof SVGElementTagNameMap>(
  tag: K,
  attributes: Attributes = {},
  ...children: Child[]
): SVGElementTagNameMap[K] {
  const element = document.createElementNS(SVG, tag)
  setAttributes(element, attributes)
  element.append(...present(children))
  return element
}

function present(children: Child[]): (Node | string)[] {
  const kept: (Node | string)[] = []
  for (const child of children) {
    if (child === null || child === undefined || child === false) continue
    kept.push(child instanceof Node ? child : String(child))
  }
  return kept
}

function setAttributes(element: Element, attributes: Attributes): void {
  for (const [name, value] of Object.entries(attributes)) {
    if (value === false || value === null || value === undefined) continue
    if (typeof value === 'function') element.addEventListener(name.slice(2), value as EventListener)
    else element.setAttribute(name, value === true ? '' : String(value))
  }
}

/// A labelled control; the label is the control's accessible name.
export function field(label: string, control: HTMLElement, unit = ''): HTMLLabelElement {
  return h(
    'label',
    { class: parts.field },
    h('span', {}, label),
    control,
    unit && h('span', { class: parts.unit }, unit),
  )
}

export function button(label: string, onclick: () => void, attributes: Attributes = {}): HTMLButtonElement {
  return h('button', { type: 'button', onclick, ...attributes }, label)
}

export function select(
  options: readonly (readonly [value: string, label: string])[],
  value: string,
  onchange: (value: string) => void,
): HTMLSelectElement {
  const element = h('select', { onchange: () => onchange(element.value) })
  for (const [name, label] of options) element.append(h('option', { value: name, selected: name === value }, label))
  return element
}

/// A button that asks for files; `label` names what takes them.
export function filePicker(
  label: string,
  words: string,
  {
    use,
    ...attributes
  }: { accept?: string; multiple?: boolean; webkitdirectory?: boolean; use: (files: File[]) => void },
): HTMLElement {
  const choose = (): void => {
    const chosen = [...(input.files ?? [])]
    input.value = '' // the same file, corrected, is another choice
    if (chosen.length > 0) use(chosen)
  }
  const input = h('input', {
    type: 'file',
    class: parts.unseen,
    tabindex: -1,
    'aria-label': label,
    onchange: choose,
    ...attributes,
  })
  return h(
    'span',
    { class: parts.picker },
    button(words, () => input.click()),
    input,
  )
}

/// Saves bytes as a file of the person at the browser.
export function download(name: string, content: Blob): void {
  const link = h('a', { href: URL.createObjectURL(content), download: name })
  link.click()
  setTimeout(() => URL.revokeObjectURL(link.href), 10_000)
}
