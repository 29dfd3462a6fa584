// The closed valve breathes between soft and stiff leaflets; beside it how far the leak follows, and what to measure. Where the
// reader wants no motion, three buttons show soft, own and stiff leaflets.
import type { Information, Scene } from '../api/types'
import { h } from '../dom'
import { icon } from '../icons'
import { Viewer } from '../viewer/viewer'
import type { Workspace } from '../workspace'
import { narrowing } from './information'
import { breathing, spreadWords, stiffnessVariants, variantWords, type Variant } from './stiffness'
import { knownTissue } from './tissue_error'
import { valveQuestion } from './valve_question'
import parts from '../style/parts.module.css'
import valveStyle from './valve.module.css'

const BREATH_MS = 8000
const LOOK = { mode: 'leaflets', scale: null, leak: true, names: false, hours: false, cut: null } as const
const SHOWN_MS = 1000 // by then it is in the page; later it is in another view
const ON_THE_WAY = 0.999 // nothing of a leak is drawn

export function howSure(workspace: Workspace): HTMLElement {
  let breath: Breath | null = null // made when it is asked for: it has a canvas of its own
  const question = valveQuestion(workspace, {
    labels: ['How sure is the shape?'],
    busy: 'Closing with soft and stiff leaflets',
    ask: async ({ reference }, signal) => {
      const variants = await stiffnessVariants(reference, signal)
      breath ??= new Breath()
      const { before } = workspace
      breath.set(variants, before && knownTissue(before))
      return [breath.element]
    },
    style: undefined,
  })
  return h(
    'div',
    { 'data-part': 'how-sure' },
    h('p', { class: parts.row }, ...question.buttons, question.progress),
    question.answer,
  )
}

class Breath {
  readonly element = h('div', {})
  private readonly viewer = new Viewer('The closed valve with softer and stiffer leaflets')
  private readonly said = h('p', { 'data-part': 'variant' })
  private readonly label = h('span', {})
  private readonly play = h(
    'button',
    { type: 'button', class: parts.labelled, onclick: () => (this.started === null ? this.start() : this.stop()) },
    icon('animation'),
    this.label,
  )
  private variants: readonly Variant[] = []
  private whole: Scene | null = null
  private started: number | null = null // of the clock; null: it is still

  set(variants: readonly Variant[], drawn: Information | null): void {
    this.variants = variants
    this.whole = breathing(variants)
    const own = variants.reduce((best, one) =>
      Math.abs(Math.log(one.factor)) < Math.abs(Math.log(best.factor)) ? one : best,
    )
    const ends: [string, Variant][] = [
      ['Soft', variants[0] as Variant],
      ['Own', own],
      ['Stiff', variants.at(-1) as Variant],
    ]
    const isStill = matchMedia('(prefers-reduced-motion: reduce)').matches
    this.element.replaceChildren(
      h('div', { class: valveStyle.breath }, this.viewer.element),
      h(
        'p',
        { class: parts.row, role: 'group', 'aria-label': 'Stiffness of the leaflets' },
        ...ends.map(([name, variant]) => h('button', { type: 'button', onclick: () => this.show(variant) }, name)),
        !isStill && this.play,
      ),
      this.said,
      h('p', { class: parts.hint }, spreadWords(variants, drawn?.leak.tissue ?? null)),
      h('p', {}, drawn && narrowing(drawn)),
    )
    this.show(own)
    if (!isStill) this.start()
  }

  private show(variant: Variant): void {
    this.stop()
    this.viewer.set(variant.scene, { ...LOOK, share: 1 })
    this.said.textContent = variantWords(variant)
  }

  private start(): void {
    const { whole } = this
    if (!whole) return
    const started = performance.now()
    this.started = started
    this.label.textContent = 'Stop'
    this.viewer.set(whole, { ...LOOK, share: 0 })
    const step = (now: number): void => {
      if (this.started !== started) return
      if (!this.element.isConnected && now - started > SHOWN_MS) {
        this.stop()
        return
      }
      const share = 0.5 * (1 - Math.cos((2 * Math.PI * (now - started)) / BREATH_MS))
      this.viewer.show({ ...LOOK, share: Math.min(share, ON_THE_WAY) })
      const near = this.variants[Math.round(share * (this.variants.length - 1))]
      if (near) this.said.textContent = variantWords(near)
      requestAnimationFrame(step)
    }
    requestAnimationFrame(step)
  }

  private stop(): void {
    this.started = null
    this.label.textContent = 'Breathe'
  }
}
