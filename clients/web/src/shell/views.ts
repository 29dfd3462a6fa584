/// The views of the page, in their order.
export const VIEWS = [
  ['valve', 'Valve'],
  ['repair', 'Repair'],
  ['live', 'Live'],
  ['search', 'Search'],
  ['studies', 'Studies'],
  ['cohort', 'Cohort'],
  ['train', 'Train'],
  ['farm', 'Farm'], // in the bar where the service has one
] as const
export type ViewName = (typeof VIEWS)[number][0]

/// Those that bar and palette leave out: what they need is not there.
export const withheld = new Set<ViewName>(['farm'])

export function viewTitle(view: ViewName): string {
  return VIEWS.find(([name]) => name === view)?.[1] ?? ''
}
