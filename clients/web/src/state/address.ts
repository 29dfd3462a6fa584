// The address says what the page shows: #/repair?valve=human-functional-mr&plan=...&job=...
import type { Step } from '../api/types'
import { VIEWS, type ViewName } from '../shell/views'

/// Which slide of a story is told.
export interface StoryPlace {
  reference: string // a name in examples/stories, or the story itself (story/story.ts)
  slide: number // the first is 0
}

export interface Address {
  view: ViewName | null // null: the address names no view
  valve: string | null // a preset's name or a stored valve's id
  steps: Step[] | null // of the plan at hand; null: none is said
  job: string | null
  story: StoryPlace | null
  faults: string[] // what in the address cannot be read
}

export function readAddress(hash: string): Address {
  const [path = '', query = ''] = hash.replace(/^#\/?/, '').split('?', 2)
  const name = path === '' ? 'valve' : path
  const view = VIEWS.find(([known]) => known === name)?.[0] ?? null
  const said = new URLSearchParams(query)
  const faults = view === null ? [`There is no view named “${name}”.`] : []
  const plan = said.get('plan')
  const steps = plan === null ? null : readSteps(plan)
  if (plan !== null && steps === null) faults.push('The plan in the address cannot be read.')
  const reference = said.get('story')
  const story =
    reference === null
      ? null
      : { reference, slide: Math.max(0, (Number.parseInt(said.get('slide') ?? '', 10) || 1) - 1) }
  return { view, valve: said.get('valve'), steps, job: said.get('job'), story, faults }
}

export function writeAddress({ view, valve, steps, job, story }: Omit<Address, 'faults'>): string {
  const said = new URLSearchParams()
  if (valve !== null) said.set('valve', valve)
  if (steps && steps.length > 0) said.set('plan', writeSteps(steps))
  if (job !== null) said.set('job', job)
  if (story) said.set('story', story.reference)
  if (story) said.set('slide', String(story.slide + 1))
  const query = said.toString()
  return `#/${view ?? 'valve'}${query === '' ? '' : `?${query}`}`
}

/// JSON in the letters that an address takes as they are (base64url).
function writeSteps(steps: Step[]): string {
  const bytes = new TextEncoder().encode(JSON.stringify(steps))
  return btoa(String.fromCharCode(...bytes))
    .replaceAll('+', '-')
    .replaceAll('/', '_')
    .replaceAll('=', '')
}

function readSteps(text: string): Step[] | null {
  try {
    const letters = atob(text.replaceAll('-', '+').replaceAll('_', '/'))
    const bytes = Uint8Array.from(letters, (letter) => letter.charCodeAt(0))
    const steps: unknown = JSON.parse(new TextDecoder().decode(bytes))
    const isPlan = Array.isArray(steps) && steps.every((step) => typeof (step as Step | null)?.step === 'string')
    return isPlan ? (steps as Step[]) : null
  } catch {
    return null
  }
}
