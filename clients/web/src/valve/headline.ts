// The leak as the one large number of a view, where it is, and how sure it is.
import type { Information, Measure, Scene } from '../api/types'
import { h } from '../dom'
import { joined, knownDigits, typeset, withError, withUnit } from '../format'
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
  const tissue = widerTissue(closure, drawn ?? null)
  return h(
    'p',
    { class: valveStyle.headline, 'data-part': 'headline' },
    h('span', { class: valveStyle.leak }, leakWords(before.closure, after?.closure, tissue)),
    h(
      'span',
      { class: valveStyle.sure },
      term('leak', 'leak'),
      `${leakPlace(closure)}, `,
      tissue
        ? h('span', {}, term('tissue', '5 to 95 % with tissue error'), ownTissue(closure, tissue))
        : closure.leak.error_mm2 === null
          ? 'error not known'
          : term('error', '± numerical error'),
    ),
    why,
    drawn !== undefined &&
      h('span', { class: `${valveStyle.sure} ${valveStyle.below}` }, (tissue && drawn && narrowing(drawn)) || '\u00a0'),
  )
}

/// Why the valve leaks, in a line that tells its figures when pressed; nothing where its closure is not trusted.
export function diagnosisLine({ closure }: Scene): HTMLElement | null {
  if (!closure.diagnosis) return null
  const { summary, sentence } = closure.diagnosis
  return h('span', { class: valveStyle.why, 'data-part': 'why' }, explained(typeset(summary), typeset(sentence)))
}

/// From 5 to 95 %, where the tissue leaves the leak less known than mesh and closure do, or observations exclude it.
export function widerTissue(measure: Measure, drawn: Information | null): Range | null {
  const tissue = drawn?.leak.tissue
  if (!tissue) return null
  const [low = 0, high = 0] = tissue
  const range = { low, high }
  return high - low > 2 * (measure.leak.error_mm2 ?? 0) || excludes(range, measure) ? range : null
}

/// What observations say of the leak has no value in common with what the tissue of the file makes of it.
function excludes({ low, high }: Range, { leak_mm2, leak }: Measure): boolean {
  const error = leak?.error_mm2 ?? 0
  return leak_mm2 !== null && (leak_mm2 + error < low || leak_mm2 - error > high)
}

function ownTissue(closure: Measure, tissue: Range): string {
  if (!excludes(tissue, closure)) return ''
  return `; ${knownDigits(closure.leak_mm2, 0.5 * (tissue.high - tissue.low))} mm² with the tissue of its file`
}

interface Range {
  low: number
  high: number
}

/// " at A2 and P2, 3.1 mm wide": the largest opening and the segments that have most of its rim. Empty where there is none, or the leak is not more than its error.
export function leakPlace({ leak }: Measure): string {
  const [largest, ...others] = leak.openings
  if (!largest || !((leak.area_mm2 ?? 0) > (leak.error_mm2 ?? 0))) return ''
  const where = largest.segments.length > 0 ? ` at ${joined(largest.segments.slice(0, 2))}` : ''
  return `${others.length > 0 ? ', largest' : ''}${where}, ${withUnit(largest.width_mm, 'mm')} wide`
}

/// "45.7 → 2.1 ± 0.4 mm²": each leak to the digits that are known of it, the error of the last. Plans that release 0.2 has
/// found have no `leak`. With the tissue's range "46 mm² (30 to 68)".
export function leakWords(before: Measure, after?: Measure, tissue?: Range | null): string {
  const last = after ?? before
  const from = after ? `${knownDigits(before.leak_mm2, before.leak?.error_mm2)} → ` : ''
  if (!tissue) return from + withError(last.leak_mm2, last.leak?.error_mm2, 'mm²')
  const digits = (value: number | null) => knownDigits(value, 0.5 * (tissue.high - tissue.low))
  if (excludes(tissue, last)) return `${from}${digits(tissue.low)} to ${digits(tissue.high)} mm²`
  return `${from}${digits(last.leak_mm2)} mm² (${digits(tissue.low)} to ${digits(tissue.high)})`
}
