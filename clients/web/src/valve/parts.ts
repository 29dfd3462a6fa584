// Which part of a valve a file of a segmentation tool holds, and how it goes to the service.
import type { FileLookedAt, FileToImport, ImportRequest, LabelTaken, Vector, VoxelGrid } from '../api/types'
import { COMPANIONS, extensionOf, isImportable, LABEL_MAPS, MESHES } from './formats'
import { LANDMARKS, TIPS, type Places } from './landmark_places'

export const ROLES = [
  ['detected', 'detect from name and content'],
  ['anterior', 'anterior or both leaflets'],
  ['posterior', 'posterior leaflet'],
  ['labels', 'segmentation (label map)'],
  ['voxels', 'voxels of the label map'],
  ['annulus', 'annulus'],
  ['chordae', 'chordae'],
  ['tips', 'papillary tips'],
  ['landmarks', 'landmarks of the annulus'],
  ['surface', 'closed leaflets (target of the fit)'],
  ['folder', 'file of a SlicerHeart folder'],
  ['none', 'not used'],
] as const
export type Role = (typeof ROLES)[number][0]

const HEADERS = ['nhdr', 'mhd'] // of label maps whose voxels are in a file of their own
const VOXELS = ['raw', 'zraw', 'gz', 'bz2']
const POSTERIOR = /posterior|(^|[^a-z0-9])(post|pml|pmvl|p[123]?)([^a-z0-9]|$)/i

/// What each looks like: by its name, then by what is in it (null: not known yet). A folder of SlicerHeart has markups
/// beside its meshes. 'none': nothing that is known.
export function guessedRoles(names: string[], contents: (FileLookedAt['content'] | null)[] = []): Role[] {
  const used = names.map(isImportable)
  const markups = names.filter((name) => name.toLowerCase().endsWith('.mrk.json'))
  const meshes = names.filter((name, i) => used[i] && MESHES.includes(extensionOf(name)))
  if (markups.length > 1 || (markups.length === 1 && meshes.length > 2))
    return used.map((is) => (is ? 'folder' : 'none'))
  const hasHeader = names.some((name) => HEADERS.includes(extensionOf(name)))
  return names.map((name, i) => {
    const content = contents[i] ?? null
    const extension = extensionOf(name)
    if (!used[i]) return 'none'
    if (COMPANIONS.includes(extension) || (hasHeader && VOXELS.includes(extension))) return 'voxels'
    const isMesh = MESHES.includes(extension)
    if (content === 'labels' || LABEL_MAPS.includes(extension)) return 'labels'
    if (/annul/i.test(name)) return 'annulus'
    if (/chord/i.test(name) || content === 'chordae') return 'chordae'
    if (/tips|papill/i.test(name) || content === 'tips') return isMesh ? 'none' : 'tips'
    if (isMesh && /systol|closed/i.test(name) && meshes.length > 1) return 'surface'
    if (POSTERIOR.test(name)) return isMesh ? 'posterior' : 'none'
    if (content === 'curve') return 'annulus'
    if (content === 'points') return 'landmarks'
    return isMesh ? 'anterior' : 'none'
  })
}

/// What is asked for at first: the service sorts all that look like a part of a valve, but for folders and fits.
export function firstRoles(guesses: Role[]): Role[] {
  return guesses.map((guess) => (['surface', 'folder', 'none'].includes(guess) ? guess : 'detected'))
}

/// As they go to the service, which detects both leaflets or neither, and voxels only beside a detected header.
export function statedRoles(roles: Role[], guesses: Role[]): Role[] {
  const one = roles.find(isLeaflet)
  return roles.map((role, i) => {
    const guess = guesses[i] as Role
    if (role !== 'detected') return role
    if (one && isLeaflet(guess)) return one === 'anterior' ? 'posterior' : 'anterior'
    return guess === 'voxels' && roles.includes('labels') ? 'voxels' : role
  })
}

function isLeaflet(role: Role): boolean {
  return role === 'anterior' || role === 'posterior'
}

/// The files that are used, in the service's order, with the pointers by which its problems name them.
export function placed<T>(files: T[], roles: Role[]): Map<string, T> {
  const of = (role: Role): T[] => files.filter((_, i) => roles[i] === role)
  const places = new Map<string, T>()
  for (const [i, file] of of('detected').entries()) places.set(`/files/${i}`, file)
  for (const [i, file] of [...of('anterior'), ...of('posterior')].entries()) places.set(`/leaflets/${i}`, file)
  for (const role of ['labels', 'voxels', 'annulus', 'chordae', 'tips', 'landmarks'] as const)
    for (const file of of(role)) places.set(`/${role}`, file)
  for (const file of of('surface')) places.set('/fit/surface', file)
  for (const [i, file] of of('folder').entries()) places.set(`/slicerheart/${i}`, file)
  return places
}

