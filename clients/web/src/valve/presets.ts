// The presets in plain words. Leaks are those of release 0.2's closures at their own meshes (POST /v1/closures).

export interface PresetWords {
  group: 'Human' | 'Disease' | 'Porcine'
  title: string
  about: string
  leak_mm2: number
}

const PRESETS: Readonly<Record<string, PresetWords>> = {
  'human-functional-mr': {
    group: 'Human',
    title: 'Functional leak',
    about: 'The annulus is dilated and the papillary muscles are displaced: the leaflets are tethered and do not meet.',
    leak_mm2: 45.7,
  },
  'human-p2-prolapse': {
    group: 'Human',
    title: 'P2 prolapse',
    about: 'Chordae of P2 are ruptured and the annulus is dilated: its free edge is pushed into the atrium.',
    leak_mm2: 32.0,
  },
  'human-normal': { group: 'Human', title: 'Normal', about: 'A valve that closes.', leak_mm2: 0.1 },
  barlow: {
    group: 'Disease',
    title: 'Barlow',
    about: 'Large, thick leaflets on long chordae in a large annulus: both billow, P2 prolapses.',
    leak_mm2: 21.6,
  },
  'fibroelastic-flail': {
    group: 'Disease',
    title: 'Fibroelastic, flail P2',
    about: 'Thin leaflets without excess tissue; the chordae of P2 are ruptured.',
    leak_mm2: 43.0,
  },
  marfan: {
    group: 'Disease',
    title: 'Marfan',
    about: 'Long, thin leaflets that billow; P2 prolapses.',
    leak_mm2: 17.2,
  },
  'secondary-mr': {
    group: 'Disease',
    title: 'Secondary leak',
    about: 'A ventricle that has grown tethers leaflets that have become stiffer across their fibres.',
    leak_mm2: 31.6,
  },
  hypertrophic: {
    group: 'Disease',
    title: 'Hypertrophic',
    about:
      'Long, soft leaflets, muscles close together. Its leak is by systolic anterior motion, which is not modelled.',
    leak_mm2: 0.1,
  },
  ...Object.fromEntries(
    [1, 2, 3, 4, 5].map((heart): [string, PresetWords] => [
      `porcine-${heart}`,
      {
        group: 'Porcine',
        title: `Pig heart ${heart}`,
        about: 'A valve of the dimensions measured on a pig heart; it closes.',
        leak_mm2: 0,
      },
    ]),
  ),
  'porcine-thesis': {
    group: 'Porcine',
    title: 'Thesis, by its findings',
    about: 'A valve that gives the published answers of the thesis on papillary approximation.',
    leak_mm2: 1.1,
  },
  'porcine-thesis-tables': {
    group: 'Porcine',
    title: 'Thesis, by its tables',
    about: 'A valve fitted to the tables of the thesis.',
    leak_mm2: 0.6,
  },
}

/// Grades of the regurgitant orifice: mild below 20 mm², severe from 40 mm² (ASE 2017, for the effective orifice).
export function gradeOf(leak_mm2: number): string {
  if (leak_mm2 < 1) return 'no leak'
  return leak_mm2 < 20 ? 'mild leak' : leak_mm2 < 40 ? 'moderate leak' : 'severe leak'
}

export function presetWords(name: string): PresetWords | null {
  return PRESETS[name] ?? null
}

export function presetTitle(name: string): string {
  const words = presetWords(name)
  return words ? `${words.group}: ${words.title}` : name
}
