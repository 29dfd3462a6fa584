// What a plan trades: its place in the chart, its figures in words, its cells in the table.
import type { FrontPlan, RankedPlan } from '../api/types'
import { LEVELS, type Level } from '../charts/scatter_marks'
import { cm2, number, withUnit } from '../format'
import { FURTHEST_DISEASE_MM, openingMm2 } from './figures'

export interface Trade {
  leak_mm2: number | null // mean + sd over the region
  opening_mm2: number | null
  durability_mm: number | null
}

export const LEVEL_MM = FURTHEST_DISEASE_MM / LEVELS

export function tradeOfRanked(plan: RankedPlan): Trade {
  const { mean, sd } = plan.leak_mm2
  return { leak_mm2: upper(mean, sd), opening_mm2: openingMm2(plan), durability_mm: plan.durability_mm ?? null }
}

/// Results of coapt 0.1 know neither opening nor durability.
export function tradeOfFront({ mean_mm2, sd_mm2, opening_mm2, durability_mm }: FrontPlan): Trade {
  return {
    leak_mm2: upper(mean_mm2, sd_mm2),
    opening_mm2: opening_mm2 ?? null,
    durability_mm: durability_mm ?? null,
  }
}

/// In mm2 and cm2; null where one of them is not known.
export function placeOf({
  leak_mm2,
  opening_mm2,
  durability_mm,
}: Trade): { x: number; y: number; level: Level } | null {
  if (leak_mm2 === null || opening_mm2 === null) return null
  const level = durability_mm === null ? null : Math.min(LEVELS - 1, Math.floor(durability_mm / LEVEL_MM))
  return { x: leak_mm2, y: opening_mm2 / 100, level }
}

export function tradeInWords({ leak_mm2, opening_mm2, durability_mm }: Trade): string {
  return [
    `leak ${withUnit(leak_mm2, 'mm²')} (mean + sd)`,
    `opening ${cm2(opening_mm2)}`,
    ...(durability_mm === null ? [] : [`reserve ${outlasted(durability_mm)}`]),
  ].join(', ')
}

/// Leak in mm2, opening in cm2, durability in mm.
export function tradeCells({ leak_mm2, opening_mm2, durability_mm }: Trade): string[] {
  return [
    number(leak_mm2),
    number(opening_mm2 === null ? null : opening_mm2 / 100),
    durability_mm === null ? number(null) : outlasted(durability_mm).replace(' mm', ''),
  ]
}

function upper(mean: number | null, sd: number | null): number | null {
  return mean === null || sd === null ? null : mean + sd
}

/// "8.4 mm", "12.0 mm or more"
function outlasted(mm: number): string {
  return `${withUnit(mm, 'mm')}${mm >= FURTHEST_DISEASE_MM ? ' or more' : ''}`
}