export type Unit = NonNullable<ImportRequest['units']>
export type Axes = NonNullable<ImportRequest['frame']>
export type LabelPart = NonNullable<LabelTaken['part']>

/// Null, false and empty: as the service has it.
export interface ImportSettings {
  name: string
  provenance: string[]
  triangles: number
  labels: LabelTaken[] // what a person said of them
  phase: number | null // of a label map
  grid: VoxelGrid | null
  axes: Axes | null
  units: Unit | null
  closed: boolean | null // whether the leaflets were imaged so
  hidden_mm: number | null
  trusts: boolean // labels, names and order, whatever the leaflets look like
  flips: boolean // the atrium is on the other side than it looks
  mirrored: boolean // the files are a mirror image
  inVivo: boolean // the leaflets are prestretched
  thickness: number | 'measured' | null // mm
  seed: number | null // of chordae that are drawn; null: they are among the files
  branches: number | null
  branch_at: number | null
  slack: number | null
  places: Places // that were picked
  fit: { leak_mm2: number | null; side: 'atrial' | 'middle' } | null // null: not now
}

export async function filesToImport(
  files: File[],
  given: Role[],
  settings: ImportSettings,
  guesses = given,
): Promise<ImportRequest> {
  const { name, triangles, labels, seed, places, fit, thickness } = settings
  const roles = statedRoles(given, guesses)
  const request: ImportRequest = { name, triangles }
  if (settings.provenance.length > 0) request.provenance = settings.provenance
  if (settings.units) request.units = settings.units
  if (settings.axes) request.frame = settings.axes
  if (settings.grid) request.grid = settings.grid
  if (settings.closed !== null) request.closed = settings.closed
  if (settings.trusts) request.trust_labels = true
  if (settings.flips) request.flip = true
  if (settings.mirrored) request.mirrored = true
  if (settings.inVivo) request.reference = 'in_vivo'
  for (const key of ['phase', 'hidden_mm', 'branches', 'branch_at', 'slack'] as const) {
    const value = settings[key]
    if (value !== null) request[key] = value
  }
  if (thickness === 'measured') request.thickness_measured = true
  else if (thickness !== null) request.thickness_mm = thickness
  for (const { number, part } of labels)
    if (part) request.label_numbers = { ...request.label_numbers, [part]: [...numbersOf(request, part), number] }
  if (seed !== null) request.chordae_seed = seed
  for (const [place, file] of placed(files, roles)) {
    if (place === '/fit/surface') continue
    const part = await packed(file)
    if (place === '/annulus') request.annulus = part
    else if (place === '/labels') request.labels = part
    else if (place === '/voxels') request.voxels = part
    else if (place === '/chordae') request.chordae = part
    else if (place === '/tips') request.tips = part
    else if (place === '/landmarks') request.landmarks = part
    else if (place.startsWith('/files/')) request.files = [...(request.files ?? []), part]
    else if (place.startsWith('/leaflets/')) request.leaflets = [...(request.leaflets ?? []), part]
    else request.slicerheart = [...(request.slicerheart ?? []), part]
  }
  const seen = LANDMARKS.filter(([key]) => places[key])
  if (seen.length > 0) request.landmarks = Object.fromEntries(seen.map(([key]) => [key, places[key]]))
  const tips = tipsFile(places)
  if (tips && seed !== null && !request.slicerheart) request.tips ??= tips
  if (!fit) return request
  const surface = placed(files, roles).get('/fit/surface')
  request.fit = { side: fit.side }
  if (surface) request.fit.surface = await packed(surface)
  if (fit.leak_mm2 !== null) request.fit.leak_mm2 = fit.leak_mm2
  return request
}

function numbersOf(request: ImportRequest, part: LabelPart): number[] {
  const numbers = request.label_numbers?.[part] ?? []
  return typeof numbers === 'number' ? [numbers] : numbers
}

/// Those that were picked, if both were.
function tipsFile(places: Places): FileToImport | null {
  const rows = TIPS.flatMap(([key, side]) => (places[key] ? [`${side},${(places[key] as Vector).join(',')}\n`] : []))
  return rows.length === TIPS.length ? { name: 'tips.csv', text: rows.join('') } : null
}

const LEAST_OF_TEXT = 9 // a tab

/// As the service takes a file: what is text as text.
export async function packed(file: File): Promise<FileToImport> {
  const bytes = new Uint8Array(await file.arrayBuffer())
  try {
    if (bytes.every((byte) => byte >= LEAST_OF_TEXT))
      return { name: file.name, text: new TextDecoder('utf-8', { fatal: true, ignoreBOM: true }).decode(bytes) }
  } catch {
    // Not UTF-8.
  }
  let letters = ''
  for (let i = 0; i < bytes.length; i += 32_768) letters += String.fromCharCode(...bytes.subarray(i, i + 32_768))
  return { name: file.name, base64: btoa(letters) }
}
