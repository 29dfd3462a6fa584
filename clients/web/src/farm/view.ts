// The farm that the service hands its jobs to: runs with their progress, workers, and how many items a second they compute.
import { farm } from '../api/calls'
import { ApiError } from '../api/http'
import type { Farm } from '../api/types'
import { h } from '../dom'
import { problemList } from '../problems'
import type { View } from '../view'
import { problemsOf } from '../workspace'
import { headline, runsTable, workersTable } from './tables'
import parts from '../style/parts.module.css'

const EVERY_MS = 2000

export class FarmView implements View {
  readonly element = h('div', {})
  private timer: ReturnType<typeof setTimeout> | undefined
  private isShown = false

  show(): void {
    this.isShown = true
    void this.refresh()
  }

  hide(): void {
    this.isShown = false
    clearTimeout(this.timer)
  }

  private async refresh(): Promise<void> {
    clearTimeout(this.timer)
    try {
      this.draw(await farm())
    } catch (error) {
      if (error instanceof ApiError && error.status === 404) {
        this.draw(null)
        return
      }
      this.complain(error)
    }
    if (this.isShown) this.timer = setTimeout(() => void this.refresh(), EVERY_MS)
  }

  private complain(error: unknown): void {
    this.element.replaceChildren(h('h1', {}, 'Farm'), problemList(problemsOf(error)))
  }

  private draw(now: Farm | null): void {
    if (!now) {
      this.element.replaceChildren(h('h1', {}, 'Farm'), withoutFarm())
      return
    }
    this.element.replaceChildren(
      h('h1', {}, 'Farm'),
      h('p', { 'aria-live': 'polite', 'data-part': 'headline' }, headline(now)),
      h('section', { class: parts.panel }, h('h2', {}, 'Runs'), runsTable(now.runs)),
      h('section', { class: parts.panel }, h('h2', {}, 'Workers'), workersTable(now.workers)),
    )
  }
}

function withoutFarm(): HTMLElement {
  return h(
    'div',
    { class: parts.panel },
    h(
      'p',
      {},
      'This service computes on its own machine. Started with ',
      h('code', {}, '--farm'),
      ', it distributes studies and searches to the workers of a farm, which are shown here.',
    ),
  )
}
