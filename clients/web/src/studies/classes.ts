// The papillary muscles that a study displaces.
import type { Row } from './csv'

export const CLASSES = ['anterolateral', 'posteromedial', 'both'] as const

const TITLES: Record<string, string> = {
  anterolateral: 'Anterolateral muscle displaced',
  posteromedial: 'Posteromedial muscle displaced',
  both: 'Both muscles displaced',
}

export function classTitle(name: string): string {
  return TITLES[name] ?? name
}

/// Those of them that a table has.
export function classesIn(rows: Row[]): string[] {
  return CLASSES.filter((name) => rows.some((row) => row['class'] === name))
}
