// The stories of examples/stories.
import type { Story } from './types'

const FIRST = 'flail-p2' // offered to who comes for the first time

const files = import.meta.glob<Story>('../../../../examples/stories/*.json', { eager: true, import: 'default' })

export const STORIES: readonly Story[] = Object.values(files).sort(
  (one, other) => Number(other.name === FIRST) - Number(one.name === FIRST),
)
