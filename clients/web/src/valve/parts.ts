// Which part of a valve a file of a segmentation tool holds, and how it goes to the service.
import type { FileLookedAt, FileToImport, ImportRequest, LabelTaken, Vector } from '../api/types'
import { LANDMARKS, TIPS, type Places } from './landmark_places'

export const ROLES = [
  ['anterior', 'anterior or both leaflets'],
  ['posterior', 'posterior leaflet'],
  ['labels', 'segmentation (label map)'],
  ['voxels', 'voxels of the label map'],
  ['annulus', 'annulus'],
  ['chordae', 'chordae'],
  ['tips', 'papillary tips'],
  ['surface', 'closed leaflets (target of the fit)'],
  ['folder', 'file of a SlicerHeart folder'],
  ['none', 'not used'],
] as const
export type Role = (typeof ROLES)[number][0]

const MESHES = ['obj', 'ply', 'stl', 'glb', 'gltf', 'vtk', 'vtp', 'vtu']
const HEADERS = ['nhdr', 'mhd'] // of label maps whose voxels are in a file of their own
const LABEL_MAPS = ['nrrd', 'nii', 'gz', 'bz2', 'mha', ...HEADERS] // gz and bz2: of any of them
const VOXELS = ['raw', 'zraw', 'gz', 'bz2']
const BINARY = ['ply', 'stl', 'glb', 'vtk', 'vtp', 'vtu', ...LABEL_MAPS, ...VOXELS] // may be

function extensionOf(name: string): string {
  return name.split('.').pop()?.toLowerCase() ?? ''
}

/// By their names, then by what is in them (null: not known yet); a folder of SlicerHeart has markups beside its meshes.
export function guessedRoles(names: string[], contents: (FileLookedAt['content'] | null)[] = []): Role[] {
  const markups = names.filter((name) => name.toLowerCase().endsWith('.mrk.json'))
  const meshes = names.filter((name) => MESHES.includes(extensionOf(name)))
  if (markups.length > 1 || (markups.length === 1 && meshes.length > 2)) return names.map(() => 'folder')
  const hasHeader = names.some((name) => HEADERS.includes(extensionOf(name)))
  return names.map((name, i) => {
    const content = contents[i] ?? null
    if (hasHeader && VOXELS.includes(extensionOf(name))) return 'voxels'
    const isMesh = MESHES.includes(extensionOf(name))
    if (content === 'labels' || LABEL_MAPS.includes(extensionOf(name))) return 'labels'
    if (/annul/i.test(name)) return 'annulus'
    if (/chord/i.test(name) || content === 'chordae') return 'chordae'
    if (/tips|papill/i.test(name) || content === 'tips') return isMesh ? 'none' : 'tips'
    if (isMesh && /systol|closed/i.test(name) && meshes.length > 1) return 'surface'
    if (/posterior/i.test(name)) return 'posterior'
    if (content === 'curve') return 'annulus'
    return isMesh ? 'anterior' : 'none'
  })
}

/// The files that are used, in the service's order, with the pointers by which its problems name them.
export function placed<T>(files: T[], roles: Role[]): Map<string, T> {
  const of = (role: Role): T[] => files.filter((_, i) => roles[i] === role)
  const places = new Map<string, T>()
  for (const [i, file] of [...of('anterior'), ...of('posterior')].entries()) places.set(`/leaflets/${i}`, file)
  for (const role of ['labels', 'voxels', 'annulus', 'chordae', 'tips'] as const)
    for (const file of of(role)) places.set(`/${role}`, file)
  for (const file of of('surface')) places.set('/fit/surface', file)
  for (const [i, file] of of('folder').entries()) places.set(`/slicerheart/${i}`, file)
  return places
}

export type Unit = 'mm' | 'cm' | 'in' | 'm'
export type LabelPart = NonNullable<LabelTaken['part']>

export interface ImportSettings {
  name: string
  triangles: number
  labels: LabelTaken[] // what a person said of them
  units: Unit | null // null: guessed
  closed: boolean | null // whether the leaflets were imaged so; null: judged
  trusts: boolean // labels, names and order, whatever the leaflets look like
  flips: boolean // the atrium is on the other side than it looks
  mirrored: boolean // the files are a mirror image
  seed: number | null // of chordae that are drawn; null: they are among the files
  places: Places // that were picked
  fit: { leak_mm2: number | null; side: 'atrial' | 'middle' } | null // null: not now
}

export async function filesToImport(files: File[], roles: Role[], settings: ImportSettings): Promise<ImportRequest> {
  const { name, triangles, labels, units, closed, seed, places, fit } = settings
  const request: ImportRequest = { name, triangles }
  if (units) request.units = units
  if (closed !== null) request.closed = closed
  if (settings.trusts) request.trust_labels = true
  if (settings.flips) request.flip = true
  if (settings.mirrored) request.mirrored = true
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

/// As the service takes a file: what is surely text as text.
export async function packed(file: File): Promise<FileToImport> {
  if (!BINARY.includes(extensionOf(file.name))) return { name: file.name, text: await file.text() }
  const bytes = new Uint8Array(await file.arrayBuffer())
  let letters = ''
  for (let i = 0; i < bytes.length; i += 32_768) letters += String.fromCharCode(...bytes.subarray(i, i + 32_768))
  return { name: file.name, base64: btoa(letters) }
}
