// Many valves in one table: why each leaks and how much, and where it was searched the first plan, whether it holds, for how long.
import { close, presets, problemsOfValve, storeValve } from '../api/calls'
import { getJson, postJson } from '../api/http'
import type { Job, RankedPlan } from '../api/types'
import { button, field, filePicker, h } from '../dom'
import { hasEnded, jobsOf } from '../jobs/calls'
import { rememberValve, valveOf } from '../jobs/valves'
import { HAS_SERVICE } from '../mode'
import { problemList } from '../problems'
import { writeAddress } from '../state/address'
import { nameValve, openedValves } from '../state/valves'
import { presetTitle } from '../valve/presets'
import type { View } from '../view'
import { problemsOf } from '../workspace'
import { arranged, COLUMNS, type Column, newRow, type Row } from './rows'
import { droppedFiles } from '../dropped'
import type { SideBySide } from '../viewer/side_by_side'
import parts from '../style/parts.module.css'
import cohortStyle from './cohort.module.css'
import { counted } from '../format'

const AT_ONCE = HAS_SERVICE ? 2 : 1 // closures
const EVERY_MS = 3000 // while searches run
const MOST_FILES = 500

export class CohortView implements View {
  readonly element: HTMLElement
  private rows: Row[] = []
  private by: Column = COLUMNS[0] as Column
  private isDown = false
  private isShown = false
  private isListed = false
  private timer: ReturnType<typeof setTimeout> | undefined
  private readonly body = h('tbody', {})
  private readonly heads = new Map<Column, HTMLElement>()
  private readonly filter = h('input', { type: 'search', oninput: () => this.draw() })
  private readonly said = h('p', { class: parts.hint, role: 'status', 'data-part': 'cohort-state' })
  private readonly told = h('div', {})
  private readonly compared = h('div', {})
  private pair: SideBySide | null = null
  private ticked: Row[] = [] // to be compared, two at most
  private readonly search = button('Search for plans', () => void this.searchAll(), { class: parts.primary })

  constructor() {
    const columns = COLUMNS.filter(({ ofPlans }) => HAS_SERVICE || !ofPlans)
    this.element = h(
      'div',
      { class: cohortStyle.cohort },
      h('h1', {}, 'Cohort'),
      h(
        'div',
        { class: `${parts.row} ${cohortStyle.tools}` },
        field('Filter', this.filter),
        filePicker('Files of valves', 'Add files', {
          accept: '.json,application/json',
          multiple: true,
          use: (files) => void this.add(files),
        }),
        h(
          'span',
          { class: parts.hint },
          'Drop a folder of coapt valve files (JSON) here, such as the members of a population.',
        ),
        HAS_SERVICE && this.search,
      ),
      this.said,
      this.told,
      this.compared,
      h(
        'div',
        { class: parts.scroll, role: 'group', 'aria-label': 'Valves', tabindex: 0 },
        h(
          'table',
          { 'data-part': 'cohort' },
          h('caption', { class: parts.unseen }, 'Valves, each with its diagnosis and its first plan'),
          h('thead', {}, h('tr', {}, ...columns.map((column) => this.head(column)))),
          this.body,
        ),
      ),
    )
    for (const name of ['dragover', 'drop'] as const)
      this.element.addEventListener(name, (event) => {
        event.preventDefault()
        if (name === 'drop' && event.dataTransfer)
          void droppedFiles(event.dataTransfer).then((files) => this.add(files))
      })
  }

  show(): void {
    this.isShown = true
    void this.list()
  }
  hide(): void {
    this.isShown = false
    clearTimeout(this.timer)
  }

  private head(column: Column): HTMLElement {
    const { title, numeric } = column
    const head = h(
      'th',
      { scope: 'col', class: numeric ? parts.number : undefined, 'aria-sort': 'none' },
      button(title, () => this.sort(column), { class: `${parts.quiet} ${cohortStyle.sort}` }),
    )
    this.heads.set(column, head)
    return head
  }

