// Two valves beside each other; who turns one turns the other.
import { drawScene } from '../api/calls'
import { h } from '../dom'
import { leakWords } from '../valve/headline'
import { Viewer } from '../viewer/viewer'
import type { Row } from './rows'
import cohortStyle from './cohort.module.css'

const LOOK = { mode: 'leaflets', scale: null, share: 1, leak: true, names: true, hours: false, cut: null } as const

export interface SideBySide {
  element: HTMLElement
  show(rows: Row[]): Promise<void> // two
}

export function sideBySide(): SideBySide {
  const viewers = ['first', 'second'].map((which) => new Viewer(`The ${which} compared valve`)) as [Viewer, Viewer]
  const captions = viewers.map(() => h('figcaption', {}))
  viewers[0].stage.pair(viewers[1].stage)
  const element = h(
    'section',
    { class: cohortStyle.compared, 'aria-label': 'Compared', 'data-part': 'compared' },
    ...viewers.map((viewer, i) => h('figure', {}, captions[i], viewer.element)),
  )
  let asked = 0
  return {
    element,
    async show(rows) {
      const mine = ++asked
      const scenes = await Promise.all(rows.map(({ reference }) => drawScene(reference, null, 0)))
      if (mine !== asked) return
      for (const [i, viewer] of viewers.entries()) {
        const scene = scenes[i]
        const caption = captions[i]
        if (!scene || !caption) continue
        caption.textContent = `${rows[i]?.name}: ${leakWords(scene.closure)}`
        viewer.set(scene, LOOK)
      }
    },
  }
}
