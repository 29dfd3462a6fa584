// Files of a segmentation tool: what each of them is, what is wrong with it, and the valve that they make.
import { importValve } from '../api/calls'
import type { Problem } from '../api/types'
import { button, field, h, select } from '../dom'
import { problemList } from '../problems'
import { nameValve } from '../state/valves'
import { problemsOf } from '../workspace'
import { ROLES, type Role, filesToImport, guessedRoles, placed } from './parts'
import parts from '../style/parts.module.css'
import valveStyle from './valve.module.css'

const USUAL_TRIANGLES = 720

export interface ImportPanel {
  element: HTMLElement
  /// Files that are no valve of coapt's own.
  take(files: File[]): void
}

/// `open` is called with the valve that came of the files.
export function importPanel(open: (id: string, name: string) => Promise<void>): ImportPanel {
  let files: File[] = []
  let roles: Role[] = []
  const rows = h('ul', { class: valveStyle.files })
  const said = h('p', { class: parts.hint, 'aria-live': 'polite' })
  const rest = h('div', {}) // problems of no file
  const chosen = h('input', {
    type: 'file',
    multiple: true,
    accept: '.obj,.ply,.stl,.vtk,.csv,.json',
    onchange: () => take([...(chosen.files ?? [])]),
  })
  const name = h('input', { type: 'text', maxlength: 200, value: 'imported' })
  const triangles = h('input', { type: 'number', min: 100, max: 100000, value: USUAL_TRIANGLES })
  const go = button('Import', () => void run(), { class: parts.primary, disabled: true })
  const element = h(
    'details',
    { class: parts.more, 'data-part': 'import' },
    h('summary', {}, 'Import meshes'),
    h(
      'p',
      { class: parts.hint },
      'Leaflets (OBJ, PLY, STL or VTK), annulus and chordae (CSV, or markups of Slicer), in millimetres; or all files of a ' +
        'SlicerHeart folder.',
    ),
    field('Files', chosen),
    rows,
    field('Name', name),
    field('Triangles, about', triangles),
    go,
    said,
    rest,
  )

  function take(given: File[]): void {
    files = given
    roles = guessedRoles(files.map((file) => file.name))
    element.open = true
    go.disabled = files.length === 0
    said.textContent = ''
    show([])
  }

  async function run(): Promise<void> {
    go.disabled = true
    said.textContent = 'making a valve ...'
    try {
      const { id } = await importValve(await filesToImport(files, roles, name.value, Number(triangles.value)))
      show([])
      nameValve(id, name.value)
      said.textContent = ''
      await open(id, name.value)
    } catch (error) {
      const problems = problemsOf(error)
      said.textContent = `No valve can be made of these files: ${problems.length === 1 ? 'one problem.' : `${problems.length} problems.`}`
      show(problems)
    }
    go.disabled = files.length === 0
  }

  /// Each problem beside its file.
  function show(problems: Problem[]): void {
    const places = placed(files, roles)
    const others = new Set(problems)
    rows.replaceChildren(
      ...files.map((file, i) => {
        const own = problems.filter(({ path }) =>
          [...places].some(([place, of]) => of === file && isBelow(path, place)),
        )
        for (const problem of own) others.delete(problem)
        const role = select(ROLES, roles[i] ?? 'none', (value) => {
          roles[i] = value as Role
        })
        role.setAttribute('aria-label', `What ${file.name} is`)
        return h('li', {}, h('span', {}, file.name), role, problemList(own))
      }),
    )
    rest.replaceChildren(problemList([...others]))
  }

  return { element, take }
}

function isBelow(path: string, place: string): boolean {
  return path === place || path.startsWith(`${place}/`)
}
