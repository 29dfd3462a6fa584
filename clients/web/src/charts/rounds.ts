// Round numbers: 1, 2 or 5 times a power of ten.
const DIGITS = [1, 2, 5, 10]
const SLACK = 1e-9 // of what is round but for the last bit

const exact = (value: number) => Number(value.toPrecision(12))

/// The smallest round number not below `value`, which is above 0.
export function roundUp(value: number): number {
  const power = 10 ** Math.floor(Math.log10(value))
  return exact((DIGITS.find((digit) => digit * power >= value * (1 - SLACK)) ?? 10) * power)
}

/// The largest round number not above `value`, which is above 0.
export function roundDown(value: number): number {
  const power = 10 ** Math.floor(Math.log10(value))
  return exact((DIGITS.filter((digit) => digit * power <= value * (1 + SLACK)).at(-1) ?? 1) * power)
}

/// All round numbers from `low` to `high`, ascending; `low` is above 0.
export function roundsIn(low: number, high: number): number[] {
  const found: number[] = []
  for (let at = roundUp(low); at <= high * (1 + SLACK); at = roundUp(at * 1.5)) found.push(at)
  return found
}
