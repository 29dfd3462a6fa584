// What a valve that is pulled does at present.
import type { Picture } from '../engine/picture'

export function stateWords({ beats, at_rest, hooks, pressure_mmhg }: Picture): string {
  if (beats) return 'The valve beats: it opens to its unstressed shape and closes again.'
  const held = hooks.filter((hook) => hook !== null).length
  if (held > 0) return held === 1 ? 'Pulled by one hook.' : 'Pulled by two hooks.'
  if (!at_rest) return 'Moving.'
  return pressure_mmhg === 0 ? 'At rest, flaccid.' : `At rest under ${Math.round(pressure_mmhg)} mmHg.`
}
