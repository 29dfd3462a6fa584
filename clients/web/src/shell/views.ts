/// The views of the page, in their order.
export const VIEWS = [
  ['valve', 'Valve'],
  ['repair', 'Repair'],
  ['live', 'Live'],
  ['search', 'Search'],
  ['studies', 'Studies'],
] as const
export type ViewName = (typeof VIEWS)[number][0]
