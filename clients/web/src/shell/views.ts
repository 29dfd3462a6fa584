/// The views of the page, in their order.
export const VIEWS = [
  ['valve', 'Valve'],
  ['repair', 'Repair'],
  ['live', 'Live'],
  ['search', 'Search'],
  ['studies', 'Studies'],
  ['train', 'Train'],
] as const
export type ViewName = (typeof VIEWS)[number][0]