  private sort(column: Column): void {
    this.isDown = this.by === column ? !this.isDown : column.numeric === true // the largest first
    this.by = column
    this.draw()
  }

  /// Presets and the valves that were opened before, once; what searches have found, each time.
  private async list(): Promise<void> {
    try {
      if (!this.isListed) {
        this.isListed = true
        const [names, opened] = await Promise.all([presets(), openedValves()])
        const rows = [
          ...opened.map(({ id, name }) => newRow(id, name)),
          ...names.map((name) => newRow(name, presetTitle(name))),
        ]
        this.rows = [...this.rows, ...rows.filter(({ reference }) => !this.rowOf(reference))]
        this.draw()
        void this.closeAll()
      }
      if (HAS_SERVICE) await this.takePlans()
    } catch (error) {
      this.told.replaceChildren(problemList(problemsOf(error)))
    }
  }

  private rowOf(reference: string): Row | undefined {
    return this.rows.find((row) => row.reference === reference)
  }

  /// Files that hold no valve are named; the others are taken.
  private async add(files: File[]): Promise<void> {
    const given = files.filter(({ name }) => name.toLowerCase().endsWith('.json'))
    const refused: string[] = []
    if (given.length === 0) refused.push('None of these files is a JSON file.')
    if (given.length > MOST_FILES) refused.push(`Only the first ${MOST_FILES} of ${given.length} files were loaded.`)
    for (const [i, file] of given.slice(0, MOST_FILES).entries()) {
      this.said.textContent = `reading ${file.name}, ${i + 1} of ${Math.min(given.length, MOST_FILES)} ...`
      try {
        const text = await file.text()
        const [first] = await problemsOfValve(text)
        if (first) {
          refused.push(`${file.name} is not a valve file: ${first.path} ${first.message}.`)
          continue
        }
        const id = await storeValve(text)
        const name = file.name.replace(/\.json$/i, '')
        nameValve(id, name)
        if (!this.rowOf(id)) this.rows = [newRow(id, name), ...this.rows]
      } catch (error) {
        refused.push(`${file.name}: ${problemsOf(error)[0]?.message ?? ''}`)
      }
    }
    this.told.replaceChildren(problemList(refused.map((message) => ({ code: 'no_valve', path: '', message }))))
    this.draw()
    await this.closeAll()
  }

  private async closeAll(): Promise<void> {
    const left = this.rows.filter(({ closure, problem }) => !closure && !problem)
    const work = async (): Promise<void> => {
      for (let row = left.shift(); row; row = left.shift()) {
        try {
          row.closure = await close(row.reference, null)
        } catch (error) {
          row.problem = problemsOf(error)[0]?.message ?? 'not closed'
        }
        this.draw()
      }
    }
    await Promise.all(Array.from({ length: AT_ONCE }, work))
  }

  /// The first plan of the newest search of each valve; asked for again while a search runs.
  private async takePlans(): Promise<void> {
    clearTimeout(this.timer)
    const jobs = await jobsOf('plans')
    const seen = new Set<Row>()
    for (const job of jobs) {
      const row = this.rowOf((await valveOf(job)).reference)
      if (!row || seen.has(row)) continue
      row.isSearched = !hasEnded(job.state)
      if (job.state !== 'SUCCEEDED') continue
      seen.add(row)
      const { plans } = await getJson<{ plans: RankedPlan[] }>(`/v1/jobs/${job.id}/plans?page_size=1`)
      row.plan = plans[0] ?? null
    }
    this.draw()
    const isRunning = this.rows.some(({ isSearched }) => isSearched)
    if (isRunning && this.isShown) this.timer = setTimeout(() => void this.list(), EVERY_MS)
  }

