// What the native program says.
import { execFileSync } from 'node:child_process'
import { fileURLToPath } from 'node:url'

export const COAPT =
  process.env.COAPT_PROGRAM ?? fileURLToPath(new URL('../../../build/release/bin/coapt', import.meta.url))

/// `coapt ... --json`. Its exit code says whether a valve leaks; its words come either way.
export function native(...args) {
  try {
    return JSON.parse(execFileSync(COAPT, [...args, '--json'], { encoding: 'utf8', stdio: 'pipe' }))
  } catch (leaks) {
    return JSON.parse(leaks.stdout)
  }
}
