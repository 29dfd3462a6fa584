// Where stories are found: the first visit offers one, the view Valve lists them all.
import { button, h } from '../dom'
import { store, stored } from '../state/stored'
import type { Workspace } from '../workspace'
import { addressOf } from './address'
import { STORIES } from './shipped'
import parts from '../style/parts.module.css'
import storyStyle from './story.module.css'

const VISITED = 'coapt-visited'

/// Shown until somebody does something; once in this browser.
export function firstVisit(workspace: Workspace): HTMLElement | null {
  const [story] = STORIES
  if (!story || stored(VISITED, false)) return null
  const end = (): void => {
    element.hidden = true
    store(VISITED, true)
  }
  const element = h(
    'div',
    { class: storyStyle.offer, role: 'region', 'aria-label': 'First visit', 'data-part': 'first-visit' },
    h('span', {}, 'New here? See a case in ninety seconds:'),
    h('a', { href: addressOf(story, story.name, 0) }, story.title),
    button('Not now', end),
  )
  workspace.subscribe(() => {
    if (workspace.story || workspace.plan.steps.length > 0) end()
  })
  return element
}

export function storyList(): HTMLElement {
  return h(
    'section',
    { class: parts.panel },
    h('h2', {}, 'A case in ninety seconds'),
    h(
      'ul',
      { class: storyStyle.stories },
      ...STORIES.map((story) =>
        h(
          'li',
          {},
          h('a', { href: addressOf(story, story.name, 0) }, story.title),
          h('div', { class: parts.hint }, story.about),
        ),
      ),
    ),
  )
}
