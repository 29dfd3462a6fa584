// The presets in plain words.

export interface PresetWords {
  group: 'Human' | 'Disease' | 'Porcine'
  title: string
  about: string
}

const PRESETS: Readonly<Record<string, PresetWords>> = {
  'human-functional-mr': {
    group: 'Human',
    title: 'Functional regurgitation',
    about: 'The annulus is dilated and the papillary muscles are displaced: the leaflets are tethered and do not meet.',
  },
  'human-p2-prolapse': {
    group: 'Human',
    title: 'P2 prolapse',
    about: 'Chordae of P2 are ruptured and the annulus is dilated: its free edge is pushed into the atrium.',
  },
  'human-normal': { group: 'Human', title: 'Normal', about: 'A valve that closes.' },
  barlow: {
    group: 'Disease',
    title: 'Barlow',
    about: 'Large, thick leaflets on long chordae in a large annulus: both billow, P2 prolapses.',
  },
  'fibroelastic-flail': {
    group: 'Disease',
    title: 'Fibroelastic, flail P2',
    about: 'Thin leaflets without excess tissue; the chordae of P2 are ruptured.',
  },
  marfan: {
    group: 'Disease',
    title: 'Marfan',
    about: 'Long, thin leaflets that billow; P2 prolapses.',
  },
  'secondary-mr': {
    group: 'Disease',
    title: 'Secondary regurgitation',
    about: 'A ventricle that has grown tethers leaflets that have become stiffer across their fibres.',
  },
  hypertrophic: {
    group: 'Disease',
    title: 'Hypertrophic',
    about:
      'Long, soft leaflets, muscles close together. Its leak is by systolic anterior motion, which is not modelled.',
  },
  ...Object.fromEntries(
    [1, 2, 3, 4, 5].map((heart): [string, PresetWords] => [
      `porcine-${heart}`,
      {
        group: 'Porcine',
        title: `Pig heart ${heart}`,
        about: 'A valve of the dimensions measured on a pig heart; it closes.',
      },
    ]),
  ),
  'porcine-thesis': {
    group: 'Porcine',
    title: 'Thesis, by its findings',
    about: 'A valve that gives the published answers of the thesis on papillary approximation.',
  },
  'porcine-thesis-tables': {
    group: 'Porcine',
    title: 'Thesis, by its tables',
    about: 'A valve fitted to the tables of the thesis.',
  },
}

export function presetWords(name: string): PresetWords | null {
  return PRESETS[name] ?? null
}

export function presetTitle(name: string): string {
  const words = presetWords(name)
  return words ? `${words.group}: ${words.title}` : name
}
