// Where the slides of a story are shown.
import { writeAddress } from '../state/address'
import type { Slide, Story } from './types'

/// `reference`: the name of a shipped story, or the story itself.
export function addressOf({ slides }: Story, reference: string, slide: number): string {
  const { view, valve, steps = [] } = slides[slide] as Slide
  return writeAddress({ view, valve, steps, job: null, story: { reference, slide } })
}
