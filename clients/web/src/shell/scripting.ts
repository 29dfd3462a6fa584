// window.coapt: what scripts and tests are offered. state() says what the page shows; live pulls at the valve of the Live view.
import type { Plan } from '../api/types'
import type { StoryPlace } from '../state/address'
import { readings, type ToleranceWords } from '../state/readings'
import type { Workspace } from '../workspace'
import { theme } from './theme'
import type { ViewName } from './views'

export interface PageState {
  view: ViewName
  valve: { reference: string; label: string } | null
  plan: Plan
  isAnswered: boolean // the leak is of the present plan
  leak_mm2: { before: number | null; after: number | null; error: number | null } // error: of the last of them
  problems: string[] // of the valve or the plan
  kept: string[] // names of plans
  jobs: Workspace['jobs'] // that are looked at
  story: StoryPlace | null
  tolerance: ToleranceWords | null // of the handle that is grabbed in Repair
  theme: 'light' | 'dark'
  isAway: boolean // the service does not answer
}

export function pageState(workspace: Workspace, view: ViewName): PageState {
  const { valve, plan, isAnswered, before, after, problems, kept, jobs, story } = workspace
  const last = after ?? before
  return {
    view,
    valve: valve && { ...valve },
    plan,
    isAnswered,
    leak_mm2: {
      before: before?.closure.leak_mm2 ?? null,
      after: after?.closure.leak_mm2 ?? null,
      error: last?.closure.leak.error_mm2 ?? null,
    },
    problems: problems.map(({ message }) => message),
    kept: kept.map(({ name }) => name),
    jobs: { ...jobs },
    story: story && { ...story },
    tolerance: readings.tolerance,
    theme: theme(),
    isAway: document.documentElement.hasAttribute('data-away'),
  }
}

/// Beside what is there, in place of a member of the same name.
export function offer(members: object): void {
  const page = globalThis as unknown as { coapt?: object }
  page.coapt = { ...page.coapt, ...members }
}
