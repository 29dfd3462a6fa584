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
import { type Corrections, decisionControls, labelChoice } from './corrections'
import { holds, leftOut, unreadable } from './file_words'
import { ACCEPTED, isImportable, MOST_FILES } from './formats'
import { importForm } from './import_form'
import { importResult, type ImportStage } from './import_stage'
import { landmarkList } from './landmark_list'
import { filesToImport, firstRoles, guessedRoles, packed, placed, type Role, ROLES, statedRoles } from './parts'
import parts from '../style/parts.module.css'
import valveStyle from './valve.module.css'

interface Shown {
  job: Job
  made: ImportResult
  fitted: boolean
  element: HTMLElement
}

export interface ImportPanel {
  element: HTMLElement
  /// Files that are no valve of coapt's own.
  take(files: File[]): void
}

/// `open` is called with the valve that came of the files; `stage` shows them, and what was decided.
export function importPanel(open: (id: string, name: string) => Promise<void>, stage: ImportStage): ImportPanel {
  let files: File[] = []
  let roles: Role[] = [] // as asked for
  let guesses: Role[] = [] // what they look like
  let looked: (FileLookedAt | null)[] = []
  let looking = new AbortController()
  const rows = h('ul', { class: valveStyle.files })
  const said = h('p', { class: parts.hint, 'aria-live': 'polite' })
  const rest = h('div', {}) // problems of no file
  let labels: LabelTaken[] = [] // what a person said of them
  let shown: Shown | null = null // the last result
  const landmarks = landmarkList(() => stage.files())
  const form = importForm(() => settle(), landmarks.element)
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
  const options = h('div', { hidden: true }, form.element, h('p', {}, go), fitting)
  const element = h(
    'details',
    { class: parts.more, 'data-part': 'import' },
    h('summary', {}, 'Import meshes'),
    h(
      'p',
      { class: parts.hint },
      'A label map (NRRD, NIfTI or MetaImage), or leaflets (OBJ, PLY, STL, glTF, VTK, VTP or VTU) and annulus (a table or ' +
        'a curve from Slicer), in one coordinate system; chordae, papillary tips and landmarks if imaged; or a ' +
        'SlicerHeart folder. Compressed label maps (.gz, .bz2) are read as they are. Remove patient identifiers first.',
    ),
    h(
      'div',
      { class: parts.row },
      filePicker('Files', 'Choose files', { multiple: true, accept: ACCEPTED, use: take }),
      filePicker('Folder', 'Choose a folder', { webkitdirectory: true, use: take }),
      filePicker('Others to add', 'Add files', { multiple: true, accept: ACCEPTED, use: addMore }),
    ),
    rows,
    options,
    said,
    rest,
  )

  function take(given: File[]): void {
    labels = []
    shown = null
    form.reset()
    landmarks.clear()
    files = []
    roles = []
    looked = []
    add(given)
  }

  function addMore(more: File[]): void {
    shown = null
    add(more)
  }

  /// To those that there are; `role`: of them all.
  function add(given: File[], role: Role | null = null): void {
    const usable = given.filter(({ name }) => isImportable(name))
    const left = given.length - usable.length
    const before = [...roles]
    files = [...files, ...usable]
    looked = files.map((_, i) => looked[i] ?? null)
    guesses = guessedRoles(
      files.map(({ name }) => name),
      looked.map((file) => file?.content ?? null),
    )
    roles = [
      ...before,
      ...firstRoles(guesses)
        .slice(before.length)
        .map((first) => role ?? first),
    ]
    element.open = true
    options.hidden = files.length === 0
    rest.replaceChildren()
    said.textContent = ''
    settle()
    show([])
    void look().then(() => {
      if (left > 0) said.textContent = leftOut(left)
    })
  }

  /// What the files hold, beside them and on the stage.
  async function look(): Promise<void> {
    looking.abort()
    looking = new AbortController()
    const { signal } = looking
    if (files.length === 0) return stage.hide()
    if (files.length > MOST_FILES) {
      said.textContent = `There are ${files.length} files; at most ${MOST_FILES} can be imported at once.`
      go.disabled = fit.disabled = true
      return
    }
    said.textContent = 'Reading the files ...'
    try {
      const found = await lookAtFiles(await Promise.all(files.map(packed)), signal)
      looked = found
      const first = firstRoles(guesses)
      guesses = guessedRoles(
        files.map((file) => file.name),
        found.map(({ content }) => content),
      )
      const now = firstRoles(guesses)
      roles = roles.map((role, i) => (role === first[i] ? (now[i] as Role) : role)) // but for those that a person chose
      said.textContent = ''
      settle()
      show([])
    } catch (error) {
      if (signal.aborted) return
      said.textContent = 'The files cannot be shown.'
      rest.replaceChildren(problemList(problemsOf(error)))
    }
  }

  /// What each is taken for.
  function shownRoles(): Role[] {
    return roles.map((role, i) => (role === 'detected' ? (guesses[i] as Role) : role))
  }

  /// What follows from the roles.
  function settle(): void {
    const are = new Set(shownRoles())
    form.settle({ labelMap: are.has('labels'), chordae: are.has('chordae'), folder: are.has('folder') })
    go.disabled = fit.disabled = files.length === 0 || files.length > MOST_FILES
    fitting.hidden = form.values().closed !== 'closed' && !are.has('surface')
  }

  function draw(): void {
    const are = shownRoles()
    stage.files().set(looked.flatMap((file, i) => (file && are[i] !== 'none' ? [{ file, role: are[i] as Role }] : [])))
  }

  /// Whether a valve was made.
  async function run(fits: boolean): Promise<boolean> {
    landmarks.stop()
    go.disabled = fit.disabled = true
    said.textContent = 'Making a valve ...'
    const known = leak.value.trim() === '' ? null : Number(leak.value)
    try {
      const fitted = fits ? { leak_mm2: known, side } : null
      const settings = { ...form.settings(), labels, places: landmarks.places(), fit: fitted }
      const job = await startImport(await filesToImport(files, roles, settings, guesses))
      show([])
      await follow(job, fits)
      said.textContent = ''
      settle()
      return true
    } catch (error) {
      const problems = problemsOf(error)
      said.textContent =
        problems.length === 1
          ? 'No valve can be made from these files: one problem.'
          : `No valve can be made from these files: ${problems.length} problems.`
      show(problems)
      if (shown?.element.isConnected) tell(problems)
      settle()
      return false
    }
  }

  /// Beside the controls that asked for it.
  function tell(problems: Problem[], words = ''): void {
    if (!shown) return
    shown.element.querySelector('[data-part=told]')?.remove()
    shown.element.prepend(
      h('div', { 'data-part': 'told' }, words && h('p', { role: 'status' }, words), problemList(problems)),
    )
    shown.element.scrollIntoView({ block: 'start' })
  }

  /// Of the last result: set, then the valve is made again; if none can be made, all is as it was.
  async function change(subject: string, set: () => void): Promise<void> {
    const before = { files, roles, guesses, looked, labels, values: form.values() }
    roles = [...roles]
    set()
    if (shown) {
      const { element } = shown
      element.inert = true
      element.setAttribute('aria-busy', 'true')
      tell([], 'Importing again with this change ...')
    }
    const isMade = await run(false)
    if (!isMade && shown) {
      looking.abort() // at files that are taken back
      const problems = shown.element.querySelector('[data-part=told] [role=alert]')
      ;({ files, roles, guesses, looked, labels } = before)
      form.set(before.values)
      settle()
      present()
      show([])
      said.textContent = ''
      tell([], 'This change cannot be made; the valve is as it was before.')
      if (problems) shown.element.querySelector('[data-part=told]')?.append(problems)
    }
    shown?.element.querySelector<HTMLElement>(`[data-subject="${subject}"] :is(select, button, input)`)?.focus()
  }

  /// What the controls beside decisions do: they set those of the form, then the valve is made again.
  function corrections(): Corrections {
    const stated = statedRoles(roles, guesses)
    const one = (role: Role): number =>
      stated.filter((other) => other === role).length === 1 ? stated.indexOf(role) : -1
    const [anterior, posterior] = [one('anterior'), one('posterior')]
    const sorted = files.flatMap(({ name }, i) =>
      stated[i] === 'detected' ? [{ name, role: 'detected' as Role, i }] : [],
    )
    const state = (i: number, role: Role): void => {
      roles[i] = role
      if (role === 'anterior' || role === 'posterior') form.set({ trusts: true })
    }
    return {
      values: form.values(),
      files: sorted,
      set: (subject, values) => void change(subject, () => form.set(values)),
      take: (taken) => void change('leaflets', () => (labels = taken)),
      role: (at, role) => void change('leaflets', () => state(sorted[at]?.i ?? -1, role)),
      exchange:
        anterior < 0 || posterior < 0
          ? null
          : () =>
              void change('leaflets', () => {
                state(anterior, 'posterior')
                state(posterior, 'anterior')
              }),
      contour: (file) =>
        void change('annulus', () => {
          const are = shownRoles()
          roles = roles.map((role, i) => (are[i] === 'annulus' ? 'none' : role))
          add([file], 'annulus')
        }),
      pick() {
        draw()
        landmarks.open()
      },
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
      if (!shown) stage.hide()
      const problems: Problem[] = last.problems
      throw problems.length > 0 ? new JobFailed(problems) : new Error('The import was cancelled.')
    }
    const made = await getJson<ImportResult>(last.links.result)
    nameValve(made.valve, made.name)
    await open(made.valve, made.name)
    shown = { job: last, made, fitted: fits, element }
    present()
  }

  /// The last result.
  function present(): void {
    if (!shown) return
    const { job, made, fitted } = shown
    shown.element = importResult(job, made, actions(made, fitted), decisionControls(made, corrections()))
    stage.show(shown.element)
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
    const places = placed(files, statedRoles(roles, guesses))
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
          h('span', {}, file.name, ' ', h('small', { class: parts.hint }, holds(file.name, looked[i] ?? null))),
          role,
          shownRoles()[i] === 'labels' && labelsOf(looked[i] ?? null),
          problemList(own.length > 0 || shownRoles()[i] === 'none' ? own : unreadable(file.name, looked[i] ?? null)),
        )
      }),
    )
    rest.replaceChildren(problemList([...others]))
    if (problems.length === 0 && looked.some((file) => file !== null) && !shown?.element.isConnected) draw()
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

function isBelow(path: string, place: string): boolean {
  return path === place || path.startsWith(`${place}/`)
}
