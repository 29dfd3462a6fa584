/// Brings what was asked for into view, where it stands below what asked for it.
export function lookAt(element: HTMLElement): void {
  if (element.getBoundingClientRect().top > innerHeight / 2) element.scrollIntoView()
}
