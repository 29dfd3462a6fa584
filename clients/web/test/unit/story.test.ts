// @vitest-environment node
import { expect, test } from 'vitest'
import schema from '../../../../io/schema/story.schema.json'
import { STORIES } from '../../src/story/shipped'
import { FIGURE_NAMES } from '../../src/story/figures'
import { encodeStory, problemsOfStory, readStory, StoryFault, storyOf } from '../../src/story/story'
import type { Slide, Story } from '../../src/story/types'

const slide: Slide = { title: 'It leaks', text: 'By {leak} at {place}, P2 above A2.', view: 'valve', valve: 'barlow' }
const story: Story = { schema: 'coapt.story/1', name: 'a', title: 'A', about: 'One.', slides: [slide] }
const faults = (some: object) => problemsOfStory({ ...story, slides: [{ ...slide, ...some }] })

test('four stories are shipped, and nothing is wrong with them', () => {
  expect(STORIES.map(({ name }) => name)).toEqual(['flail-p2', 'barlow', 'clip-against-ring', 'functional'])
  for (const one of STORIES) expect(problemsOfStory(one), one.name).toEqual([])
})

test('a typed number is refused with its place and what may stand there', () => {
  const [fault] = faults({ text: 'It leaks 46 mm² at P2.' })
  expect(fault).toMatchObject({ path: '/slides/0/text' })
  expect(fault?.message).toContain('typed number 46')
})

test('a figure that nobody measures is refused, and those that there are are named', () => {
  const [fault] = faults({ text: 'It is {beautiful}.' })
  expect(fault?.message).toContain('{beautiful}')
  for (const name of FIGURE_NAMES) expect(fault?.message).toContain(name)
})

test('what is wrong is said with its place: a view, a field, a pull, no slides, no JSON', () => {
  expect(faults({ view: 'search' })).toMatchObject([{ path: '/slides/0/view' }])
  expect(faults({ pulls: 1 })).toMatchObject([{ path: '/slides/0/pulls' }])
  expect(faults({ pull: { segment: 'P4', lift_mm: 200 } }).map(({ path }) => path)).toEqual([
    '/slides/0/pull/segment',
    '/slides/0/pull/lift_mm',
  ])
  expect(problemsOfStory({ ...story, slides: [] })).toMatchObject([{ path: '/slides' }])
  expect(() => readStory('{')).toThrow(StoryFault)
})

test('a camera has a name, or is what was recorded', () => {
  const camera = { from: [0, -0.6, 0.8], towards_mm: [0, 0, -5], zoom: 1.2 }
  expect(faults({ camera: 'oblique' })).toEqual([])
  expect(faults({ camera })).toEqual([])
  expect(faults({ camera: { ...camera, from: [0, 1] } })).toMatchObject([{ path: '/slides/0/camera/from' }])
  expect(faults({ camera: { ...camera, zoom: 0 } })).toMatchObject([{ path: '/slides/0/camera/zoom' }])
  expect(faults({ camera: [0, 0, 1] })).toMatchObject([{ path: '/slides/0/camera' }])
})

test('a story comes whole out of its link, and a link that is cut says so', async () => {
  const link = await encodeStory(story)
  expect(link).toMatch(/^~[\w-]+$/)
  expect(await storyOf(link)).toEqual(story)
  await expect(storyOf(link.slice(0, -9))).rejects.toThrow('a part of the link is missing')
  await expect(storyOf('nobody')).rejects.toThrow('There is no story “nobody” here.')
})

test('schema and reader know the same fields and words', () => {
  const { slide: ofSlide, pull, sight } = schema.$defs
  const known = (fields: object, path: string) =>
    problemsOfStory({ ...story, slides: [{ ...slide, ...(path === '' ? fields : { [path]: fields }) }] })
  const named = (problems: ReturnType<typeof problemsOfStory>) => problems[0]?.message ?? ''
  expect(named(known({ nothing: 1 }, ''))).toContain(Object.keys(ofSlide.properties).join(', '))
  expect(named(known({ segment: 'P2', lift_mm: 1, nothing: 1 }, 'pull'))).toContain(
    Object.keys(pull.properties).join(', '),
  )
  expect(named(known({ nothing: 1 }, 'camera'))).toContain(Object.keys(sight.properties).join(', '))
  expect(named(known({ camera: 'nothing' }, ''))).toContain(ofSlide.properties.camera.oneOf[0]?.enum?.join(', '))
  for (const [name, { enum: words }] of Object.entries(ofSlide.properties as Record<string, { enum?: string[] }>))
    if (words) expect(named(known({ [name]: 'nothing' }, ''))).toContain(words.join(', '))
})
