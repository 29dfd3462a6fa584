// The page: a bar of views over one workspace. The chosen view is the address's part after '#'.
import './style/base.css'
import './style/parts.css'
import { onTokenNeeded } from './api/http'
import { h } from './dom'
import { askForToken } from './shell/token'
import { footer } from './shell/footer'
import { header, VIEWS, type ViewName } from './shell/header'
import type { View } from './view'
import { Workspace, problemsOf } from './workspace'

const FIRST_VALVE = 'human-functional-mr'

const makers: Record<ViewName, (workspace: Workspace) => Promise<View>> = {
  valve: async (workspace) => new (await import('./valve/view')).ValveView(workspace),
  repair: async (workspace) => new (await import('./repair/view')).RepairView(workspace),
  search: async (workspace) => new (await import('./search/view')).SearchView(workspace),
  studies: async (workspace) => new (await import('./studies/view')).StudiesView(workspace),
}

const app = document.getElementById('app') as HTMLElement
const workspace = new Workspace()
const views = new Map<ViewName, Promise<View>>()
const main = h('main', { id: 'main', tabindex: -1 })
let shown: View | null = null

function asked(): ViewName {
  const name = location.hash.slice(1)
  return VIEWS.find(([view]) => view === name)?.[0] ?? 'valve'
}

async function show(): Promise<void> {
  const name = asked()
  let making = views.get(name)
  if (!making) views.set(name, (making = makers[name](workspace)))
  const view = await making.catch((error: unknown) => {
    views.delete(name)
    return said(error)
  })
  if (name !== asked() || view === shown) return
  shown?.hide()
  main.replaceChildren(view.element)
  shown = view
  view.show()
  bar.mark(name)
  document.title = `coapt: ${VIEWS.find(([view]) => view === name)?.[1] ?? ''}`
}

/// In the place of a view that cannot be shown: its file did not come, or the browser draws nothing in three dimensions.
function said(error: unknown): View {
  const words = error instanceof Error ? error.message : String(error)
  const element = h('p', { class: 'bad', role: 'alert' }, `This view cannot be shown: ${words}`)
  return { element, show: () => {}, hide: () => {} }
}

const bar = header(workspace)
app.append(h('a', { href: '#main', class: 'skip', onclick: skip }, 'Skip to the content'), bar.element, main, footer())
onTokenNeeded(askForToken)
addEventListener('hashchange', () => void show())

function skip(event: Event): void {
  event.preventDefault()
  main.focus()
}

const opened = workspace.open({ reference: FIRST_VALVE, label: FIRST_VALVE })
opened.catch((error: unknown) => {
  workspace.problems = problemsOf(error)
  bar.complain(workspace.problems[0]?.message ?? '')
})
await show()
