// The leak as the one large number of a view, where it is, and how sure it is.
import type { Estimate, Information, Measure, Scene } from '../api/types'
import { h, type Child } from '../dom'
import { estimateWords, leakEstimate, leakInShort, tissueExcludesValue, widest, type Interval } from '../estimate'
import { joined, knownDigits, typeset, withUnit } from '../format'
import { explained, term } from '../help/term'
import { narrowing } from './information'
import valveStyle from './valve.module.css'

/// `drawn`: of the valve as it is shown last; null while it is not known, which leaves room for it: nothing moves under a pointer when it
/// comes. `why`: below the leak.
export function headline(
  before: Scene,
  after: Scene | null,
  drawn?: Information | null,
  why: HTMLElement | null = null,
): HTMLElement {
  const { closure } = after ?? before
  const tissue = drawn?.leak.tissue ?? null
  const leak = leakEstimate(closure, tissue)
  return h(
    'p',
    { class: valveStyle.headline, 'data-part': 'headline' },
    h('span', { class: valveStyle.leak }, leakWords(before.closure, after?.closure, tissue)),
    h('span', { class: valveStyle.sure }, term('leak', 'leak'), `${leakPlace(closure)}, `, sureness(leak)),
    why,
    drawn !== undefined &&
      h(
        'span',
        { class: `${valveStyle.sure} ${valveStyle.below}` },
        (widest(leak) === 'tissue' && drawn && narrowing(drawn)) || '\u00a0',
      ),
  )
}

function sureness(leak: Estimate): Child {
  const { interval, cause } = estimateWords(leak)
  if (tissueExcludesValue(leak)) return h('span', {}, term('tissue', TISSUE), `; ${interval} mm² ${cause}`)
  return cause === '' ? 'error not known' : term(widest(leak) === 'tissue' ? 'tissue' : 'error', cause)
}
const TISSUE = 'with tissue error (5 to 95 %)'

/// Why the valve leaks, in a line that tells its figures when pressed; nothing where its closure is not trusted.
export function diagnosisLine({ closure }: Scene): HTMLElement | null {
  if (!closure.diagnosis) return null
  const { summary, sentence } = closure.diagnosis
  return h('span', { class: valveStyle.why, 'data-part': 'why' }, explained(typeset(summary), typeset(sentence)))
}

/// " at A2 and P2, 3.1 mm wide": the largest opening and the segments that have most of its rim. Empty where there is none, or the leak is not more than its error.
export function leakPlace({ leak }: Measure): string {
  const [largest, ...others] = leak.openings
  if (!largest || !((leak.area_mm2 ?? 0) > (leak.error_mm2 ?? 0))) return ''
  const where = largest.segments.length > 0 ? ` at ${joined(largest.segments.slice(0, 2))}` : ''
  return `${others.length > 0 ? ', largest' : ''}${where}, ${withUnit(largest.width_mm, 'mm')} wide`
}

/// "45.7 → 2.1 ± 0.4 mm²", "58 → 2 mm² (0 to 7)": each leak to the digits that are known of it, the error of the last.
export function leakWords(before: Measure, after?: Measure, tissue: Interval | null = null): string {
  const from = after ? `${knownDigits(before.leak_mm2, before.leak?.error_mm2)} → ` : ''
  return from + leakInShort(leakEstimate(after ?? before, tissue))
}
