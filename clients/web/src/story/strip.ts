// A story above the views: what a slide says of what the page shows, and the way to the next one.
import { openValve } from '../api/calls'
import { button, h } from '../dom'
import { NO_PLAN, type Workspace } from '../workspace'
import { onReadings, readings, tellReadings } from '../state/readings'
import { nameOfValve } from '../state/valves'
import { withheld } from '../shell/views'
import type { View } from '../view'
import { presetTitle } from '../valve/presets'
import { addressOf } from './address'
import { isOpened, NOT_YET, type Shown, told } from './figures'
import { storyOf } from './story'
import type { Slide, Story } from './types'
import parts from '../style/parts.module.css'
import storyStyle from './story.module.css'

const FAULTS = {
  leaks: 'This slide was written for a leaking valve, but this valve does not leak; its text may not apply.',
  closed: 'This slide was written for a competent valve, but this valve leaks; its text may not apply.',
}

export interface StoryStrip {
  element: HTMLElement
  follow(): void // the page as it is now
}

/// `shown`: the view in the page.
export function storyStrip(workspace: Workspace, shown: () => { name: string; view: View | null }): StoryStrip {
  const title = h('h2', {})
  const text = h('p', { 'aria-live': 'polite', 'data-part': 'story-text' })
  const fault = h('p', { class: parts.warn, role: 'status' })
  const count = h('span', { class: parts.hint, 'data-part': 'story-count' })
  const back = button('Back', () => go(-1))
  const next = button('Next', () => go(1), { class: parts.primary })
  const again = button('Show the slide again', () => go(0))
  const editing = h('div', { class: storyStyle.editing })
  const edit = button('Edit', () => void toggleEditor(), { 'aria-expanded': 'false' })
  const element = h(
    'section',
    { class: storyStyle.strip, 'aria-label': 'Story', 'data-part': 'story', hidden: true },
    h('div', { class: storyStyle.words }, title, text, fault),
    h(
      'div',
      { class: storyStyle.way },
      count,
      again,
      back,
      next,
      edit,
      button('End', () => workspace.tell(null), { 'aria-label': 'End the story' }),
    ),
    editing,
  )
  let story: Story | null = null
  let reference = '' // of the story, or of that which is on its way
  let arrived = '' // the slide whose valve and plan were shown last
  let performed = '' // the slide whose actions are done
  let opened = '' // valve and plan of readings.opening, or of that which is on its way
  let editor: { follow(story: Story, slide: number): void } | null = null

  const place = () => workspace.story?.slide ?? 0
  const keyOf = (): string => `${reference} ${place()}`
  const slide = (): Slide | undefined => story?.slides[place()]
  const isTold = ({ view }: Slide): boolean => !withheld.has(view)

  function follow(): void {
    const asked = workspace.story
    element.hidden = asked === null
    if (!asked) return
    if (asked.reference !== reference) void load(asked.reference)
    else if (story && place() >= story.slides.length) workspace.tell({ reference, slide: story.slides.length - 1 })
    else draw()
  }

  async function load(asked: string): Promise<void> {
    reference = asked
    try {
      const read = await storyOf(asked)
      if (asked !== reference) return
      story = read
      follow()
    } catch (error) {
      story = null
      title.textContent = 'No story'
      text.textContent = error instanceof Error ? error.message : String(error)
      back.disabled = next.disabled = edit.disabled = true
    }
  }

  function draw(): void {
    const present = slide()
    if (!story || !present) return
    const all = story.slides.filter(isTold)
    count.textContent = `${story.title} · ${story.slides.slice(0, place() + 1).filter(isTold).length} of ${all.length}`
    back.disabled = step(-1) === null
    next.disabled = step(1) === null
    edit.disabled = false
    const at = figuresOf(present)
    say(title, told(present.title, at))
    say(text, told(present.text, at))
    say(fault, at && faultOf(present, at))
    editor?.follow(story, place())
    again.hidden = arrived !== keyOf() || isShown(present)
    element.dataset.told = at && !text.textContent?.includes(NOT_YET) ? String(place() + 1) : ''
    if (!at) return
    if (isOpened(present.text)) void open(at)
    perform(present)
  }

  function say(where: HTMLElement, words: string | null): void {
    where.hidden = !words
    if (where.textContent !== words) where.textContent = words
  }

  /// Null until the slide's valve and plan have been closed; then of what the reader makes of them.
  function figuresOf({ valve, steps = NO_PLAN.steps }: Slide): Shown | null {
    const { before, after, plan, isAnswered } = workspace
    const isHere = before !== null && workspace.valve?.reference === valve && isAnswered
    if (!isHere || (plan.steps.length > 0 && !after)) return null
    if (JSON.stringify(plan.steps) === JSON.stringify(steps)) arrived = keyOf()
    return arrived === keyOf() ? { valve: titleOf(valve), before, after, plan, readings } : null
  }

  function isShown({ view, valve, steps = NO_PLAN.steps }: Slide): boolean {
    const isSamePlan = JSON.stringify(workspace.plan.steps) === JSON.stringify(steps)
    return shown().name === view && workspace.valve?.reference === valve && isSamePlan
  }

  function faultOf({ expect }: Slide, { before, after }: Shown): string | null {
    const isCompetent = (after ?? before).closure.diagnosis?.competent
    if (!expect || isCompetent === undefined) return null
    return (expect === 'closed') === isCompetent ? null : FAULTS[expect]
  }

  async function open({ before, plan }: Shown): Promise<void> {
    const { reference: valve } = workspace.valve ?? { reference: '' }
    const key = JSON.stringify([valve, plan.steps])
    if (key === opened) return
    opened = key
    tellReadings({ opening: null })
    const opening = await openValve(valve, plan.steps.length > 0 ? plan : null, 0).catch(() => null)
    if (key === opened && workspace.before === before) tellReadings({ opening })
  }

  /// Once, in the view of the slide.
  function perform(present: Slide): void {
    const { name, view } = shown()
    if (arrived === performed || name !== present.view || !view) return
    performed = arrived
    setTimeout(() => view.perform?.(present)) // after the view has taken what this was called for
  }

  /// The place of the next slide that can be told here, or of the one before.
  function step(way: 1 | -1 | 0): number | null {
    if (way === 0) return place()
    for (let at = place() + way; story && at >= 0 && at < story.slides.length; at += way)
      if (isTold(story.slides[at] as Slide)) return at
    return null
  }

  function go(way: 1 | -1 | 0): void {
    const at = step(way)
    if (way === 0) performed = ''
    if (story && at !== null) location.hash = addressOf(story, reference, at)
  }

  async function toggleEditor(): Promise<void> {
    const isOpen = edit.getAttribute('aria-expanded') === 'true'
    edit.setAttribute('aria-expanded', String(!isOpen))
    editor = null
    editing.replaceChildren()
    if (isOpen || !story) return
    const made = (await import('./editor')).storyEditor(workspace, shown)
    editing.replaceChildren(made.element)
    editor = made
    made.follow(story, place())
  }

  workspace.subscribe(follow)
  onReadings(follow)
  return { element, follow }
}

function titleOf(reference: string): string {
  const title = presetTitle(reference)
  return title === reference ? nameOfValve(reference) : title
}
