// What the colours of a valve that moves mean.
import { h } from '../dom'
import { TINTS } from '../viewer/colours'
import { type Kind, legend, PAPILLARY } from '../viewer/legend'
import type { LiveLook } from './drawing'
import { ABOVE, PROLAPSE_MM, STRAIN } from './surface'

export function liveLegend({ strain, prolapse, noChordae }: LiveLook): HTMLElement {
  const kinds: Kind[] = [
    [TINTS.anterior, 'anterior leaflet'],
    [TINTS.posterior, 'posterior leaflet'],
    [TINTS.commissure, 'commissures'],
    ...(prolapse ? [[ABOVE, `prolapse: ${PROLAPSE_MM} mm above the annulus or more`] as const] : []),
    [TINTS.added, 'suture or neochorda'],
    ...(noChordae ? [] : [PAPILLARY]),
  ]
  return h('div', {}, legend('leaflets', null, kinds), strain && legend('tension', STRAIN, []))
}
