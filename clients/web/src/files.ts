// Files of a closed valve that other programs open.
import { request } from './api/http'
import { download, h, select } from './dom'
import { labelledButton } from './icons'
import { HAS_SERVICE } from './mode'
import { problemList } from './problems'
import { problemsOf, type Workspace } from './workspace'
import parts from './style/parts.module.css'

const FORMATS = [
  ['glb', 'GLB'],
  ['vtk', 'VTK'],
  ['ply', 'PLY'],
  ['obj', 'OBJ'],
  ['stl', 'STL'],
  ['mrk.json', 'markups'],
  ['csv', 'measurements'],
  ['feb', 'FEBio'],
  ['nrrd', 'label map'],
] as const

export interface FileSaver {
  element: HTMLElement
  button: HTMLButtonElement
}

/// A button beside the formats; `get` fetches one, `name` is what stands before the dot. What goes wrong is said in `told`.
export function fileSaver(
  { label, title }: { label: string; title: string },
  get: (format: string) => Promise<Blob>,
  name: () => string,
  told: HTMLElement,
): FileSaver {
  let format: string = FORMATS[0][0]
  const formats = select(FORMATS, format, (chosen) => (format = chosen))
  formats.setAttribute('aria-label', 'File format')
  const press = labelledButton('save', label, title, () => void save())
  async function save(): Promise<void> {
    press.disabled = true
    try {
      download(`${name()}.${format}`, await get(format))
      told.replaceChildren()
    } catch (error) {
      told.replaceChildren(problemList(problemsOf(error)))
    }
    press.disabled = false
  }
  const element = HAS_SERVICE ? h('span', { class: parts.joined }, press, formats) : h('span', { hidden: true })
  return { element, button: press }
}

/// Of the open valve, as the present plan leaves it.
export function closureSaver(workspace: Workspace, isRepaired: boolean, told: HTMLElement): FileSaver {
  const get = async (format: string): Promise<Blob> => {
    const plan = isRepaired ? { plan: workspace.plan } : {}
    return (await request('POST', '/v1/exports', { valve: workspace.valve?.reference, ...plan, format })).blob()
  }
  return fileSaver({ label: 'Save', title: 'Save file' }, get, () => (isRepaired ? 'repaired' : 'valve'), told)
}
