// The leak as the one large number of a view, where it is, and how sure it is.
import type { Measure, Scene } from '../api/types'
import { h } from '../dom'
import { joined, knownDigits, withError, withUnit } from '../format'
import { term } from '../help/term'
import valveStyle from './valve.module.css'

export function headline(before: Scene, after: Scene | null): HTMLElement {
  const { closure } = after ?? before
  return h(
    'p',
    { class: valveStyle.headline, 'data-part': 'headline' },
    h('span', { class: valveStyle.leak }, leakWords(before.closure, after?.closure)),
    h(
      'span',
      { class: valveStyle.sure },
      term('leak', 'leak'),
      `${leakPlace(closure)}, `,
      closure.leak.error_mm2 === null ? 'error not known' : term('error', '± numerical error'),
    ),
  )
}

/// " at A2 and P2, 3.1 mm wide": the largest opening and the segments that have most of its rim. Empty where there is none, or the leak is not more than its error.
export function leakPlace({ leak }: Measure): string {
  const [largest, ...others] = leak.openings
  if (!largest || !((leak.area_mm2 ?? 0) > (leak.error_mm2 ?? 0))) return ''
  const where = largest.segments.length > 0 ? ` at ${joined(largest.segments.slice(0, 2))}` : ''
  return `${others.length > 0 ? ', largest' : ''}${where}, ${withUnit(largest.width_mm, 'mm')} wide`
}

/// "45.7 → 2.1 ± 0.4 mm²": each leak to the digits that are known of it, the error of the last. Plans that release 0.2 has
/// found have no `leak`.
export function leakWords(before: Measure, after?: Measure): string {
  const last = after ?? before
  const from = after ? `${knownDigits(before.leak_mm2, before.leak?.error_mm2)} → ` : ''
  return from + withError(last.leak_mm2, last.leak?.error_mm2, 'mm²')
}
