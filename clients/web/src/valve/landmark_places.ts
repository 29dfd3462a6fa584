// Places on a valve that a person may pick, in the coordinates of its files.
import type { Vector } from '../api/types'

/// On the annulus, as the service calls them.
export const LANDMARKS = [
  ['anterolateral_commissure', 'AL commissure'],
  ['posteromedial_commissure', 'PM commissure'],
  ['saddle_peak', 'Mid-anterior'],
  ['mid_posterior', 'Mid-posterior'],
] as const

/// Of the papillary muscles; with the word that tables of tips have for their side.
export const TIPS = [
  ['tip_al', 'AL', 'AL papillary tip'],
  ['tip_pm', 'PM', 'PM papillary tip'],
] as const

export type PlaceKey = (typeof LANDMARKS)[number][0] | (typeof TIPS)[number][0]
export type Places = Partial<Record<PlaceKey, Vector>>

export const PLACES: readonly (readonly [PlaceKey, string])[] = [
  ...LANDMARKS,
  ...TIPS.map(([key, , label]) => [key, label] as const),
]

/// "1.5, 2, -3" as three numbers; null if it is none.
export function readPlace(text: string): Vector | null {
  const words = text.split(/[\s,;]+/).filter((word) => word !== '')
  const numbers = words.map(Number)
  return numbers.length === 3 && numbers.every(Number.isFinite) ? (numbers as unknown as Vector) : null
}

export function writePlace(place: Vector | undefined): string {
  return place ? place.map((number) => Number(number.toPrecision(5))).join(', ') : ''
}
