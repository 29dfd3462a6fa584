// Files of a job for the person at the browser.
import { getBlob, hasToken } from '../api/http'
import { button, download, h } from '../dom'
import { fileSaver } from '../files'
import { problemList } from '../problems'
import { problemsOf } from '../workspace'
import parts from '../style/parts.module.css'

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
  return fileSaver(
    { label: 'Mesh', title: 'Save the mesh' },
    (format) => getBlob(`${path}/mesh?format=${format}`),
    () => name,
    told,
  ).element
}

/// A page: in a tab of its own, or saved where only requests with a token get it.
export function reportLink(label: string, path: string, name: string, told: HTMLElement): HTMLElement {
  if (hasToken()) return downloadButton(label, path, name, told)
  return h('a', { class: parts.button, href: path, target: '_blank', rel: 'noopener' }, label)
}

export function saveJson(name: string, value: unknown): void {
  download(name, new Blob([`${JSON.stringify(value, null, 2)}\n`], { type: 'application/json' }))
}
