// What is said of files that are to be imported.
import type { FileLookedAt, Problem } from '../api/types'
import { counted } from '../format'
import { COMPANIONS, extensionOf } from './formats'

/// `count`: of those whose formats are not read.
export function leftOut(count: number): string {
  const elsewhere = 'DICOM and Abaqus models are imported on the command line.'
  return count === 1
    ? `One file is left out, because its format cannot be imported here. ${elsewhere}`
    : `${count} files are left out, because their formats cannot be imported here. ${elsewhere}`
}

/// Why it cannot be shown; of a companion that is no wonder.
export function unreadable(name: string, file: FileLookedAt | null): Problem[] {
  return file && !COMPANIONS.includes(extensionOf(name))
    ? file.problems.map((problem) => ({ ...problem, path: '' }))
    : []
}

/// What is in a file, in a few words.
export function holds(name: string, file: FileLookedAt | null): string {
  if (!file) return ''
  if (COMPANIONS.includes(extensionOf(name))) return 'belongs to the other files'
  if (file.problems.length > 0) return 'cannot be shown'
  const points = file.points.length / 3
  switch (file.content) {
    case 'surface':
    case 'labels':
      return file.faces.length === 0 ? 'label map' : counted(file.faces.length / 3, 'triangle')
    case 'curve':
      return `line of ${counted(points, 'point')}`
    case 'chordae':
      return counted(points / 2, 'chorda', 'chordae')
    case 'tips':
      return counted(points, 'papillary tip')
    case 'points':
      return counted(points, 'point')
    case 'unknown':
      return 'cannot be shown'
  }
}
