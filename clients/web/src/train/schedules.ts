// Schedules: the thesis's studies as they lie in examples/training, and one that a person opens.
import type { Schedule } from './types'

const files = import.meta.glob<Schedule>('../../../../examples/training/*.json', { eager: true, import: 'default' })

export const STUDIES: readonly Schedule[] = Object.values(files)

/// One valve whose eight segments are judged.
export const EXAM_B: Schedule & { schema: string } = {
  schema: 'coapt.training_schedule/1',
  name: 'exam-b',
  title: 'Exam B: three valves, eight segments each',
  blocks: [{ name: 'exam', exam: 'B', cases: 3, seconds: 0 }],
}

/// Throws where it is no JSON; the engine says what else is wrong.
export function readSchedule(text: string): Schedule {
  const read = JSON.parse(text) as Schedule
  return { ...read, title: String(read.title ?? ''), blocks: read.blocks ?? [] }
}
