// What the colours of a view mean.
import type { ValveShape } from '../api/types'
import { h } from '../dom'
import { number } from '../format'
import { css, TINTS, type ColourMode, type Scale } from './colours'
import viewerStyle from './viewer.module.css'

export type Kind = readonly [colour: string, words: string]

export const PAPILLARY: Kind = [TINTS.papillary, 'papillary muscles (schematic)']

/// What there is on these valves; `hasRing`: on one of them.
export function kindsOn(scenes: readonly ValveShape[], hasRing = false): Kind[] {
  const chordae = scenes.flatMap((scene) => scene.chordae)
  const isAdded = chordae.some(({ kind }) => kind === 'neochorda') || scenes.some(({ sutures }) => sutures.length > 0)
  const kinds: (Kind | false)[] = [
    [TINTS.anterior, 'anterior leaflet'],
    [TINTS.posterior, 'posterior leaflet'],
    [TINTS.commissure, 'commissures'],
    [TINTS.opening, 'opening, darker where wider'],
    chordae.some(({ ruptured }) => ruptured) && [TINTS.ruptured, 'ruptured chorda'],
    isAdded && [TINTS.added, 'suture or neochorda'],
    hasRing && [TINTS.ring, 'ring'],
    scenes.some(({ heads }) => heads.length > 0) && PAPILLARY,
  ]
  return kinds.filter((kind) => kind !== false)
}

export function legend(mode: ColourMode, scale: Scale | null, kinds: readonly Kind[]): HTMLElement {
  if (!scale) {
    const list = h('ul', { class: viewerStyle.legend })
    for (const [colour, words] of kinds) {
      const swatch = h('span', { class: viewerStyle.swatch })
      swatch.style.background = colour
      list.append(h('li', {}, swatch, words))
    }
    return list
  }
  const bar = h('canvas', { width: scale.stops.length * 32, height: 12, 'aria-hidden': 'true' })
  const pen = bar.getContext('2d')
  if (pen) {
    const ramp = pen.createLinearGradient(0, 0, bar.width, 0)
    for (const [i, stop] of scale.stops.entries()) ramp.addColorStop(i / (scale.stops.length - 1), css(stop))
    pen.fillStyle = ramp
    pen.fillRect(0, 0, bar.width, bar.height)
  }
  const digits = scale.to - scale.from < 10 ? 1 : 0
  return h(
    'div',
    { class: `${viewerStyle.legend} ${viewerStyle.scale}`, 'data-part': 'scale' },
    h('span', {}, number(scale.from, digits)),
    bar,
    h('span', {}, `${number(scale.to, digits)} ${scale.unit}`),
    h('span', {}, mode === 'height' ? `${scale.title} (red: above)` : scale.title),
  )
}
