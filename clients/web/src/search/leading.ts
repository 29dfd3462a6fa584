// The best plan so far of a search that runs: its words, its figures, its picture beside the valve as it is.
import type { JobProgress, Plan } from '../api/types'
import { h } from '../dom'
import { counted, withUnit } from '../format'
import { inWords } from './figures'
import type { Photos } from './photos'
import parts from '../style/parts.module.css'
import searchStyle from './search.module.css'

const PICTURE_PAUSE_MS = 2000 // each closes the valve beside the search

export interface Leading {
  element: HTMLElement
  show(progress: JobProgress): void
}

export function leadingPlan(photos: Photos): Leading {
  const words = h('p', { class: searchStyle.leads }, 'No plan yet. The best plan appears here once plans are scored.')
  const figures = h('dl', { class: parts.figures })
  const after = h('div', {})
  const both = h(
    'div',
    { class: searchStyle.two, hidden: true },
    caption('Before', photos.photo(null, 'The valve before repair')),
    after,
  )
  const element = h(
    'section',
    { class: parts.panel, 'data-part': 'leading', 'aria-label': 'Best plan so far' },
    h('h2', {}, 'Best plan so far'),
    words,
    figures,
    both,
  )
  let shown: string | null = null
  let drawn = -PICTURE_PAUSE_MS

  function picture(plan: Plan, said: string): void {
    both.hidden = false
    after.replaceChildren(caption('With this plan', photos.photo(plan, `The valve with this plan: ${said}`)))
  }

  return {
    element,
    show({ best }) {
      if (!best) return
      const said = inWords(best)
      words.textContent = said
      const entries: [string, string][] = [
        ['leak as planned', withUnit(best.leak_mm2, 'mm²')],
        ['cost so far', withUnit(best.cost, 'mm²', 2)],
        ['closed', best.nodes === 1 ? 'as planned' : `with ${counted(best.nodes, 'small error')} of execution`],
      ]
      figures.replaceChildren(...entries.map(([name, value]) => h('div', {}, h('dt', {}, name), h('dd', {}, value))))
      const plan = JSON.stringify(best.plan)
      if (plan === shown || performance.now() - drawn < PICTURE_PAUSE_MS) return
      picture(best.plan, said)
      shown = plan
      drawn = performance.now()
    },
  }
}

function caption(title: string, photo: HTMLElement): HTMLElement {
  return h('figure', { class: searchStyle.captioned }, h('figcaption', {}, title), photo)
}
