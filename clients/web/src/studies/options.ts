// What a study may be told (server/openapi.json, "Study").

export const STUDIES = [
  ['annulus', 'Annulus: dilated, flattened'],
  ['papillary', 'Papillary muscles: displacement'],
  ['ring', 'Undersized rings'],
  ['approximation', 'Papillary sutures: trigone or saddle peak'],
  ['thesis', 'All studies'],
] as const
export type StudyName = (typeof STUDIES)[number][0]

export const PROTOCOLS = [
  ['lookup-clamped', 'looked up as in the thesis (outside the grid: value at its border)'],
  ['lookup-extended', 'looked up in an extended grid'],
  ['closed', 'every position closed (slow)'],
  ['optimum', 'each anchor at its own best suture length (slow)'],
] as const
export const DEFAULT_PROTOCOLS = ['lookup-clamped', 'lookup-extended']

export interface StudyChoices {
  name: StudyName
  protocols: string[]
  displacement_step_mm: number
  region_points: number | null // null: the default
  scan_sites: number | null
}

export function hasAnchors(name: StudyName): boolean {
  return name === 'approximation' || name === 'thesis'
}

/// As POST /v1/studies takes it; what is as by default is left out.
export function studyOf(choices: StudyChoices): Record<string, unknown> {
  const { name, protocols, displacement_step_mm, region_points, scan_sites } = choices
  if (!hasAnchors(name)) return { name }
  const usual =
    protocols.length === DEFAULT_PROTOCOLS.length && DEFAULT_PROTOCOLS.every((one) => protocols.includes(one))
  return {
    name,
    ...(usual ? {} : { protocols }),
    ...(displacement_step_mm === 1 ? {} : { displacement_step_mm }),
    ...(region_points === null ? {} : { region_points }),
    ...(scan_sites === null ? {} : { scan_sites }),
  }
}
