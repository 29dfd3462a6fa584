// Landmarks that a person picks on the files: by a click on the picture, or by their coordinates.
import type { Vector } from '../api/types'
import { button, h } from '../dom'
import type { InputViewer } from '../viewer/input_viewer'
import { LANDMARKS, PLACES, readPlace, TIPS, writePlace, type PlaceKey, type Places } from './landmark_places'
import parts from '../style/parts.module.css'
import valveStyle from './valve.module.css'

const ON_ANNULUS = new Set<PlaceKey>(LANDMARKS.map(([key]) => key))

export interface LandmarkList {
  element: HTMLElement
  places(): Places
  open(): void // in front of whoever is to pick
  clear(): void
  stop(): void // of picking
}

/// `viewer` is asked for when one is picked.
export function landmarkList(viewer: () => InputViewer): LandmarkList {
  const chosen = new Map<PlaceKey, Vector>()
  const said = h('p', { class: parts.hint, 'aria-live': 'polite' })
  const rows = new Map(PLACES.map(([key, label]) => [key, row(key, label)]))
  let picking: PlaceKey | null = null

  function row(key: PlaceKey, label: string) {
    const input = h('input', {
      type: 'text',
      placeholder: 'detected',
      'aria-label': `${label}: x, y, z as given`,
      onchange: () => {
        const place = readPlace(input.value)
        input.setAttribute('aria-invalid', String(place === null && input.value.trim() !== ''))
        take(key, place)
      },
    })
    const pick = button('Pick', () => pickOrStop(key), { 'aria-pressed': 'false', 'aria-label': `Pick ${label}` })
    return { input, pick, element: h('li', {}, h('span', {}, label), input, pick) }
  }

  function pickOrStop(key: PlaceKey): void {
    const wasPicking = picking === key
    stop()
    if (wasPicking) return
    picking = key
    rows.get(key)?.pick.setAttribute('aria-pressed', 'true')
    const isOnAnnulus = ON_ANNULUS.has(key)
    said.textContent = isOnAnnulus
      ? 'Click the landmark on the annulus.'
      : 'View the valve from the side and click the tip; it is placed at the depth of the middle of the valve.'
    const shown = viewer()
    shown.element.scrollIntoView({ block: 'nearest' })
    if (!isOnAnnulus) shown.view('anterior')
    shown.pickInAir = !isOnAnnulus
    shown.onPick = (place) => {
      take(key, place)
      stop()
      rows.get(key)?.pick.focus()
    }
  }

  function take(key: PlaceKey, place: Vector | null): void {
    if (place) chosen.set(key, place)
    else chosen.delete(key)
    const row = rows.get(key)
    if (row && (place || row.input.value.trim() === '')) row.input.value = writePlace(place ?? undefined)
    mark()
  }

  function mark(): void {
    viewer().mark(
      PLACES.flatMap(([key, text]) => (chosen.has(key) ? [{ place: chosen.get(key) as Vector, text }] : [])),
    )
    const tips = TIPS.filter(([key]) => chosen.has(key))
    if (tips.length === 1) said.textContent = 'Papillary tips are used once both are picked.'
    else said.textContent = ''
  }

  function stop(): void {
    if (picking === null) return
    rows.get(picking)?.pick.setAttribute('aria-pressed', 'false')
    picking = null
    viewer().onPick = null
    said.textContent = ''
  }

  const element = h(
    'details',
    { class: parts.more, 'data-part': 'landmarks' },
    h('summary', {}, 'Pick landmarks'),
    h(
      'p',
      { class: parts.hint },
      'Empty fields are detected. Commissures are used if both are given, tips if chordae are synthesised.',
    ),
    h('ul', { class: valveStyle.landmarks }, ...[...rows.values()].map(({ element }) => element)),
    said,
  )
  return {
    element,
    open() {
      element.open = true
      element.scrollIntoView({ block: 'nearest' })
      rows.get(PLACES[0]?.[0] as PlaceKey)?.pick.focus()
    },
    places: () => Object.fromEntries(chosen),
    clear() {
      stop()
      chosen.clear()
      for (const { input } of rows.values()) input.value = ''
    },
    stop,
  }
}
