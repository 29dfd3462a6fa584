// Files of a job for the person at the browser.
import { getBlob, hasToken } from '../api/http'
import { button, download, h, select } from '../dom'
import { problemList } from '../problems'
import { problemsOf } from '../workspace'

const FORMATS = [
  ['ply', 'PLY'],
  ['obj', 'OBJ'],
  ['stl', 'STL'],
  ['vtk', 'VTK'],
  ['glb', 'GLB'],
] as const

/// A button that fetches `path` and saves it as `name`; what goes wrong is said in `told`.
export function downloadButton(label: string, path: string, name: string, told: HTMLElement): HTMLButtonElement {
  const element = button(label, () => void save(path, name, told, element))
  return element
}

async function save(path: string, name: string, told: HTMLElement, pressed: HTMLButtonElement): Promise<void> {
  pressed.disabled = true
  try {
    download(name, await getBlob(path))
    told.replaceChildren()
  } catch (error) {
    told.replaceChildren(problemList(problemsOf(error)))
  }
  pressed.disabled = false
}

/// Of one plan: `path` is .../plans/RANK, `name` without what follows the dot.
export function meshDownload(path: string, name: string, told: HTMLElement): HTMLElement {
  let format = 'ply'
  const formats = select(FORMATS, format, (chosen) => (format = chosen))
  formats.setAttribute('aria-label', 'Format of the mesh')
  const get = button('Mesh', () => void save(`${path}/mesh?format=${format}`, `${name}.${format}`, told, get))
  return h('span', { class: 'joined' }, get, formats)
}

/// A page: in a tab of its own, or saved where only requests with a token get it.
export function reportLink(label: string, path: string, name: string, told: HTMLElement): HTMLElement {
  if (hasToken()) return downloadButton(label, path, name, told)
  return h('a', { class: 'button', href: path, target: '_blank', rel: 'noopener' }, label)
}

export function saveJson(name: string, value: unknown): void {
  download(name, new Blob([`${JSON.stringify(value, null, 2)}\n`], { type: 'application/json' }))
}
