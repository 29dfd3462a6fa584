// The leak as the one large number of a view, where it is, and how sure it is.
import type { Closure, Scene } from '../api/types'
import { h } from '../dom'
import { knownDigits, withError } from '../format'
import { term } from '../help/term'
import valveStyle from './valve.module.css'

export function headline(before: Scene, after: Scene | null): HTMLElement {
  const { closure } = after ?? before
  return h(
    'p',
    { class: valveStyle.headline, 'data-part': 'headline' },
    h('span', { class: valveStyle.leak }, leakWords(before, after)),
    h(
      'span',
      { class: valveStyle.sure },
      term('leak', 'leak'),
      `${leakPlace(closure)}, `,
      closure.leak_mm2_error === null ? 'error not known' : term('error', 'error of the computation'),
    ),
  )
}

/// " at P2": the segment beside the largest opening. Empty where there is none, or the leak is not more than its error.
export function leakPlace(closure: Closure): string {
  const [largest, ...others] = closure.orifices
  if (!largest || !((closure.leak_mm2 ?? 0) > (closure.leak_mm2_error ?? 0))) return ''
  return `${others.length > 0 ? ', largest' : ''} at ${largest.segment}`
}

/// "45.7 → 2.1 ± 0.4 mm²": each leak to the digits that are known of it, the error of the last.
export function leakWords(before: Scene, after: Scene | null): string {
  const first = before.closure
  const last = (after ?? before).closure
  const from = after ? `${knownDigits(first.leak_mm2, first.leak_mm2_error)} → ` : ''
  return from + withError(last.leak_mm2, last.leak_mm2_error, 'mm²')
}
