// The leak as the one large number of a view, and how sure it is.
import type { Scene } from '../api/types'
import { h } from '../dom'
import { knownDigits, withError } from '../format'
import { term } from '../help/term'
import { gradeOf } from './presets'
import valveStyle from './valve.module.css'

export function headline(before: Scene, after: Scene | null): HTMLElement {
  const { leak_mm2, leak_mm2_error } = (after ?? before).closure
  return h(
    'p',
    { class: valveStyle.headline, 'data-part': 'headline' },
    h('span', { class: valveStyle.leak }, leakWords(before, after)),
    h(
      'span',
      { class: valveStyle.sure },
      term('leak', leak_mm2 === null ? 'leak' : gradeOf(leak_mm2)),
      ', ',
      leak_mm2_error === null ? 'error not known' : term('error', 'error of the computation'),
    ),
  )
}

/// "45.7 → 2.1 ± 0.4 mm²": each leak to the digits that are known of it, the error of the last.
export function leakWords(before: Scene, after: Scene | null): string {
  const first = before.closure
  const last = (after ?? before).closure
  const from = after ? `${knownDigits(first.leak_mm2, first.leak_mm2_error)} → ` : ''
  return from + withError(last.leak_mm2, last.leak_mm2_error, 'mm²')
}
