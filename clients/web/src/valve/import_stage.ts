// Where the valve stands else: files that are to be imported, the job that does so, what has come of it. It belongs to the
// valve that is open, and is gone when another one is opened, by whomever.
import { getBlob } from '../api/http'
import type { FitResult, ImportDecision, ImportResult, Job } from '../api/types'
import { button, h } from '../dom'
import { counted, withUnit } from '../format'
import { filesOf } from '../jobs/calls'
import { InputViewer } from '../viewer/input_viewer'
import type { ViewName } from '../viewer/stage'
import type { Workspace } from '../workspace'
import { type DecisionControl, takeControl } from './corrections'
import parts from '../style/parts.module.css'
import valveStyle from './valve.module.css'

export interface ImportStage {
  element: HTMLElement
  files(): InputViewer // shown
  show(...content: (Node | string)[]): void // a job, a result
  hide(): void
  view(name: ViewName): boolean // of the files; false if they are not shown
}

/// `changed` is told whether it is shown.
export function importStage(workspace: Workspace, changed: (isShown: boolean) => void): ImportStage {
  let shownFor: string | undefined // the valve that was open
  let viewer: InputViewer | null = null // made when there is something to show: each has a canvas of its own
  const body = h('div', { class: valveStyle.importBody })
  const bar = h(
    'div',
    { class: parts.row },
    h('h2', {}, 'Import'),
    button('Show the valve', () => hide(), { class: valveStyle.back }),
  )
  const element = h(
    'section',
    { class: valveStyle.importStage, 'data-part': 'import-stage', 'aria-label': 'Import', hidden: true },
    bar,
    body,
  )

  function reveal(isPicture: boolean): void {
    body.toggleAttribute('data-picture', isPicture)
    element.hidden = false
    shownFor = workspace.valve?.reference
    changed(true)
  }

  function hide(): void {
    if (element.hidden) return
    element.hidden = true
    changed(false)
  }
  workspace.subscribe(() => workspace.valve?.reference !== shownFor && hide())

  return {
    element,
    files() {
      viewer ??= new InputViewer()
      if (!viewer.element.isConnected || element.hidden) {
        body.replaceChildren(viewer.element)
        reveal(true)
      }
      return viewer
    },
    show(...content) {
      body.replaceChildren(...content)
      reveal(false)
      body.scrollTop = 0
      element.scrollIntoView({ block: 'start' })
    },
    hide,
    view(name) {
      const isShown = viewer?.element.isConnected === true && !element.hidden
      if (isShown) viewer?.view(name)
      return isShown
    },
  }
}

/// What an import has made: its picture and everything it decided.
export function importResult(
  job: Job,
  result: ImportResult,
  actions: HTMLElement,
  controls: DecisionControl[],
): HTMLElement {
  const picture = h('img', {
    class: valveStyle.importPicture,
    alt: `${result.name}: the input and the resulting valve, seen from the atrium and from posterior, and a section`,
  })
  const doubts = result.decisions.filter(({ look }) => look)
  const left = [...controls]
  const residual = h('img', { class: valveStyle.importPicture, alt: 'Remaining distances after the fit', hidden: true })
  void fill(picture, job.links.picture ?? '')
  if (result.fit)
    void filesOf(job.id).then((files) => {
      const map = files.find(({ name }) => name === 'fit.png')
      if (map) void fill(residual, map.path)
    })
  return h(
    'div',
    { 'data-part': 'import-result' },
    h(
      'p',
      {},
      h('strong', {}, result.name),
      ` is open: ${counted(result.triangles, 'triangle')}, ${counted(result.chordae, 'chorda', 'chordae')}. Compare it with the input, and review the decisions.`,
    ),
    actions,
    result.fit && fitted(result.fit),
    doubts.length > 0 && h('h3', {}, 'To check against the images'),
    doubts.length > 0 && decisionList(doubts, left),
    picture,
    residual,
    h('h3', {}, 'Decisions'),
    decisionList(
      result.decisions.filter(({ look }) => !look),
      left,
    ),
  )
}

async function fill(picture: HTMLImageElement, path: string): Promise<void> {
  picture.src = URL.createObjectURL(await getBlob(path)) // by a request that has the token
  picture.hidden = false
}

function fitted(fit: FitResult): HTMLElement {
  const { leak_mm2: leak, parameters } = fit
  const known = parameters.filter(({ identifiable }) => identifiable).length
  const figures: [string, string][] = [
    ['distance, rms', `${withUnit(fit.rms_before_mm, 'mm', 2)} before, ${withUnit(fit.rms_mm, 'mm', 2)} after`],
    [
      'leak',
      `${withUnit(leak.before, 'mm²')} before, ${withUnit(leak.fitted, 'mm²')} ± ${withUnit(leak.sd, 'mm²')} after`,
    ],
    ['constrained by the surface', `${known} of ${parameters.length} parameters`],
  ]
  return h(
    'section',
    { 'data-part': 'fit', 'aria-label': 'Fit' },
    h(
      'dl',
      { class: parts.figures },
      ...figures.map(([name, value]) => h('div', {}, h('dt', {}, name), h('dd', {}, value))),
    ),
    !fit.finished && h('p', { class: parts.warn }, 'The fit was stopped before convergence.'),
  )
}

/// A control stands at the first decision that it can change, and is taken out of those that are left.
function decisionList(decisions: ImportDecision[], left: DecisionControl[]): HTMLElement {
  const list = h('dl', { class: valveStyle.decisions, 'data-part': 'decisions' })
  for (const { subject, value, reason, look } of decisions) {
    const control = takeControl({ subject, value }, left)
    list.append(
      h('dt', {}, subject, ' ', look && h('span', { class: `${parts.badge} ${parts.warn}` }, 'check')),
      h(
        'dd',
        { 'data-subject': subject },
        value,
        reason && h('span', { class: parts.hint }, ` ${reason}`),
        control?.element,
      ),
    )
  }
  return list
}
