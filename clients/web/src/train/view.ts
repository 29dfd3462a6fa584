// The trainer: exams and practice in valve analysis, instruction, results (thesis chapter 3).
import { button, h } from '../dom'
import { problemList } from '../problems'
import type { View } from '../view'
import { problemsOf, type Workspace } from '../workspace'
import parts from '../style/parts.module.css'
import { Analysis } from './analysis'
import { TrainEngine } from './engine'
import { FourValves } from './four_valves'
import { Frame } from './frame'
import { Learn } from './learn'
import { Results } from './results'
import { Session } from './session'
import { type Asked, Setup } from './setup'
import trainStyle from './train.module.css'

type Place = 'start' | 'exam' | 'learn' | 'results'

export class TrainView implements View {
  readonly element: HTMLElement
  private readonly engine = new TrainEngine()
  private readonly frame = new Frame()
  private readonly setup: Setup
  private readonly results = new Results(this.engine)
  private readonly told = h('div', {})
  private readonly body = h('div', { class: trainStyle.body })
  private readonly tabs: HTMLElement
  private readonly tabOf = new Map<Place, HTMLButtonElement>()
  private readonly back = button('Back', () => this.go(this.running ? 'exam' : 'start'))
  private learn: Learn | null = null
  private tools: { analysis: Analysis; four: FourValves } | null = null // a browser has few canvases in three dimensions
  private running: AbortController | null = null
  private place: Place = 'start'
  private isShown = false

  constructor(workspace: Workspace) {
    this.setup = new Setup(workspace)
    this.setup.onStart = (asked) => void this.run(asked)
    this.setup.onFault = (error) => this.refuse(error)
    for (const [place, words] of [
      ['start', 'Exams and practice'],
      ['learn', 'Learn'],
      ['results', 'Results'],
    ] as const)
      this.tabOf.set(
        place,
        button(words, () => this.go(place)),
      )
    this.tabs = h(
      'div',
      { class: trainStyle.tabs, role: 'group', 'aria-label': 'Parts of the trainer' },
      ...this.tabOf.values(),
    )
    this.element = h(
      'div',
      { class: trainStyle.train },
      h('h1', { class: parts.unseen }, 'Train'),
      this.tabs,
      this.told,
      this.body,
    )
    this.go('start')
  }

  show(): void {
    this.isShown = true
    void this.setup.listValves()
    this.go(this.place)
  }
  hide(): void {
    this.isShown = false
    this.learn?.hide()
  }

  private go(place: Place): void {
    if (this.place === 'learn' && place !== 'learn') this.learn?.hide()
    this.place = place
    this.tabs.hidden = this.running !== null
    this.told.replaceChildren()
    for (const [name, tab] of this.tabOf) tab.setAttribute('aria-pressed', String(name === place))
    if (place === 'learn') this.back.hidden = this.running === null
    this.body.replaceChildren(this.elementOf(place))
    if (place === 'results') this.results.show()
    if (place === 'learn' && this.isShown) this.learn?.show()
  }

  private elementOf(place: Place): HTMLElement {
    switch (place) {
      case 'start':
        return this.setup.element
      case 'exam':
        return this.frame.element
      case 'learn':
        this.learn ??= new Learn(this.engine, () => this.setup.valve, this.back)
        return this.learn.element
      case 'results':
        return this.results.element
    }
  }

  private async run(asked: Asked): Promise<void> {
    const running = new AbortController()
    const { engine, frame, setup } = this
    this.running = running
    this.told.replaceChildren()
    try {
      this.tools ??= { analysis: new Analysis(), four: new FourValves() }
      this.tools.analysis.canvas.onFailure = (message) => this.refuse(new Error(message))
      const session = new Session({
        ...this.tools,
        engine,
        frame,
        learn: (seed) => {
          this.go('learn')
          if (seed !== undefined) this.learn?.take(seed)
        },
        learner: { number: setup.number, valve: setup.valve },
        signal: running.signal,
        stop: button('Stop', () => running.abort()),
      })
      if ('practise' in asked) {
        this.go('exam')
        await session.practise(asked.practise, asked.first_case)
      } else {
        const laid = await engine.layOut(asked.schedule, asked.seed, asked.first_case)
        this.go('exam')
        await session.schedule(laid)
      }
      this.finish('results')
    } catch (error) {
      this.finish(running.signal.aborted ? 'results' : 'start')
      if (!running.signal.aborted) this.refuse(error)
    }
  }

  private finish(place: Place): void {
    this.running = null
    this.tools?.analysis.canvas.end()
    this.engine.drop()
    this.go(place)
  }

  private refuse(error: unknown): void {
    this.told.replaceChildren(problemList(problemsOf(error)))
  }
}