  /// Of the valves that are shown and leak; the service does one after the other.
  private async searchAll(): Promise<void> {
    this.search.disabled = true
    try {
      for (const row of this.toSearch()) {
        const job = await postJson<Job>('/v1/plans', { valve: row.reference, search: {} })
        rememberValve(job.valve, { reference: row.reference, label: row.name })
        row.isSearched = true
        this.draw()
      }
      await this.takePlans()
    } catch (error) {
      this.told.replaceChildren(problemList(problemsOf(error)))
    }
    this.draw()
  }

  private toSearch(): Row[] {
    return this.shown().filter(
      ({ closure, plan, isSearched }) => closure?.diagnosis && !closure.diagnosis.competent && !plan && !isSearched,
    )
  }

  private shown(): Row[] {
    return arranged(this.rows, this.by, this.isDown, this.filter.value)
  }

  private draw(): void {
    const rows = this.shown()
    for (const [column, head] of this.heads)
      head.setAttribute('aria-sort', column !== this.by ? 'none' : this.isDown ? 'descending' : 'ascending')
    const focused = keyOf(document.activeElement)
    this.body.replaceChildren(...rows.map((row) => this.line(row)))
    // Who goes through the table by the keyboard goes on where they were.
    if (focused !== null)
      [...this.body.querySelectorAll<HTMLElement>('a, input')].find((other) => keyOf(other) === focused)?.focus()
    const closed = rows.filter(({ closure }) => closure)
    const leaking = closed.filter(({ closure }) => closure?.diagnosis && !closure.diagnosis.competent)
    this.said.textContent = `${counted(rows.length, 'valve')}, ${closed.length} closed; ${leaking.length} of them ${leaking.length === 1 ? 'leaks' : 'leak'}.`
    const left = this.toSearch().length
    this.search.disabled = left === 0
    this.search.title = `Search for plans for ${counted(left, 'leaking valve')} without a plan.`
  }

  /// Of three the one that was ticked first is left out.
  private async tick(row: Row, is: boolean): Promise<void> {
    const others = this.ticked.filter((other) => other !== row)
    this.ticked = is ? [...others.slice(-1), row] : others
    this.draw()
    this.compared.hidden = this.ticked.length < 2
    if (this.compared.hidden) return
    try {
      this.pair ??= (await import('../viewer/side_by_side')).sideBySide()
      this.compared.replaceChildren(this.pair.element)
      await this.pair.show(this.ticked.map(({ name, reference }) => ({ name, reference, plan: null })))
    } catch (error) {
      this.compared.replaceChildren(problemList(problemsOf(error)))
    }
  }

  private box(row: Row): HTMLElement {
    const box = h('input', {
      type: 'checkbox',
      'aria-label': `Compare ${row.name}`,
      checked: this.ticked.includes(row),
      onchange: () => void this.tick(row, box.checked),
    })
    return box
  }

  private line(row: Row): HTMLElement {
    const { reference, plan } = row
    const address = (view: 'valve' | 'repair') =>
      writeAddress({
        view,
        valve: reference,
        steps: view === 'repair' ? (plan?.plan.steps ?? []) : [],
        job: null,
        story: null,
      })
    const cells = [...this.heads.keys()].map((column, i) => {
      const words = column.words(row)
      const isLink = i === 0 || (column.title === 'First plan' && plan !== null)
      const inside = isLink ? h('a', { href: address(i === 0 ? 'valve' : 'repair') }, words) : words
      const look = { class: column.numeric ? parts.number : column.title === 'Diagnosis' ? parts.sentences : undefined }
      return i === 0 ? h('th', { scope: 'row', ...look }, this.box(row), ' ', inside) : h('td', look, inside)
    })
    return h('tr', { 'data-part': 'cohort-valve', title: row.closure?.diagnosis?.sentence }, ...cells)
  }
}

/// Of a control in the table; null: it is none.
function keyOf(control: Element | null): string | null {
  if (!control?.closest('[data-part=cohort-valve]')) return null
  return control.getAttribute('aria-label') ?? control.getAttribute('href')
}
