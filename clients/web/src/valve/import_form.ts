// What a person may say of files before they are imported; what is left empty the service detects.
import { field, h, select } from '../dom'
import type { VoxelGrid } from '../api/types'
import type { Axes, ImportSettings, Unit } from './parts'
import parts from '../style/parts.module.css'
import valveStyle from './valve.module.css'

export const USUAL_TRIANGLES = 720

export const UNITS: readonly (readonly [Unit, string])[] = [
  ['mm', 'mm'],
  ['cm', 'cm'],
  ['in', 'inches'],
  ['m', 'm'],
]
export const AXES: readonly (readonly [string, string])[] = [
  ['', 'as stated, else LPS'],
  ['LPS', 'LPS (left, posterior, superior)'],
  ['RAS', 'RAS (right, anterior, superior)'],
]
export const STATES: readonly (readonly [string, string])[] = [
  ['open', 'open'],
  ['closed', 'closed'],
]
export const TISSUES: readonly (readonly [string, string])[] = [
  ['excised', 'stress-free'],
  ['in_vivo', 'prestretched (in vivo)'],
]
export const THICKNESSES: readonly (readonly [string, string])[] = [
  ['', '1 mm'],
  ['measured', 'as measured'],
  ['given', 'as entered'],
]

export type FormValues = Record<keyof ReturnType<typeof controlsOf>, string | boolean>

export interface ImportForm {
  element: HTMLElement
  values(): FormValues
  set(values: Partial<FormValues>): void
  reset(): void // to what is detected, but for name, size and seed
  /// Which controls apply to the files.
  settle(has: { labelMap: boolean; chordae: boolean; folder: boolean }): void
  settings(): Omit<ImportSettings, 'labels' | 'places' | 'fit'>
}

/// `inside` stands before what is folded away.
export function importForm(changed: () => void, inside: HTMLElement): ImportForm {
  let drawsByHand: boolean | null = null // whether chordae are drawn, if a person said so
  const controls = controlsOf(() => {
    settleOwn()
    changed()
  })
  controls.draws.addEventListener('change', () => (drawsByHand = controls.draws.checked), { capture: true })
  controls.grid.addEventListener('change', () =>
    controls.grid.setAttribute(
      'aria-invalid',
      String(controls.grid.value.trim() !== '' && !readGrid(controls.grid.value)),
    ),
  )
  const hidden = field('Height hidden by coaptation', controls.hidden_mm, 'mm')
  const thick = field('Thickness entered', controls.thickness_mm, 'mm')
  const ofMaps = h('div', {}, field('Phase of the label map', controls.phase))
  ofMaps.append(field('Voxel grid of the images (JSON)', controls.grid))
  const element = h(
    'div',
    {},
    field('Name', controls.name),
    field('Units', controls.units),
    field('Leaflets were imaged', controls.closed),
    hidden,
    field('Synthesise chordae', controls.draws),
    field('Seed of synthesised chordae', controls.seed),
    field('Triangles (approximate)', controls.triangles),
    inside,
    h(
      'details',
      { class: parts.more, 'data-part': 'corrections' },
      h('summary', {}, 'Correct detected properties'),
      field('Labels and order are correct', controls.trusts),
      field('Atrium on the other side', controls.flips),
      field('Mirror image', controls.mirrored),
      field('Axes of meshes and tables', controls.axes),
      ofMaps,
    ),
    h(
      'details',
      { class: parts.more, 'data-part': 'tissue' },
      h('summary', {}, 'Tissue, chordae and provenance'),
      field('Leaflets in the files are', controls.tissue),
      field('Tissue thickness', controls.thickness),
      thick,
      field('Insertions of each marginal chorda', controls.branches),
      field('Branching point, from the tip', controls.branch_at),
      field('Chordal length, relative to the distance', controls.slack),
      h('p', { class: parts.hint }, 'The last three apply to imported chordae; synthesised ones have their own.'),
      field('Provenance, one sentence per line', controls.provenance),
    ),
  )

  function settleOwn(): void {
    hidden.hidden = controls.closed.value === 'open'
    thick.hidden = controls.thickness.value !== 'given'
    controls.seed.disabled = !controls.draws.checked
  }

  function set(values: Partial<FormValues>): void {
    for (const [key, value] of Object.entries(values)) {
      const control = controls[key as keyof FormValues]
      if (typeof value === 'boolean') (control as HTMLInputElement).checked = value
      else control.value = value
    }
    settleOwn()
  }

  return {
    element,
    set,
    values: () =>
      Object.fromEntries(
        Object.entries(controls).map(([key, control]) => [
          key,
          control instanceof HTMLInputElement && control.type === 'checkbox' ? control.checked : control.value,
        ]),
      ) as FormValues,
    reset() {
      drawsByHand = null
      set({ trusts: false, flips: false, mirrored: false, units: '', closed: '', axes: '', phase: '', grid: '' })
      set({ hidden_mm: '', tissue: 'excised', thickness: '', branches: '', branch_at: '', slack: '', provenance: '' })
      controls.grid.removeAttribute('aria-invalid')
    },
    settle({ labelMap, chordae, folder }) {
      ofMaps.hidden = !labelMap
      controls.draws.checked = drawsByHand ?? (!folder && !chordae)
      settleOwn()
    },
    settings: () => ({
      name: controls.name.value,
      provenance: controls.provenance.value
        .split('\n')
        .map((line) => line.trim())
        .filter((line) => line !== ''),
      triangles: numberOf(controls.triangles) ?? USUAL_TRIANGLES,
      phase: ofMaps.hidden ? null : numberOf(controls.phase),
      grid: ofMaps.hidden ? null : readGrid(controls.grid.value),
      axes: (controls.axes.value || null) as Axes | null,
      units: (controls.units.value || null) as Unit | null,
      closed: controls.closed.value === '' ? null : controls.closed.value === 'closed',
      hidden_mm: hidden.hidden ? null : numberOf(controls.hidden_mm),
      trusts: controls.trusts.checked,
      flips: controls.flips.checked,
      mirrored: controls.mirrored.checked,
      inVivo: controls.tissue.value === 'in_vivo',
      thickness: thicknessOf(controls.thickness.value, numberOf(controls.thickness_mm)),
      seed: controls.draws.checked ? (numberOf(controls.seed) ?? 1) : null,
      branches: numberOf(controls.branches),
      branch_at: numberOf(controls.branch_at),
      slack: numberOf(controls.slack),
    }),
  }
}

