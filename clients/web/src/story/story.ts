// A story: slides that drive the page by its own addresses, with texts that hold no figure but by its name. It is one of examples/stories, or all of
// it stands in the address (io/schema/story.schema.json).
import type { Problem, Step, Vector } from '../api/types'
import { COLOUR_MODES } from '../viewer/colours'
import { SEGMENTS } from '../viewer/marks'
import { TOWARDS_MM, ZOOM } from '../viewer/sight_ranges'
import type { ViewName } from '../viewer/stage'
import { FIGURE_NAMES } from './figures'
import { STORIES } from './shipped'
import type { Slide, Story } from './types'

export const CAMERAS = [
  'atrial',
  'oblique',
  'anterior',
  'lateral',
  'ventricular',
] as const satisfies readonly ViewName[]
export const EXPECTED = ['leaks', 'closed'] as const
export const TOLD_VIEWS = ['valve', 'repair', 'live'] as const
const LIFT_MM = { min: -20, max: 20 }
const PRESSURE_MMHG = { min: 0, max: 300 }
const DIRECTION = { min: -1, max: 1 }
const MOST_SLIDES = 40
const SHARED = '~' // before a story that stands in the address

/// The story that an address names, or what is wrong with it.
export async function storyOf(reference: string): Promise<Story> {
  const shipped = STORIES.find(({ name }) => name === reference)
  if (shipped) return shipped
  if (!reference.startsWith(SHARED)) throw new Error(`There is no story “${reference}” here.`)
  const text = await inflated(reference.slice(SHARED.length)).catch(() => {
    throw new Error('The story in the address cannot be read: a part of the link is missing.')
  })
  return readStory(text)
}

export async function encodeStory(story: Story): Promise<string> {
  const packed = new Blob([JSON.stringify(story)]).stream().pipeThrough(new CompressionStream('deflate-raw'))
  const bytes = new Uint8Array(await new Response(packed).arrayBuffer())
  const letters = btoa(String.fromCharCode(...bytes))
  return SHARED + letters.replaceAll('+', '-').replaceAll('/', '_').replaceAll('=', '')
}

async function inflated(letters: string): Promise<string> {
  const bytes = Uint8Array.from(atob(letters.replaceAll('-', '+').replaceAll('_', '/')), (letter) =>
    letter.charCodeAt(0),
  )
  return new Response(new Blob([bytes]).stream().pipeThrough(new DecompressionStream('deflate-raw'))).text()
}

/// A story that cannot be told.
export class StoryFault extends Error {
  constructor(readonly problems: Problem[]) {
    super(`This story cannot be shown: ${problems.map(({ path, message }) => `${path} ${message}`).join('; ')}.`)
  }
}

/// Throws a StoryFault with all that is wrong.
export function readStory(text: string): Story {
  let read: unknown
  try {
    read = JSON.parse(text)
  } catch (error) {
    throw new StoryFault([{ code: 'no_json', path: '', message: `is not JSON (${String(error)})` }])
  }
  const problems = problemsOfStory(read)
  if (problems.length > 0) throw new StoryFault(problems)
  return read as Story
}

type Check = (value: unknown) => string | null // what is wrong

const isText: Check = (value) => (typeof value === 'string' && value !== '' ? null : 'must be text that is not empty')
const oneOf =
  (known: readonly string[]): Check =>
  (value) =>
    known.includes(value as string) ? null : `is ${JSON.stringify(value)}; must be one of ${known.join(', ')}`
const within =
  ({ min, max }: { min: number; max: number }): Check =>
  (value) =>
    typeof value === 'number' && value >= min && value <= max
      ? null
      : `is ${JSON.stringify(value)}; must be from ${min} to ${max}`
const three =
  (range: { min: number; max: number }): Check =>
  (value) =>
    Array.isArray(value) && value.length === 3 && value.every((part) => within(range)(part) === null)
      ? null
      : `must be three numbers from ${range.min} to ${range.max}`
const isDirection: Check = (value) =>
  three(DIRECTION)(value) ??
  (Math.abs(Math.hypot(...(value as Vector)) - 1) < 0.01 ? null : 'must be a direction of length 1')
