// Opening a valve: a preset, one that was opened before, or a file dropped or chosen.
import { presets, problemsOfValve, storeValve } from '../api/calls'
import type { Problem } from '../api/types'
import { field, filePicker, h } from '../dom'
import { droppedFiles } from '../dropped'
import { HAS_SERVICE } from '../mode'
import { problemList } from '../problems'
import { nameValve } from '../state/valves'
import { problemsOf, type ValveSource, type Workspace } from '../workspace'
import { ACCEPTED } from './formats'
import { importPanel } from './import'
import type { ImportStage } from './import_stage'
import { observedPanel } from './observed'
import { openedList } from './opened_list'
import { presetWords } from './presets'
import parts from '../style/parts.module.css'
import valveStyle from './valve.module.css'

const NO_IMPORT = 'Importing meshes requires coapt-server.'
const OWN = '' // in the list of presets: none of them is open
const CONTEXT = 60 // characters of the file around a problem

export interface OpenPanel {
  element: HTMLElement
  dropOn(whole: HTMLElement): void // takes files that are dropped on it
}

/// `stage`: where files that are imported are shown.
export function openPanel(workspace: Workspace, stage: ImportStage): OpenPanel {
  const problems = h('div', {})
  const said = h('p', { class: parts.hint, 'aria-live': 'polite' })
  const about = h('p', { class: parts.hint })
  const names = h('div', {})
  let choice: HTMLSelectElement | null = null
  let told: ValveSource | null = null // the valve that is said to be open
  presets().then(
    (list) => {
      choice = presetChoice(list, (name) => void open(name, name))
      names.replaceChildren(field('Preset', choice))
      tell()
    },
    (error: unknown) => show(problemsOf(error), ''),
  )
  workspace.subscribe(() => workspace.valve !== told && tell())

  /// Whoever opened it, here or in another view.
  function tell(): void {
    told = workspace.valve
    if (!told) return
    if (choice) choice.value = [...choice.options].some(({ value }) => value === told?.reference) ? told.reference : OWN
    show([], '')
    said.textContent = `${told.label} is open.`
    about.textContent = presetWords(told.reference)?.about ?? ''
  }

  async function open(reference: string, label: string): Promise<void> {
    said.textContent = `closing ${label} ...`
    try {
      await workspace.open({ reference, label })
    } catch (error) {
      show(problemsOf(error), '')
    }
  }

  async function take(given: File[]): Promise<void> {
    const [chosen] = given
    if (!chosen) return
    if (given.length > 1 || !chosen.name.toLowerCase().endsWith('.json')) return imports.take(given)
    const text = await chosen.text()
    said.textContent = `reading ${chosen.name} ...`
    try {
      const found = await problemsOfValve(text)
      if (found.length > 0) return show(found, text)
      const id = await storeValve(text)
      nameValve(id, chosen.name)
      await openStored(id, chosen.name)
    } catch (error) {
      show(problemsOf(error), text)
    }
  }

  function show(found: Problem[], text: string): void {
    problems.replaceChildren(problemList(found, (pointer) => placeOf(text, pointer)))
    if (found.length === 0) return
    said.textContent =
      found.length === 1
        ? 'The file cannot be opened: one problem.'
        : `The file cannot be opened: ${found.length} problems.`
  }

  /// A valve that was stored just now.
  async function openStored(id: string, name: string): Promise<void> {
    await open(id, name)
    await opened.refresh()
  }

  const imports = HAS_SERVICE
    ? importPanel(openStored, stage)
    : { element: null, take: () => show([{ code: 'unsupported', path: '', message: NO_IMPORT }], '') }
  const opened = openedList(workspace, (id, name) => void open(id, name))
  const panel = h(
    'section',
    { class: `${parts.panel} ${valveStyle.drop}`, 'aria-label': 'Open a valve' },
    h('h2', {}, 'Valve'),
    names,
    about,
    h(
      'div',
      { class: parts.row },
      filePicker('Your file', 'Open a file', {
        accept: HAS_SERVICE ? ACCEPTED : '.json,application/json',
        multiple: HAS_SERVICE,
        use: (files) => void take(files),
      }),
      h(
        'span',
        { class: parts.hint },
        HAS_SERVICE
          ? 'A coapt valve file (JSON), or files to import. You can also drop files or a folder here.'
          : 'A coapt valve file (JSON). You can also drop it here.',
      ),
    ),
    !HAS_SERVICE && h('p', { class: parts.hint }, NO_IMPORT),
    imports.element,
    said,
    problems,
    opened.element,
    observedPanel(workspace, openStored),
  )
  function dropOn(whole: HTMLElement): void {
    for (const [name, over] of [
      ['dragover', true],
      ['dragleave', false],
      ['drop', false],
    ] as const)
      whole.addEventListener(name, (event) => {
        event.preventDefault()
        panel.toggleAttribute('data-over', over)
        if (event.type === 'drop' && event.dataTransfer) void droppedFiles(event.dataTransfer).then(take)
      })
  }
  return { element: panel, dropOn }
}

/// By their plain names, in groups.
function presetChoice(names: string[], choose: (name: string) => void): HTMLSelectElement {
  const element = h(
    'select',
    { onchange: () => choose(element.value) },
    h('option', { value: OWN, hidden: true }, 'none (own valve)'),
  )
  for (const group of ['Human', 'Disease', 'Porcine', 'Others'] as const) {
    const of = names.filter((name) => (presetWords(name)?.group ?? 'Others') === group)
    const options = of.map((name) => h('option', { value: name }, presetWords(name)?.title ?? name))
    if (options.length > 0) element.append(h('optgroup', { label: group }, ...options))
  }
  return element
}

/// What stands at a JSON pointer in the text of a file, shortened; empty if nothing does.
export function placeOf(text: string, pointer: string): string {
  let value: unknown
  try {
    value = JSON.parse(text)
  } catch {
    return ''
  }
  for (const part of pointer.split('/').slice(1)) {
    if (typeof value !== 'object' || value === null) return ''
    value = (value as Record<string, unknown>)[part.replaceAll('~1', '/').replaceAll('~0', '~')]
  }
  const written = value === undefined || pointer === '' ? '' : JSON.stringify(value)
  return written.length > CONTEXT ? `${written.slice(0, CONTEXT)} ...` : written
}
