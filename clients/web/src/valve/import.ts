// Files of a segmentation tool: what each of them is, what is wrong with it, and the valve that they make.
import { lookAtFiles, startImport } from '../api/calls'
import { getJson } from '../api/http'
import type { FileLookedAt, ImportResult, Job, LabelTaken, Problem } from '../api/types'
import { button, field, filePicker, h, select } from '../dom'
import { hasEnded } from '../jobs/calls'
import { followJob } from '../jobs/follow'
import { progressPanel } from '../jobs/progress_panel'
import { problemList } from '../problems'
import { nameValve } from '../state/valves'
import { JobFailed, problemsOf } from '../workspace'
import { type Corrections, decisionControls, labelChoice, UNITS } from './corrections'
import { importResult, type ImportStage } from './import_stage'
import { landmarkList } from './landmark_list'
import { ROLES, type ImportSettings, type Role, type Unit, filesToImport, guessedRoles, packed, placed } from './parts'
import parts from '../style/parts.module.css'
import valveStyle from './valve.module.css'
import { counted } from '../format'

const USUAL_TRIANGLES = 720

export interface ImportPanel {
  element: HTMLElement
  /// Files that are no valve of coapt's own.
  take(files: File[]): void
}

/// `open` is called with the valve that came of the files; `stage` shows them, and what was decided.
export function importPanel(open: (id: string, name: string) => Promise<void>, stage: ImportStage): ImportPanel {
  let files: File[] = []
  let roles: Role[] = []
  let looked: (FileLookedAt | null)[] = []
  let looking = new AbortController()
  let drawsByHand: boolean | null = null // whether chordae are drawn, if a person said so
  const rows = h('ul', { class: valveStyle.files })
  const said = h('p', { class: parts.hint, 'aria-live': 'polite' })
  const rest = h('div', {}) // problems of no file
  const name = h('input', { type: 'text', maxlength: 200, value: 'imported' })
  const triangles = h('input', { type: 'number', min: 100, max: 100000, value: USUAL_TRIANGLES })
  let labels: LabelTaken[] = [] // what a person said of them
  let result: HTMLElement | null = null // that is shown
  const unit = select([['', 'by the annulus'], ...UNITS], '', () => {})
  const state = select(
    [
      ['', 'detect from the shape'],
      ['open', 'open'],
      ['closed', 'closed'],
    ],
    '',
    () => settle(),
  )
  const trusts = h('input', { type: 'checkbox' })
  const flips = h('input', { type: 'checkbox' })
  const mirrored = h('input', { type: 'checkbox' })
  const draws = h('input', {
    type: 'checkbox',
    onchange: () => {
      drawsByHand = draws.checked
      settle()
    },
  })
  const seed = h('input', { type: 'number', min: 0, max: 2147483647, value: 1 })
  const landmarks = landmarkList(() => stage.files())
  const leak = h('input', { type: 'number', min: 0, max: 2000, step: 'any', placeholder: 'unknown' })
  let side: 'atrial' | 'middle' = 'atrial'
  const sides = select(
    [
      ['atrial', 'atrial side of the leaflets'],
      ['middle', 'mid-surface of the leaflets'],
    ],
    side,
    (value) => (side = value as typeof side),
  )
  const go = button('Import', () => void run(false), { class: parts.primary, disabled: true })
  const fit = button('Import and fit', () => void run(true), { disabled: true })
  const fitting = h(
    'fieldset',
    { class: valveStyle.fit, hidden: true },
    h('legend', {}, 'Fit to the closed leaflets'),
    h(
      'p',
      { class: parts.hint },
      'Chordae, tips and tissue are adjusted until the valve closes onto these leaflets. This takes seconds to minutes.',
    ),
    field('Segmented surface', sides),
    field('Imaged leak', leak, 'mm²'),
    fit,
  )
  const options = h(
    'div',
    { hidden: true },
    field('Name', name),
    field('Units', unit),
    field('Leaflets were imaged', state),
    field('Synthesise chordae', draws),
    field('Seed of synthesised chordae', seed),
    field('Triangles (approximate)', triangles),
    landmarks.element,
    h(
      'details',
      { class: parts.more, 'data-part': 'corrections' },
      h('summary', {}, 'Correct detected properties'),
      field('Labels and order are correct', trusts),
      field('Atrium on the other side', flips),
      field('Mirror image', mirrored),
    ),
    h('p', {}, go),
    fitting,
  )
  const element = h(
    'details',
    { class: parts.more, 'data-part': 'import' },
    h('summary', {}, 'Import meshes'),
    h(
      'p',
      { class: parts.hint },
      'A label map (NRRD, NIfTI or MetaImage), or leaflets (OBJ, PLY, STL, glTF, VTK, VTP or VTU) and annulus (CSV, or a curve of Slicer), in one coordinate ' +
        'system; chordae and papillary tips if imaged; or all files of a SlicerHeart folder. Remove patient identifiers ' +
        'first.',
    ),
    filePicker('Files', 'Choose files', {
      multiple: true,
      accept: '.obj,.ply,.stl,.glb,.gltf,.vtk,.vtp,.vtu,.nrrd,.nhdr,.nii,.gz,.bz2,.mha,.mhd,.raw,.zraw,.csv,.json',
      use: take,
    }),
    rows,
    options,
    said,
    rest,
  )

  function take(given: File[]): void {
    files = given
    looked = given.map(() => null)
    roles = guessedRoles(files.map((file) => file.name))
    drawsByHand = null
    labels = []
    result = null
    for (const input of [trusts, flips, mirrored]) input.checked = false
    for (const choice of [unit, state]) choice.value = ''
    element.open = true
    options.hidden = files.length === 0
    said.textContent = ''
    landmarks.clear()
    settle()
    show([])
    void look()
  }

  /// What the files hold, beside them and on the stage.
  async function look(): Promise<void> {
    looking.abort()
    looking = new AbortController()
    const { signal } = looking
    if (files.length === 0) return stage.hide()
    said.textContent = 'reading the files ...'
    try {
      const found = await lookAtFiles(await Promise.all(files.map(packed)), signal)
      looked = found
      roles = guessedRoles(
        files.map((file) => file.name),
        found.map(({ content }) => content),
      )
      said.textContent = ''
      settle()
      show([])
    } catch (error) {
      if (signal.aborted) return
      said.textContent = 'The files cannot be shown.'
      rest.replaceChildren(problemList(problemsOf(error)))
    }
  }

  /// What follows from the roles.
  function settle(): void {
    const isFolder = roles.includes('folder')
    draws.checked = drawsByHand ?? (!isFolder && !roles.includes('chordae'))
    seed.disabled = !draws.checked
    go.disabled = fit.disabled = files.length === 0
    fitting.hidden = state.value !== 'closed' && !roles.includes('surface')
  }

  function draw(): void {
    stage
      .files()
      .set(looked.flatMap((file, i) => (file && roles[i] !== 'none' ? [{ file, role: roles[i] as Role }] : [])))
  }

  function settings(fits: boolean): ImportSettings {
    const known = leak.value.trim() === '' ? null : Number(leak.value)
    return {
      name: name.value,
      triangles: Number(triangles.value),
      labels,
      units: unit.value === '' ? null : (unit.value as Unit),
      closed: state.value === '' ? null : state.value === 'closed',
      trusts: trusts.checked,
      flips: flips.checked,
      mirrored: mirrored.checked,
      seed: draws.checked ? Number(seed.value) : null,
      places: landmarks.places(),
      fit: fits ? { leak_mm2: known, side } : null,
    }
  }

  async function run(fits: boolean): Promise<void> {
    landmarks.stop()
    go.disabled = fit.disabled = true
    said.textContent = 'making a valve ...'
    try {
      const job = await startImport(await filesToImport(files, roles, settings(fits)))
      show([])
      await follow(job, fits)
      said.textContent = ''
    } catch (error) {
      const problems = problemsOf(error)
      said.textContent = `No valve can be made from these files: ${problems.length === 1 ? 'one problem.' : `${problems.length} problems.`}`
      show(problems)
      if (result?.isConnected) {
        result.querySelector('[data-part=problems]')?.remove()
        result.prepend(problemList(problems)) // beside the control that asked for it
        result.scrollIntoView({ block: 'start' })
      }
    }
    settle()
  }

  /// What the controls beside decisions do: they set those of the form, then the valve is made again.
  function corrections(): Corrections {
    const change = (set: () => void): void => {
      set()
      void run(false)
    }
    const one = (role: Role): number =>
      roles.filter((other) => other === role).length === 1 ? roles.indexOf(role) : -1
    const [anterior, posterior] = [one('anterior'), one('posterior')]
    return {
      take: (taken) => change(() => (labels = taken)),
      exchange:
        anterior < 0 || posterior < 0
          ? null
          : () =>
              change(() => {
                roles[anterior] = 'posterior'
                roles[posterior] = 'anterior'
              }),
      units: (of) => change(() => (unit.value = of)),
      closed: (is) => change(() => (state.value = is ? 'closed' : 'open')),
      flip: () => change(() => (flips.checked = !flips.checked)),
      mirror: () => change(() => (mirrored.checked = !mirrored.checked)),
      flipped: flips.checked,
      mirrored: mirrored.checked,
    }
  }

  /// Until it has ended; then its valve is opened.
  async function follow(first: Job, fits: boolean): Promise<void> {
    let last = first
    const panel = progressPanel(first, fits ? 'fit' : 'import')
    if (fits) stage.show(panel.element)
    const watcher = {
      progress: panel.show,
      changed(job: Job) {
        last = job
        if (!hasEnded(job.state)) panel.change(job)
      },
    }
    await followJob(first.id, watcher, new AbortController().signal)
    if (last.state === 'FAILED' || !last.links.result) {
      stage.hide()
      const problems: Problem[] = last.problems
      throw problems.length > 0 ? new JobFailed(problems) : new Error('The import was cancelled.')
    }
    const made = await getJson<ImportResult>(last.links.result)
    nameValve(made.valve, made.name)
    await open(made.valve, made.name)
    result = importResult(last, made, actions(made, fits), decisionControls(made, corrections()))
    stage.show(result)
  }

  function actions(made: ImportResult, wasFitted: boolean): HTMLElement {
    const search = h(
      'a',
      { class: `${parts.button} ${parts.primary}`, href: `#/search?valve=${made.valve}` },
      'Continue to search',
    )
    const again = button('Back to the files', () => draw())
    const canFit = !wasFitted && (made.closed || !fitting.hidden)
    return h('p', { class: parts.row }, search, canFit && button('Fit to closed leaflets', () => void run(true)), again)
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
          settle()
          show([])
        })
        role.setAttribute('aria-label', `What ${file.name} is`)
        return h(
          'li',
          {},
          h('span', {}, file.name, ' ', h('small', { class: parts.hint }, holds(looked[i] ?? null))),
          role,
          roles[i] === 'labels' && labelsOf(looked[i] ?? null),
          problemList(own),
        )
      }),
    )
    rest.replaceChildren(problemList([...others]))
    if (problems.length === 0 && looked.some((file) => file !== null)) draw()
  }

  /// The labels of a map, of which a person may say what they are before it is imported.
  function labelsOf(file: FileLookedAt | null): HTMLElement | false {
    if (!file || file.parts.length === 0) return false
    const said = file.parts.map(
      ({ number }) => labels.find((label) => label.number === number) ?? { number, part: null },
    )
    return labelChoice(said, 'detected', (taken) => {
      labels = taken
      show([])
    })
  }

  return { element, take }
}

/// What is in a file, in a few words.
function holds(file: FileLookedAt | null): string {
  if (!file) return ''
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

function isBelow(path: string, place: string): boolean {
  return path === place || path.startsWith(`${place}/`)
}
