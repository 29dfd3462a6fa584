/// One of the page's views. It keeps its state while another is shown.
export interface View {
  readonly element: HTMLElement
  show(): void // its element is in the page now
  hide(): void
}
