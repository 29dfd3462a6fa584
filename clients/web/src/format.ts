// Numbers as people read them. What is not known is said so, never shown as zero.

const UNKNOWN = 'unknown'

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

/// "45.7 ± 2.1 mm²", "46 ± 5 mm²": the error to two digits where they are 10 to 35, else to one, the value to as many
/// places (Particle Data Group 2022, 5.3), as the command line prints it. Without an error one place.
export function withError(value: number | null | undefined, error: number | null | undefined, unit = ''): string {
  const text = knownDigits(value, error)
  if (text === UNKNOWN) return text
  return `${text}${isError(error) ? ` ± ${knownDigits(error, error)}` : ''}${unit && ` ${unit}`}`
}

/// The value alone, to those places: "45.7", "46".
export function knownDigits(value: number | null | undefined, error: number | null | undefined): string {
  return number(value, isError(error) ? decimalsOf(error) : 1)
}

/// To a tenth, or to fewer digits where the error leaves no more.
export function knownTenths(value: number, error: number): string {
  return knownDigits(value, Math.max(LEAST_OF_TENTHS, error))
}
const LEAST_OF_TENTHS = 0.4 // the least error that leaves no more digits

const isError = (error: number | null | undefined): error is number => Number.isFinite(error) && (error ?? -1) >= 0

const TWO_DIGITS_BELOW = 3.55
const NEXT_DECADE_FROM = 9.5
const MOST_DECIMALS = 3

function decimalsOf(error: number): number {
  if (error === 0) return 1
  const exponent = Math.floor(Math.log10(error))
  const leading = error / 10 ** exponent
  const nextDecade = leading >= NEXT_DECADE_FROM
  const twoDigits = leading < TWO_DIGITS_BELOW || nextDecade
  return Math.min(MOST_DECIMALS, Math.max(0, (twoDigits ? 1 : 0) - exponent - (nextDecade ? 1 : 0)))
}

export function grouped(count: number): string {
  return count.toLocaleString('en-GB')
}

/// "1 closure", "0 closures", "2,000 chordae"
export function counted(count: number, one: string, many = `${one}s`): string {
  return `${grouped(count)} ${count === 1 ? one : many}`
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

/// As openings are given.
export function cm2(value_mm2: number | null | undefined): string {
  return withUnit(value_mm2 === null || value_mm2 === undefined ? value_mm2 : 0.01 * value_mm2, 'cm²')
}

/// "mm2" -> "mm²", in texts of the service.
export function typeset(text: string): string {
  return text.replaceAll(/\b([cm]m)2\b/g, '$1²')
}

/// "effective_leak" -> "effective leak"
export function words(name: string): string {
  return name.replaceAll('_', ' ')
}

/// "a", "a and b", "a, b and c"
export function joined(texts: string[]): string {
  return texts.length < 2 ? texts.join() : `${texts.slice(0, -1).join(', ')} and ${texts.at(-1)}`
}
