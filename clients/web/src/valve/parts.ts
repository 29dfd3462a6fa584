// Which part of a valve a file of a segmentation tool holds, and how it goes to the service.
import type { FileToImport, ImportRequest } from '../api/types'

export const ROLES = [
  ['anterior', 'anterior leaflet, or both as one skirt'],
  ['posterior', 'posterior leaflet'],
  ['annulus', 'annulus'],
  ['chordae', 'chordae'],
  ['folder', 'file of a SlicerHeart folder'],
  ['none', 'not used'],
] as const
export type Role = (typeof ROLES)[number][0]

const MESHES = ['obj', 'ply', 'stl', 'vtk']
const BINARY = ['ply', 'stl'] // may be

function extensionOf(name: string): string {
  return name.split('.').pop()?.toLowerCase() ?? ''
}

/// By their names; a folder of SlicerHeart has markups beside its meshes.
export function guessedRoles(names: string[]): Role[] {
  const markups = names.filter((name) => name.toLowerCase().endsWith('.mrk.json'))
  const meshes = names.filter((name) => MESHES.includes(extensionOf(name)))
  if (markups.length > 1 || (markups.length === 1 && meshes.length > 2)) return names.map(() => 'folder')
  return names.map((name) => {
    if (/annul/i.test(name)) return 'annulus'
    if (/chord/i.test(name)) return 'chordae'
    if (/posterior/i.test(name)) return 'posterior'
    return MESHES.includes(extensionOf(name)) ? 'anterior' : 'none'
  })
}

/// The files that are used, in the service's order, with the pointers by which its problems name them.
export function placed<T>(files: T[], roles: Role[]): Map<string, T> {
  const of = (role: Role): T[] => files.filter((_, i) => roles[i] === role)
  const places = new Map<string, T>()
  for (const [i, file] of [...of('anterior'), ...of('posterior')].entries()) places.set(`/leaflets/${i}`, file)
  for (const role of ['annulus', 'chordae'] as const) for (const file of of(role)) places.set(`/${role}`, file)
  for (const [i, file] of of('folder').entries()) places.set(`/slicerheart/${i}`, file)
  return places
}

export async function filesToImport(
  files: File[],
  roles: Role[],
  name: string,
  triangles: number,
): Promise<ImportRequest> {
  const request: ImportRequest = { name, triangles }
  for (const [place, file] of placed(files, roles)) {
    const part = await packed(file)
    if (place === '/annulus') request.annulus = part
    else if (place === '/chordae') request.chordae = part
    else if (place.startsWith('/leaflets/')) request.leaflets = [...(request.leaflets ?? []), part]
    else request.slicerheart = [...(request.slicerheart ?? []), part]
  }
  return request
}

async function packed(file: File): Promise<FileToImport> {
  if (!BINARY.includes(extensionOf(file.name))) return { name: file.name, text: await file.text() }
  const bytes = new Uint8Array(await file.arrayBuffer())
  let letters = ''
  for (let i = 0; i < bytes.length; i += 32_768) letters += String.fromCharCode(...bytes.subarray(i, i + 32_768))
  return { name: file.name, base64: btoa(letters) }
}
