// Searches for repair plans of the open valve.
import type { Job } from '../api/types'
import { h } from '../dom'
import { withUnit } from '../format'
import { HAS_SERVICE } from '../mode'
import { JobView, type JobKind } from '../jobs/job_view'
import { describe } from '../repair/steps'
import type { View } from '../view'
import type { Workspace } from '../workspace'
import { headline } from '../valve/headline'
import { TissueError } from '../valve/tissue_error'
import { searchForm } from './form'
import { searchPanel } from './job_panel'
import { inShort } from './in_short'
import { Photos } from './photos'
import parts from '../style/parts.module.css'
import searchStyle from './search.module.css'

export class SearchView implements View {
  readonly element: HTMLElement
  private readonly jobs: JobView
  private readonly valve = h('div', {})
  private readonly headline = h('div', {})
  private readonly tissue = new TissueError(() => this.tell())
  private shown: string | null = null // the valve that is pictured
  private picture = new AbortController()

  constructor(private readonly workspace: Workspace) {
    const searches: JobKind = {
      kind: 'plans',
      path: '/v1/plans',
      member: 'search',
      earlier: 'Earlier searches',
      another: 'New search and earlier ones',
      form: searchForm,
      note: inShort,
      outcome: bestSoFar,
      empty: empty(this.valve),
      panel(job, changed, signal) {
        return searchPanel(job, { workspace, signal, changed })
      },
    }
    this.jobs = new JobView(workspace, searches)
    this.element = this.jobs.element
    workspace.subscribe(() => this.tell())
  }

  show(): void {
    this.tell()
    void this.jobs.show()
  }
  hide(): void {}

  /// The valve of which repairs are searched for, while nothing else is shown.
  private tell(): void {
    const { valve, before } = this.workspace
    if (!valve || !before || !this.valve.isConnected) return
    this.headline.replaceChildren(headline(before, null, this.tissue.of(before, valve.reference, null)))
    if (valve.reference === this.shown) return
    this.shown = valve.reference
    this.picture.abort()
    this.picture = new AbortController()
    const photo = new Photos(valve.reference, this.picture.signal).photo(null, `${valve.label} from the atrium`)
    this.valve.replaceChildren(this.headline, photo)
  }
}

function bestSoFar({ progress: { best } }: Job): string | null {
  if (!best) return null
  const steps = best.plan.steps.map(describe).join('; ') || 'No repair'
  return `${steps}: leak ${withUnit(best.leak_mm2, 'mm²')}`
}

function empty(valve: HTMLElement): HTMLElement {
  return h(
    'div',
    {},
    h('h1', {}, 'Search'),
    h(
      'div',
      { class: parts.panel },
      h(
        'p',
        {},
        'coapt tries rings, papillary sutures and neochordae on this valve and ranks the best plans by how well they ' +
          'close it, including with small errors of execution.',
      ),
      h(
        'p',
        {},
        HAS_SERVICE
          ? 'With the defaults a search takes about a minute on two cores. It continues while you work elsewhere, even ' +
              'when this page is closed.'
          : 'The search runs in this browser and takes some minutes with the defaults. It continues while you work elsewhere ' +
              'in this page, and ends when the page is closed.',
      ),
      h('div', { class: searchStyle.asked }, valve),
    ),
  )
}
