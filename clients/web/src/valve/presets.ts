// The presets in plain words.
import words from '../../../../words/presets.json'

export interface PresetWords {
  group: string
  title: string
  about: string
}

const PRESETS: Readonly<Record<string, PresetWords>> = words

export function presetWords(name: string): PresetWords | null {
  return PRESETS[name] ?? null
}

export function presetTitle(name: string): string {
  const of = presetWords(name)
  return of ? `${of.group}: ${of.title}` : name
}
