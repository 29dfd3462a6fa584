// Valves that were opened from files: opened again, renamed, removed.
import { button, h } from '../dom'
import { iconButton } from '../icons'
import { problemList } from '../problems'
import { nameValve, openedValves, removeValve, type OpenedValve } from '../state/valves'
import { onOtherTab } from '../state/tabs'
import { problemsOf, type Workspace } from '../workspace'
import parts from '../style/parts.module.css'
import valveStyle from './valve.module.css'
import { counted } from '../format'

export interface OpenedList {
  element: HTMLElement
  refresh(): Promise<void>
}

export function openedList(workspace: Workspace, open: (id: string, name: string) => void): OpenedList {
  const list = h('ul', { class: valveStyle.opened, 'data-part': 'opened' })
  const told = h('div', {})
  const element = h('details', { class: parts.more, hidden: true }, h('summary', {}, 'Opened before'), list, told)

  async function refresh(): Promise<void> {
    await attempt(async () => {
      const valves = await openedValves()
      element.hidden = valves.length === 0
      list.replaceChildren(...valves.map(entry))
    })
  }

  function entry({ id, name, triangles }: OpenedValve): HTMLElement {
    const input = h('input', {
      type: 'text',
      class: parts.name,
      value: name,
      title: 'Change the name',
      'aria-label': `Name of ${name}`,
      onchange: () => {
        nameValve(id, input.value.trim() || name)
        if (workspace.valve?.reference === id) workspace.relabel(input.value.trim() || name)
        void refresh()
      },
    })
    return h(
      'li',
      { title: triangles === null ? null : counted(triangles, 'triangle') },
      input,
      button('Open', () => open(id, name), { 'aria-label': `Open ${name}` }),
      iconButton('remove', `Remove ${name}`, () => void attempt(() => removeValve(id).then(refresh))),
    )
  }

  async function attempt(does: () => Promise<void>): Promise<void> {
    try {
      await does()
      told.replaceChildren()
    } catch (error) {
      told.replaceChildren(problemList(problemsOf(error)))
    }
  }

  onOtherTab('valves', () => void refresh())
  void refresh()
  return { element, refresh }
}
