// Numbers as people read them. What is not known is said so, never shown as zero.

const UNKNOWN = 'not known'

/// With `digits` after the point.
export function number(value: number | null | undefined, digits = 1): string {
  if (value === null || value === undefined || !Number.isFinite(value)) return UNKNOWN
  const text = value.toFixed(digits)
  return Number(text) === 0 ? text.replace('-', '') : text
}

export function withUnit(value: number | null | undefined, unit: string, digits = 1): string {
  const text = number(value, digits)
  return text === UNKNOWN ? text : `${text} ${unit}`
}

export function percent(share: number | null | undefined): string {
  return withUnit(share === null || share === undefined ? share : 100 * share, '%', 0)
}

export function seconds(value: number): string {
  const whole = Math.round(value)
  if (whole < 60) return `${whole} s`
  const minutes = Math.floor(whole / 60)
  return minutes < 60 ? `${minutes} min ${whole % 60} s` : `${Math.floor(minutes / 60)} h ${minutes % 60} min`
}

/// "mm2" -> "mm²", in texts of the service.
export function typeset(text: string): string {
  return text.replaceAll(/\b([cm]m)2\b/g, '$1²')
}

/// "papillary_approximation" -> "papillary approximation"
export function words(name: string): string {
  return name.replaceAll('_', ' ')
}
