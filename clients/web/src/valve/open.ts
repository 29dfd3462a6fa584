// Opening a valve: one of the presets, or a file dropped or chosen. Problems of a file are shown where they are.
import { presets, problemsOfValve, storeValve } from '../api/calls'
import type { Problem } from '../api/types'
import { field, h, select } from '../dom'
import { problemList } from '../problems'
import { problemsOf, type ValveSource, type Workspace } from '../workspace'

const CONTEXT = 60 // characters of the file around a problem

export function openPanel(workspace: Workspace): HTMLElement {
  const problems = h('div', {})
  const said = h('p', { class: 'hint', 'aria-live': 'polite' })
  const file = h('input', { type: 'file', accept: '.json,application/json', onchange: () => void take(file.files?.[0]) })
  const names = h('span', {})
  let choice: HTMLSelectElement | null = null
  let told: ValveSource | null = null // the valve that is said to be open
  presets().then(
    (list) => {
      choice = select(list.map((name) => [name, name] as const), workspace.valve?.reference ?? '', (name) => void open(name, name))
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
    if (choice) choice.value = told.reference // of a file: none
    show([], '')
    said.textContent = `${told.label} is open.`
  }

  async function open(reference: string, label: string): Promise<void> {
    said.textContent = `closing ${label} ...`
    try {
      await workspace.open({ reference, label })
    } catch (error) {
      show(problemsOf(error), '')
    }
  }

  async function take(chosen: File | undefined): Promise<void> {
    if (!chosen) return
    const text = await chosen.text()
    file.value = '' // the same file, corrected, is another choice
    said.textContent = `reading ${chosen.name} ...`
    try {
      const found = await problemsOfValve(text)
      if (found.length > 0) return show(found, text)
      await open(await storeValve(text), chosen.name)
    } catch (error) {
      show(problemsOf(error), text)
    }
  }

  function show(found: Problem[], text: string): void {
    const list = problemList(found)
    problems.replaceChildren(list)
    if (found.length === 0) return
    said.textContent = found.length === 1 ? 'This cannot be opened: one problem.' : `This cannot be opened: ${found.length} problems.`
    ;[...list.children].forEach((item, i) => {
      const place = placeOf(text, found[i]?.path ?? '')
      if (place !== '') item.append(h('pre', {}, place))
    })
  }

  const panel = h(
    'section',
    { class: 'panel drop', 'aria-label': 'Open a valve' },
    h('h2', {}, 'Valve'),
    names,
    field('Your file', file),
    h('p', { class: 'hint' }, 'coapt.valve/1, for instance of `coapt valve import`.'),
    said,
    problems,
  )
  for (const [name, over] of [['dragover', true], ['dragleave', false], ['drop', false]] as const)
    panel.addEventListener(name, (event) => {
      event.preventDefault()
      panel.classList.toggle('over', over)
      if (event.type === 'drop') void take(event.dataTransfer?.files[0])
    })
  return panel
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
