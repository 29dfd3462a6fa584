// The papillary muscles that a study displaces: its classes of configurations.
import type { Row } from './csv'

export const CLASSES = ['AL', 'PM', 'both'] as const

const TITLES: Record<string, string> = {
  AL: 'Anterolateral muscle displaced',
  PM: 'Posteromedial muscle displaced',
  both: 'Both muscles displaced',
}

export function classTitle(name: string): string {
  return TITLES[name] ?? name
}

/// Those of them that a table has.
export function classesIn(rows: Row[]): string[] {
  return CLASSES.filter((name) => rows.some((row) => row.class === name))
}
