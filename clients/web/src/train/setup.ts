// What is done next: an exam, a study's schedule or practice; for whom, of which valve, in which order.
import { presets } from '../api/calls'
import { field, filePicker, h, select } from '../dom'
import { labelledButton } from '../icons'
import { store, stored } from '../state/stored'
import type { Workspace } from '../workspace'
import parts from '../style/parts.module.css'
import { panel } from './frame'
import { EXAM_B, readSchedule, STUDIES } from './schedules'
import trainStyle from './train.module.css'
import type { Exam, Schedule } from './types'

export type Asked = { schedule: Schedule; seed: number; first_case: number } | { practise: Exam; first_case: number }

const KEY = 'coapt-training-setup'
const FIRST_VALVE = 'human-normal'
const PRACTICE: readonly (readonly [Exam, string])[] = [
  ['A', 'Practice A: find the valve'],
  ['B', 'Practice B: judge the segments'],
]

export class Setup {
  readonly element: HTMLElement
  onStart: (asked: Asked) => void = () => {}
  onFault: (error: unknown) => void = () => {}
  valve: string
  private task = 'practice A'
  private schedules: readonly Schedule[] = [...STUDIES, EXAM_B]
  private readonly learner: HTMLInputElement
  private readonly seed: HTMLInputElement
  private readonly first: HTMLInputElement
  private readonly tasks = h('select', { onchange: () => this.choose(this.tasks.value) })
  private readonly valves = h('select', { onchange: () => (this.valve = this.valves.value) })
  private readonly notes = h('div', { class: parts.hint })
  private readonly orders = h('div', {})

  constructor(private readonly workspace: Workspace) {
    const kept = stored(KEY, { learner: 1, seed: 1, first_case: 1, valve: FIRST_VALVE })
    this.valve = kept.valve
    const numbered = (value: number, max: number) => h('input', { type: 'number', min: 1, max, step: 1, value })
    this.learner = numbered(kept.learner, 1e6)
    this.seed = numbered(kept.seed, 1e9)
    this.first = numbered(kept.first_case, 1e9)
    this.orders.append(field('Order (seed)', this.seed))
    this.element = panel(
      'Task',
      h(
        'div',
        { class: trainStyle.form },
        field('Task', this.tasks),
        field('Learner', this.learner),
        field('Valve', this.valves),
        field('First case (seed)', this.first),
        this.orders,
      ),
      this.notes,
      h(
        'p',
        { class: parts.row },
        labelledButton('animation', 'Start', 'Start', () => this.start(), { class: parts.primary }),
      ),
      h(
        'details',
        { class: parts.more },
        h('summary', {}, 'Another schedule'),
        filePicker('Schedule file', 'Choose a schedule', {
          accept: '.json,application/json',
          use: ([file]) => void this.read(file),
        }),
        h('p', { class: parts.hint }, 'A coapt.training_schedule/1 document, such as those in examples/training.'),
      ),
      h(
        'p',
        { class: parts.hint },
        'Learners are identified by a number, not a name. Cases are made from their seeds; each exam has its own seed for the order of trials. Trials are stored in this browser until you export them.',
      ),
    )
    this.list()
    this.choose(this.task)
  }

  get number(): number {
    return whole(this.learner, 1e6)
  }

  /// Presets, and the valve that is open.
  async listValves(): Promise<void> {
    const names = await presets().catch(() => [FIRST_VALVE])
    const { valve } = this.workspace
    const open = valve && !names.includes(valve.reference) ? [[valve.reference, valve.label] as const] : []
    const options = [...names.map((name) => [name, name] as const), ...open]
    if (!options.some(([reference]) => reference === this.valve)) this.valve = FIRST_VALVE
    this.valves.replaceChildren(...select(options, this.valve, () => {}).children)
    this.valves.value = this.valve
  }

  private list(): void {
    const options = [
      ...PRACTICE.map(([exam, words]) => [`practice ${exam}`, words] as const),
      ...this.schedules.map(({ name, title }) => [name, title] as const),
    ]
    this.tasks.replaceChildren(...select(options, this.task, () => {}).children)
    this.tasks.value = this.task
  }

  private choose(task: string): void {
    this.task = task
    const schedule = this.schedules.find(({ name }) => name === task)
    this.orders.hidden = !schedule
    const words = schedule
      ? (schedule.notes ?? [])
      : ['There is no time limit, and the answer is shown after each case. Cases answered wrongly are repeated.']
    this.notes.replaceChildren(...words.map((note) => h('p', {}, note)))
  }

  private async read(chosen: File | undefined): Promise<void> {
    if (!chosen) return
    try {
      const schedule = readSchedule(await chosen.text())
      this.schedules = [...this.schedules.filter(({ name }) => name !== schedule.name), schedule]
      this.task = schedule.name
      this.list()
      this.choose(schedule.name)
    } catch (error) {
      this.onFault(error)
    }
  }

  private start(): void {
    const [seed, first_case] = [whole(this.seed, 1e9), whole(this.first, 1e9)]
    store(KEY, { learner: this.number, seed, first_case, valve: this.valve })
    const schedule = this.schedules.find(({ name }) => name === this.task)
    this.onStart(
      schedule ? { schedule, seed, first_case } : { practise: this.task.endsWith('B') ? 'B' : 'A', first_case },
    )
  }
}

/// At least 1.
function whole(input: HTMLInputElement, most: number): number {
  const value = Math.min(Math.max(Math.round(Number(input.value)) || 1, 1), most)
  input.value = String(value)
  return value
}
