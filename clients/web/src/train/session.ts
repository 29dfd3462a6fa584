// Trials one after the other: a schedule's for one learner, or practice without an end. Each is kept as soon as it is answered.
import { button, h } from '../dom'
import parts from '../style/parts.module.css'
import type { Analysis } from './analysis'
import type { TrainEngine } from './engine'
import { trialA } from './exam_a'
import { trialB } from './exam_b'
import { feedbackA, feedbackB } from './feedback'
import type { FourValves } from './four_valves'
import { type Frame, panel } from './frame'
import { makeAhead, nextSeed } from './practice'
import { keepTrial } from './trials'
import type { Case, Exam, InstructionBlock, Judged, LaidExam, Learner, TrialBlock } from './types'
import { pressed, unless } from './waits'

export interface SessionParts {
  engine: TrainEngine
  frame: Frame
  analysis: Analysis
  four: FourValves
  learn(seed?: number): void // shows the instruction, on this case of exam B
  learner: Learner
  signal: AbortSignal
  stop: HTMLElement // a button that ends it
}

export class Session {
  constructor(private readonly at: SessionParts) {}

  async schedule({ blocks }: LaidExam): Promise<void> {
    for (const block of blocks) {
      if ('instruction' in block) await this.instruct(block)
      else await this.block(block)
    }
  }

  async practise(exam: Exam, first_case: number): Promise<void> {
    const { engine, learner } = this.at
    for (let count = 1; ; ++count) {
      const title = `Practice, case ${count}`
      this.wait(title)
      const seed = await this.unless(nextSeed({ engine, learner, exam, first_case }))
      const made = await this.unless(engine.make(learner.valve, exam, seed))
      makeAhead({ engine, learner, exam, first_case }, seed)
      const judged = await this.trial(made, 'practice', title, 0)
      const place = { ...this.at, title, aside: this.aside('practice') }
      if (made.exam === 'A') await feedbackA(made, judged, place)
      else await feedbackB(made, judged, place)
    }
  }

  private async block({ name, exam, seconds, trials }: TrialBlock): Promise<void> {
    const { engine, learner } = this.at
    for (const [i, { seed }] of trials.entries()) {
      const place = name === 'exam' ? '' : `, ${name}`
      const title = `Exam ${exam}${place}: trial ${i + 1} of ${trials.length}`
      this.wait(title)
      const made = await this.unless(engine.make(learner.valve, exam, seed))
      const next = trials[i + 1]
      if (next) engine.make(learner.valve, exam, next.seed).catch(() => {}) // said when its turn comes
      await this.trial(made, name, title, seconds)
    }
  }

  private async trial(made: Case, block: string, title: string, limit_s: number): Promise<Judged> {
    const { learner } = this.at
    const place = { ...this.at, title, limit_s, aside: this.aside(block) }
    const judged = made.exam === 'A' ? await trialA(made, place) : await trialB(made, place)
    keepTrial(learner.number, block, made, judged)
    return judged
  }

  private async instruct({ name, instruction }: InstructionBlock): Promise<void> {
    const done = button('Continue', () => {}, { class: parts.primary })
    const open = button('Read the instruction on this page', () => this.at.learn())
    const words = h('div', { class: parts.panel }, h('p', {}, instruction), h('p', { class: parts.row }, open, done))
    this.at.frame.show(`Instruction: ${name}`, 'The next trials begin afterwards.', words, [this.aside(name)])
    await pressed(done, this.at.signal)
  }

  private wait(title: string): void {
    const words = h('div', { class: parts.panel }, 'A case is being made, which takes some seconds.')
    this.at.frame.show(title, 'Making the next case ...', words, [this.aside('')])
  }

  private aside(block: string): HTMLElement {
    const { number } = this.at.learner
    return panel('Exam', h('p', {}, `Learner ${number}${block === '' ? '' : ` · ${block}`}`), this.at.stop)
  }

  private unless<T>(work: Promise<T>): Promise<T> {
    return unless(this.at.signal, work)
  }
}
