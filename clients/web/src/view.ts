import type { Slide } from './story/types'
import type { Sight } from './viewer/stage'

/// What Ctrl+K finds.
export interface Command {
  group: string
  name: string
  run(): void
}

/// One of the page's views. It keeps its state while another is shown.
export interface View {
  readonly element: HTMLElement
  show(): void // its element is in the page now
  hide(): void
  settings?(): Command[] // of how it shows the valve
  perform?(slide: Slide): void // what a slide of a story asks beside valve and plan, which are shown
  readonly sight?: Sight | null // of the valve, for a slide to record
}
