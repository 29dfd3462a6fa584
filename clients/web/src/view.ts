import type { Slide } from './story/types'

/// One of the page's views. It keeps its state while another is shown.
export interface View {
  readonly element: HTMLElement
  show(): void // its element is in the page now
  hide(): void
  perform?(slide: Slide): void // what a slide of a story asks beside valve and plan, which are shown
}
