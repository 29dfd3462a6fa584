// Two valves, or one under two plans, beside each other; who turns one turns the other.
import { drawScene } from '../api/calls'
import type { Plan } from '../api/types'
import { h } from '../dom'
import { hasRing } from '../repair/steps'
import { leakWords } from '../valve/headline'
import { Viewer } from './viewer'
import viewerStyle from './viewer.module.css'

const LOOK = { mode: 'leaflets', scale: null, share: 1, leak: true, names: true, hours: false, cut: null } as const

export interface Compared {
  name: string
  reference: string
  plan: Plan | null
}

export interface SideBySide {
  element: HTMLElement
  show(both: readonly Compared[]): Promise<void> // two
}

export function sideBySide(): SideBySide {
  const viewers = ['first', 'second'].map((which) => new Viewer(`The ${which} compared valve`)) as [Viewer, Viewer]
  const captions = viewers.map(() => h('figcaption', {}))
  viewers[0].stage.pair(viewers[1].stage)
  const element = h(
    'section',
    { class: viewerStyle.compared, 'aria-label': 'Compared', 'data-part': 'compared' },
    ...viewers.map((viewer, i) => h('figure', {}, captions[i], viewer.element)),
  )
  let asked = 0
  return {
    element,
    async show(both) {
      const mine = ++asked
      const scenes = await Promise.all(both.map(({ reference, plan }) => drawScene(reference, plan, 0)))
      if (mine !== asked) return
      for (const [i, viewer] of viewers.entries()) {
        const scene = scenes[i]
        const caption = captions[i]
        if (!scene || !caption) continue
        caption.textContent = `${both[i]?.name}: ${leakWords(scene.closure)}`
        viewer.set(scene, LOOK, hasRing(both[i]?.plan ?? null))
      }
    },
  }
}
