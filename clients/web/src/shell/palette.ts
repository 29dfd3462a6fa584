// Ctrl+K: every view, valve, ring, step, kept plan, story, setting, word and document by its name.
import { presets, rings } from '../api/calls'
import type { Step } from '../api/types'
import { h } from '../dom'
import { words } from '../format'
import { GLOSSARY } from '../help/glossary'
import { explain } from '../help/term'
import { HAS_SERVICE } from '../mode'
import { describe, FIRST_STEPS, withStep } from '../repair/steps'
import { openedValves } from '../state/valves'
import { addressOf } from '../story/address'
import { STORIES } from '../story/shipped'
import { presetTitle } from '../valve/presets'
import type { Command, View } from '../view'
import type { Workspace } from '../workspace'
import shellStyle from './shell.module.css'
import { switchTheme } from './theme'
import { VIEWS, withheld } from './views'

export interface Palette {
  open(): void
}

/// `shown`: the view in the page.
export function commandPalette(workspace: Workspace, shown: () => View | null): Palette {
  let commands: Command[] = []
  let found: Command[] = []
  let at = 0
  const list = h('ul', { role: 'listbox', id: 'palette-list', 'aria-label': 'Commands', class: shellStyle.commands })
  const input = h('input', {
    type: 'search',
    role: 'combobox',
    'aria-label': 'Find a command',
    'aria-controls': 'palette-list',
    'aria-expanded': 'true',
    autocomplete: 'off',
    placeholder: 'View, valve, ring, plan, setting, word ...',
    oninput: () => relist(0),
    onkeydown: (event: KeyboardEvent) => step(event),
  })
  const dialog = h('dialog', { class: shellStyle.palette, 'aria-label': 'Commands' }, input, list)
  dialog.addEventListener('click', (event) => event.target === dialog && dialog.close())

  function relist(marked: number): void {
    found = matching(commands, input.value)
    at = Math.max(0, Math.min(marked, found.length - 1))
    list.replaceChildren(
      ...found.map((command, i) =>
        h(
          'li',
          { role: 'option', id: `command-${i}`, 'aria-selected': String(i === at), onclick: () => run(command) },
          h('span', { class: shellStyle.group }, command.group),
          command.name,
        ),
      ),
    )
    if (found.length === 0) list.append(h('li', { role: 'option', 'aria-disabled': 'true' }, 'Nothing found.'))
    input.setAttribute('aria-activedescendant', found.length > 0 ? `command-${at}` : '')
    list.children[at]?.scrollIntoView({ block: 'nearest' })
  }

  function step(event: KeyboardEvent): void {
    const way = event.key === 'ArrowDown' ? 1 : event.key === 'ArrowUp' ? -1 : 0
    if (way !== 0) relist(at + way)
    else if (event.key === 'Enter') run(found[at])
    else return
    event.preventDefault()
  }

  function run(command: Command | undefined): void {
    dialog.close()
    command?.run()
  }

  return {
    open() {
      if (dialog.open) return
      if (!dialog.isConnected) document.body.append(dialog)
      commands = [
        ...views(),
        ...actions(workspace),
        ...steps(workspace),
        ...plans(workspace),
        ...stories(),
        ...(shown()?.settings?.() ?? []),
        ...documents(),
      ]
      input.value = ''
      relist(0)
      dialog.showModal()
      void Promise.all([valves(workspace), ringSizes(workspace)]).then(([valves, rings]) => {
        commands = [...commands, ...rings, ...valves]
        relist(at)
      })
    },
  }
}

/// Those that have all words of `asked` in them.
export function matching(commands: Command[], asked: string): Command[] {
  const words = asked.toLowerCase().split(/\s+/)
  return commands.filter(({ group, name }) => words.every((word) => `${group} ${name}`.toLowerCase().includes(word)))
}

function views(): Command[] {
  return VIEWS.filter(([view]) => !withheld.has(view)).map(([view, name]) => ({
    group: 'View',
    name,
    run: () => (location.hash = `#/${view}`),
  }))
}

function actions(workspace: Workspace): Command[] {
  return [
    { group: 'Action', name: 'Undo', run: () => void workspace.undo() },
    { group: 'Action', name: 'Redo', run: () => void workspace.redo() },
    { group: 'Action', name: 'Clear the plan', run: () => void workspace.setPlan([]) },
    { group: 'Action', name: 'Light or dark', run: switchTheme },
  ]
}

function steps(workspace: Workspace): Command[] {
  return Object.entries(FIRST_STEPS).map(([name, step]) => ({
    group: 'Add a step',
    name,
    run: adding(workspace, step),
  }))
}

function adding(workspace: Workspace, step: Step): () => void {
  return () => void workspace.setPlan(withStep(workspace.plan.steps, step)).then(() => (location.hash = '#/repair'))
}

/// Each ring that there is, as the plan's own.
async function ringSizes(workspace: Workspace): Promise<Command[]> {
  const { rings: shapes, sizes_mm } = await rings().catch(() => ({ rings: [], sizes_mm: { min: 1, max: 0, step: 1 } }))
  const sizes = Array.from({ length: 1 + Math.floor((sizes_mm.max - sizes_mm.min) / sizes_mm.step) }, (_, i) => i)
  const ring = (step: Step): Command => ({ group: 'Ring', name: describe(step), run: adding(workspace, step) })
  return [
    ...[0, 1, 2, 3, 4, 5, 6].map((sizes_below) => ring({ step: 'annuloplasty', shape: 'own', sizes_below })),
    ...shapes.flatMap(({ name: shape }) =>
      sizes.map((i) => ring({ step: 'annuloplasty', shape, size_mm: sizes_mm.min + i * sizes_mm.step })),
    ),
  ]
}

function stories(): Command[] {
  return STORIES.map((story) => ({
    group: 'Story',
    name: story.title,
    run: () => (location.hash = addressOf(story, story.name, 0)),
  }))
}

/// What is written beside the page, and what its words mean.
function documents(): Command[] {
  const limits = (): void => {
    const details = document.querySelector<HTMLDetailsElement>('footer details')
    if (details) details.open = true
    details?.querySelector('summary')?.focus()
  }
  const said = Object.entries(GLOSSARY).map(([name, text]) => ({
    group: 'Word',
    name: words(name),
    run: () => explain(document.querySelector('header') ?? document.body, text),
  }))
  return [
    { group: 'Document', name: 'Model limitations', run: limits },
    ...(HAS_SERVICE
      ? [
          {
            group: 'Document',
            name: 'Interface of the service (OpenAPI)',
            run: () => void window.open('/openapi.json'),
          },
        ]
      : []),
    ...said,
  ]
}

function plans(workspace: Workspace): Command[] {
  return workspace.kept.map((kept) => ({
    group: 'Kept plan',
    name: kept.name,
    run: () => void workspace.revise(kept).then(() => (location.hash = '#/repair')),
  }))
}

async function valves(workspace: Workspace): Promise<Command[]> {
  const open = (reference: string, label: string) => () => void workspace.open({ reference, label }).catch(() => {})
  const [names, opened] = await Promise.all([presets().catch(() => []), openedValves().catch(() => [])])
  return [
    ...names.map((name) => ({ group: 'Preset', name: `${presetTitle(name)} (${name})`, run: open(name, name) })),
    ...opened.map(({ id, name }) => ({ group: 'Valve', name, run: open(id, name) })),
  ]
}