function controlsOf(changed: () => void) {
  const number = (attributes: Record<string, string | number>): HTMLInputElement =>
    h('input', { type: 'number', ...attributes })
  const tick = (): HTMLInputElement => h('input', { type: 'checkbox', onchange: changed })
  return {
    name: h('input', { type: 'text', maxlength: 200, value: 'imported' }),
    units: select([['', 'detect from the annulus'], ...UNITS], '', changed),
    closed: select([['', 'detect from the shape'], ...STATES], '', changed),
    hidden_mm: number({ min: 0, max: 15, step: 'any', placeholder: '3' }),
    draws: tick(),
    seed: number({ min: 0, max: 2147483647, value: 1 }),
    triangles: number({ min: 100, max: 100000, value: USUAL_TRIANGLES }),
    trusts: tick(),
    flips: tick(),
    mirrored: tick(),
    axes: select(AXES, '', changed),
    phase: number({ min: 1, max: 1000, placeholder: 'first with labels' }),
    grid: h('textarea', { rows: 2, class: valveStyle.grid, placeholder: '{"size": [...], "to_lps_mm": [...]}' }),
    tissue: select(TISSUES, 'excised', changed),
    thickness: select(THICKNESSES, '', changed),
    thickness_mm: number({ min: 0.05, max: 10, step: 'any', value: 1 }),
    branches: number({ min: 1, max: 5, placeholder: '3' }),
    branch_at: number({ min: 0.05, max: 0.95, step: 'any', placeholder: '0.75' }),
    slack: number({ min: 0.8, max: 1.5, step: 'any', placeholder: '1' }),
    provenance: h('textarea', { rows: 2 }),
  }
}

/// Null: empty, or no number.
function numberOf({ value }: HTMLInputElement): number | null {
  return value.trim() === '' || !Number.isFinite(Number(value)) ? null : Number(value)
}

function thicknessOf(kind: string, entered_mm: number | null): number | 'measured' | null {
  return kind === 'given' ? entered_mm : kind === 'measured' ? kind : null
}

/// Size, and three rows of four numbers; null: it is none.
export function readGrid(text: string): VoxelGrid | null {
  const isList = (value: unknown, count: number): boolean =>
    Array.isArray(value) && value.length === count && value.every((one) => typeof one === 'number')
  try {
    const { size, to_lps_mm: rows } = JSON.parse(text) as VoxelGrid
    const isGrid = isList(size, 3) && Array.isArray(rows) && rows.length === 3 && rows.every((row) => isList(row, 4))
    return isGrid ? { size, to_lps_mm: rows } : null
  } catch {
    return null
  }
}
