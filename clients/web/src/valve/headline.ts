// The leak as the one large number of a view, and how sure it is.
import type { Scene } from '../api/types'
import { h } from '../dom'
import { number, percent } from '../format'
import { term } from '../help/term'
import { MESH_SPREAD } from '../mesh_error'
import { gradeOf } from './presets'
import valveStyle from './valve.module.css'

export function headline(before: Scene, after: Scene | null): HTMLElement {
  const leaks = [before, ...(after ? [after] : [])].map(({ closure }) => closure.leak_mm2)
  const last = leaks.at(-1) ?? null
  return h(
    'p',
    { class: valveStyle.headline, 'data-part': 'headline' },
    h('span', { class: valveStyle.leak }, `${leaks.map((leak) => number(leak)).join(' → ')} mm²`),
    h('span', { class: valveStyle.sure }, term('leak', last === null ? 'leak' : gradeOf(last)), ', ', sureness(last)),
  )
}

/// Of next to nothing a share says nothing.
function sureness(leak_mm2: number | null): HTMLElement | string {
  if (leak_mm2 === null) return 'not known'
  return term('mesh', `about ±${percent(MESH_SPREAD)} by the mesh`)
}
