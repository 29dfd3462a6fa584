// The address and the page's state follow each other: a reload, a link, back and forth show what was there.
import { ApiError } from '../api/http'
import type { Step } from '../api/types'
import type { ViewName } from '../shell/views'
import type { Workspace } from '../workspace'
import { readAddress, writeAddress, type Address } from './address'
import { nameOfValve } from './valves'

const FIRST_VALVE = 'human-functional-mr'

export interface Router {
  start(): Promise<void>
  apply(): Promise<void> // the address as it is
  addressOf(view: ViewName): string // with the present valve, plan and job
}

export interface Routed {
  show(view: ViewName): Promise<void>
  fail(words: string[]): void // the address, or a part of it, names nothing; empty: all of it does
  failed(error: unknown): void // the valve cannot be opened
}

export function router(workspace: Workspace, page: Routed): Router {
  let view: ViewName = 'valve'
  let applying = 0 // addresses at once
  let seen = '' // the address last read or written: while it is another one, that one is on its way to be read
  let left: string | null = null // what was shown when the address named nothing: until it changes, the address stays

  function present(of: ViewName): Omit<Address, 'faults'> {
    const job = of === 'search' ? workspace.jobs.plans : of === 'studies' ? workspace.jobs.study : null
    return {
      view: of,
      valve: workspace.valve?.reference ?? null,
      steps: workspace.plan.steps,
      job,
      story: workspace.story,
    }
  }

  /// Another valve, view or job is a new entry of the history; a changed plan takes the place of the one before.
  function write(): void {
    if (applying > 0 || !workspace.valve || workspace.isDragging || location.hash !== seen) return
    const before = readAddress(seen)
    const now = present(view)
    const address = writeAddress(now)
    if (address === seen || address === left) return
    left = null
    const isNew = before.valve !== null && (before.valve !== now.valve || before.view !== now.view)
    const isOtherJob = before.job !== null && before.job !== now.job
    page.fail([])
    history[isNew || isOtherJob ? 'pushState' : 'replaceState'](null, '', address)
    seen = location.hash
  }

  async function apply(): Promise<void> {
    seen = location.hash
    const asked = readAddress(seen)
    ++applying
    page.fail(asked.faults)
    if (asked.view) view = asked.view
    if (asked.story || asked.valve !== null) workspace.tell(asked.story) // an address of a view alone leaves a story as it is
    if (asked.job !== null) workspace.lookAt(view === 'studies' ? 'study' : 'plans', asked.job)
    const showing = page.show(view)
    await openAsked(asked.valve ?? workspace.valve?.reference ?? FIRST_VALVE, asked)
    await showing
    --applying
    left = asked.faults.length === 0 ? null : writeAddress(present(view))
    write()
  }

  async function openAsked(reference: string, asked: Address): Promise<void> {
    try {
      const isOther = workspace.valve?.reference !== reference
      if (isOther) await workspace.open({ reference, label: nameOfValve(reference) })
      if (asked.steps || asked.valve) takeSteps(asked.steps ?? [])
    } catch (error) {
      page.failed(error)
      if (asked.valve === null || !(error instanceof ApiError)) return
      asked.faults.push(`There is no valve “${asked.valve}” here.`)
      page.fail(asked.faults)
    }
  }

  function takeSteps(steps: Step[]): void {
    if (JSON.stringify(steps) !== JSON.stringify(workspace.plan.steps)) void workspace.setPlan(steps)
  }

  return {
    async start() {
      addEventListener('hashchange', () => void apply())
      await apply()
      workspace.subscribe(write)
    },
    apply,
    addressOf: (of) => writeAddress(present(of)),
  }
}