const isFlag: Check = (value) => (typeof value === 'boolean' ? null : 'must be true or false')
const isSteps: Check = (value) =>
  Array.isArray(value) && value.every((step) => typeof (step as Step | null)?.step === 'string')
    ? null
    : 'must be a list of steps of a repair plan'

/// Figures by their names alone: a typed one would stay when the valve is another.
export const isTold: Check = (value) => {
  if (typeof value !== 'string' || value === '') return isText(value)
  const unknown = [...value.matchAll(/\{(\w*)\}/g)]
    .map(([, name]) => name ?? '')
    .find((name) => !FIGURE_NAMES.includes(name))
  if (unknown !== undefined) return `names a figure {${unknown}}; must be one of ${FIGURE_NAMES.join(', ')}`
  const typed = /\d+([.,]\d+)?/.exec(value.replaceAll(/\{\w+\}/g, '').replaceAll(/\b[AP][123]\b/g, ''))
  return typed ? `has the typed number ${typed[0]}; must name a figure, such as {leak}` : null
}

const SLIDE: Readonly<Record<string, { check: Check; isOptional?: true }>> = {
  title: { check: isTold },
  text: { check: isTold },
  view: { check: oneOf(TOLD_VIEWS) },
  valve: { check: isText },
  steps: { check: isSteps, isOptional: true },
  camera: { check: (value) => (isObject(value) ? null : oneOf(CAMERAS)(value)), isOptional: true },
  colours: { check: oneOf(COLOUR_MODES.map(([name]) => name)), isOptional: true },
  cut: { check: isFlag, isOptional: true },
  pull: { check: () => null, isOptional: true },
  vary: { check: within({ min: 1, max: 99 }), isOptional: true },
  expect: { check: oneOf(EXPECTED), isOptional: true },
}
const PULL: typeof SLIDE = {
  segment: { check: oneOf(SEGMENTS) },
  lift_mm: { check: within(LIFT_MM) },
  pressure_mmhg: { check: within(PRESSURE_MMHG), isOptional: true },
}
const SIGHT: typeof SLIDE = {
  from: { check: isDirection },
  towards_mm: { check: three(TOWARDS_MM) },
  zoom: { check: within(ZOOM) },
}
const STORY: typeof SLIDE = {
  schema: { check: oneOf(['coapt.story/1']) },
  name: { check: isText },
  title: { check: isTold },
  about: { check: isTold },
  slides: { check: () => null },
}

export function problemsOfStory(read: unknown): Problem[] {
  const problems = checked(read, '', STORY)
  const slides = (read as Partial<Story> | null)?.slides
  if (!Array.isArray(slides) || slides.length === 0 || slides.length > MOST_SLIDES)
    return [
      ...problems,
      { code: 'bad_story', path: '/slides', message: `must be a list of 1 to ${MOST_SLIDES} slides` },
    ]
  slides.forEach((slide, i) => {
    problems.push(...checked(slide, `/slides/${i}`, SLIDE))
    const { pull, camera } = (slide ?? {}) as Partial<Slide>
    if (pull) problems.push(...checked(pull, `/slides/${i}/pull`, PULL))
    if (isObject(camera)) problems.push(...checked(camera, `/slides/${i}/camera`, SIGHT))
  })
  return problems
}

function isObject(value: unknown): value is Record<string, unknown> {
  return typeof value === 'object' && value !== null && !Array.isArray(value)
}

function checked(value: unknown, path: string, fields: typeof SLIDE): Problem[] {
  const fault = (below: string, message: string): Problem => ({ code: 'bad_story', path: path + below, message })
  if (!isObject(value)) return [fault('', 'must be an object')]
  const given = value
  const unknown = Object.keys(given).filter((name) => !(name in fields))
  const faults = unknown.map((name) =>
    fault(`/${name}`, `is not a field here; fields are ${Object.keys(fields).join(', ')}`),
  )
  for (const [name, { check, isOptional }] of Object.entries(fields)) {
    if (given[name] === undefined && isOptional) continue
    const message = given[name] === undefined ? 'is missing' : check(given[name])
    if (message !== null) faults.push(fault(`/${name}`, message))
  }
  return faults
}
