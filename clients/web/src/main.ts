// The page: a bar of views over one workspace. The address says which view, valve, plan and job is shown.
import './style/base.css'
import { version } from './api/calls'
import { onTokenNeeded, takeTokenFromAddress } from './api/http'
import { h } from './dom'
import { hasEngine } from './engine/thread'
import { HAS_SERVICE } from './mode'
import { askForToken } from './shell/token'
import { footer } from './shell/footer'
import { header } from './shell/header'
import { needsService } from './shell/needs_service'
import { notices } from './shell/notices'
import { commandPalette } from './shell/palette'
import { followSystem } from './shell/theme'
import { offer, pageState } from './shell/scripting'
import { shortcuts } from './shell/shortcuts'
import { type ViewName, viewTitle } from './shell/views'
import { router } from './state/router'
import { onOtherTab } from './state/tabs'
import { firstVisit } from './story/offer'
import type { View } from './view'
import { Workspace, problemsOf } from './workspace'
import parts from './style/parts.module.css'
import shellStyle from './shell/shell.module.css'

const makers: Record<ViewName, (workspace: Workspace) => Promise<View>> = {
  valve: async (workspace) => new (await import('./valve/view')).ValveView(workspace),
  repair: async (workspace) => new (await import('./repair/view')).RepairView(workspace),
  live: async (workspace) => new (await import('./live/view')).LiveView(workspace),
  search: async (workspace) => new (await import('./search/view')).SearchView(workspace),
  studies: HAS_SERVICE
    ? async (workspace) => new (await import('./studies/view')).StudiesView(workspace)
    : async () => needsService('Studies', 'Studies of a valve require coapt-server.'),
  farm: HAS_SERVICE
    ? async () => new (await import('./farm/view')).FarmView()
    : async () => needsService('Farm', 'A farm requires coapt-server.'),
  cohort: async () => new (await import('./cohort/view')).CohortView(),
  train: async (workspace) => new (await import('./train/view')).TrainView(workspace),
}

takeTokenFromAddress()
followSystem()
const app = document.getElementById('app') as HTMLElement
const workspace = new Workspace()
const views = new Map<ViewName, Promise<View>>()
const main = h('main', { id: 'main', tabindex: -1 })
let shown: View | null = null
let asked: ViewName = 'valve'
let strip: { element: HTMLElement; follow(): void } | null = null // once a story is told

async function show(name: ViewName): Promise<void> {
  asked = name
  const making = views.get(name) ?? makers[name](workspace)
  views.set(name, making)
  const view = await making.catch((error: unknown) => {
    views.delete(name)
    return said(error)
  })
  if (name !== asked) return
  if (view !== shown) {
    shown?.hide()
    main.replaceChildren(view.element)
    shown = view
  }
  view.show()
  bar.mark(name)
  bar.lead(route.addressOf)
  document.title = `coapt: ${viewTitle(name)}`
  strip?.follow()
}

/// In the place of a view that cannot be shown: its file did not come, or the browser draws nothing in three dimensions.
function said(error: unknown): View {
  const isLost = error instanceof TypeError
  const words = isLost ? 'the service does not respond' : error instanceof Error ? error.message : String(error)
  const element = h('p', { class: parts.bad, role: 'alert' }, `This view cannot be shown: ${words}.`)
  return { element, show: () => {}, hide: () => {} }
}

/// A story is loaded when the first one is told.
async function tellStory(): Promise<void> {
  if (!workspace.story || aboveViews.dataset.asked) return
  aboveViews.dataset.asked = 'true'
  const { storyStrip } = await import('./story/strip')
  strip = storyStrip(workspace, () => ({ name: asked, view: shown }))
  aboveViews.append(strip.element)
  strip.follow()
}

function skip(event: Event): void {
  event.preventDefault()
  main.focus()
}

const aboveViews = h(
  'div',
  {},
  location.hash.length < 2 || /^#\/?valve$/.test(location.hash) ? firstVisit(workspace) : null,
)
const palette = commandPalette(workspace, () => shown)
const bar = header(workspace, palette.open)
const above = notices(() => void again())
const route = router(workspace, {
  show,
  fail: above.fault,
  failed(error) {
    workspace.problems = problemsOf(error)
    bar.complain(workspace.problems[0]?.message ?? '')
  },
})

/// What could not be shown while the service was away.
async function again(): Promise<void> {
  await workspace.loadKept().catch(() => {})
  if (!workspace.valve || !views.has(asked)) await route.apply()
  else await workspace.closeAgain()
}

app.append(
  h('a', { href: '#main', class: shellStyle.skip, onclick: skip }, 'Skip to content'),
  bar.element,
  above.element,
  aboveViews,
  main,
  footer(),
)
onTokenNeeded(askForToken)
offer({ state: () => pageState(workspace, asked) })
shortcuts(workspace, palette.open)
workspace.subscribe(() => bar.lead(route.addressOf))
workspace.subscribe(() => void tellStory())
onOtherTab('kept plans', () => void workspace.loadKept())
workspace.loadKept().catch(() => {})
if (HAS_SERVICE) {
  version().then(
    ({ farm }) => bar.offer('farm', farm),
    () => {},
  )
  void hasEngine().then((is) => {
    bar.offer('live', is)
    bar.offer('train', is)
  })
} else navigator.serviceWorker?.register('sw.js').catch(() => {}) // the page works without it, on-line
await route.start()
