// What the engine says of training (docs/training.md), and what this browser keeps of a trial.
import { SEGMENTS } from '../viewer/marks'

export type Exam = 'A' | 'B'

export { SEGMENTS } // in the order of the letters of an answer to exam B
export type SegmentName = (typeof SEGMENTS)[number]

export const MOBILITIES = ['tethered', 'normal', 'prolapsing'] as const
export type Mobility = (typeof MOBILITIES)[number]

interface CaseHeading {
  seed: number
  name: string // of the valve that it was made of
  difficulty: number
  chance: number // of a right answer, by guessing
  valve: object // coapt.valve/1 of the valve that is pulled, of an arrested heart
}

export interface CaseA extends CaseHeading {
  exam: 'A'
  answer: number // 1 to 4
  choices: { choice: number; leak_mm2: number; closed_mm: number[] }[]
}

export interface SegmentTruth {
  segment: SegmentName
  mobility: Mobility
  height_mm: number // that the pulled free edge reaches
  normal_mm: number // in the valve without lesions
  change_mm: number
}

export interface CaseB extends CaseHeading {
  exam: 'B'
  pressed_valve: object // the same, its papillary tips where pressure has them
  limits: { pull_n: number; limit_mm: number }
  segments: SegmentTruth[]
}

export type Case = CaseA | CaseB

/// coapt.training_schedule/1, as far as the page looks into it.
export interface Schedule {
  name: string
  title: string
  notes?: string[]
  blocks: object[]
}

export interface TrialBlock {
  name: string
  exam: Exam
  seconds: number // of analysis at most; 0: no limit
  trials: { seed: number; repeated: boolean }[]
}
export interface InstructionBlock {
  name: string
  instruction: string
}
/// coapt.training_exam/1: a schedule as one learner does it.
export interface LaidExam {
  title: string
  notes: string[]
  blocks: (TrialBlock | InstructionBlock)[]
}

export interface Score {
  learner: number
  exam: Exam
  block: string | null // null: over all blocks
  trials: number
  answers: number
  right: number
  share: number
  interval95: [number, number]
  chance: number
  by_chance: number // probability of as many right answers by guessing
  brier: number
  seconds: number // mean of a trial, as the next one
  path_mm: number
  largest_n: number
  ability: number
  ability_se: number
}
export interface NextCase {
  learner: number
  exam: Exam
  difficulty: number // that is got right with a probability of 0.6
  repeat: { valve: string; seed: number; due_in: number }[]
}
/// coapt.training_score/1
export interface Scores {
  scores: Score[]
  next: NextCase[]
}

export interface Learner {
  number: number
  valve: string // a preset's name or the id of an opened valve, of which cases are made
}

/// How a valve was analysed.
export interface Analysed {
  seconds: number
  path_mm: number // that hooks travelled
  largest_n: number // force of a hook
  visited: SegmentName[] // in order, no segment twice in succession
}

/// What a learner said. Exam A: "1" to "4"; exam B: a letter of T, N, P for each segment.
export interface Judged extends Analysed {
  choice: string
  answer: string
  right: number
  confidence: number // 0 to 1
  choosing_s: number // after the analysis
}

export interface Trial extends Judged {
  learner: number
  block: string
  trial: number // of the learner, from 1
  valve: string
  exam: Exam
  seed: number
  difficulty: number
}
