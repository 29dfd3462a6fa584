// What the colours of a valve that moves mean.
import { h } from '../dom'
import { TINTS } from '../viewer/colours'
import { legend } from '../viewer/legend'
import type { LiveLook } from './drawing'
import { ABOVE, PROLAPSE_MM, STRAIN } from './surface'
import viewerStyle from '../viewer/viewer.module.css'

export function liveLegend({ strain, prolapse }: LiveLook): HTMLElement {
  const list = h('ul', { class: viewerStyle.legend })
  for (const [colour, words] of [
    [TINTS.anterior, 'anterior leaflet'],
    [TINTS.posterior, 'posterior leaflet'],
    [TINTS.commissure, 'commissures'],
    ...(prolapse ? [[ABOVE, `prolapse: ${PROLAPSE_MM} mm above the annulus or more`] as const] : []),
    [TINTS.added, 'suture or neochorda'],
  ] as const) {
    const swatch = h('span', { class: viewerStyle.swatch })
    swatch.style.background = colour
    list.append(h('li', {}, swatch, words))
  }
  return h('div', {}, list, strain && legend('tension', STRAIN))
}
