// What a valve that is pulled does at present.
import type { Picture } from '../engine/picture'

const HOW = 'Press a leaflet or a chorda and drag it, or choose a segment and lift it.'

export function stateWords({ beats, at_rest, hooks, pressure_mmhg }: Picture): string {
  if (beats) return 'The valve beats: it opens to its unstressed shape and closes again.'
  const held = hooks.filter((hook) => hook !== null).length
  if (held > 0) return held === 1 ? 'Pulled by one hook.' : 'Pulled by two hooks.'
  if (!at_rest) return 'Moving.'
  const rest = pressure_mmhg === 0 ? 'At rest, flaccid.' : `At rest under ${Math.round(pressure_mmhg)} mmHg.`
  return `${rest} ${HOW}`
}
