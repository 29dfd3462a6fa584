// The opening of the valve that is shown, asked for once its closure is there, and told in a line above what is measured.
import { openValve } from '../api/calls'
import type { Opening, Plan, Scene } from '../api/types'
import { h } from '../dom'
import { cm2, number } from '../format'
import { term } from '../help/term'
import valveStyle from './valve.module.css'

export class Diastole {
  readonly element = h('div', {})
  private scene: Scene | null = null // whose opening is told or asked for

  /// Of the valve `reference` with `plan`, whose closure is `scene`. Null: another one is asked for meanwhile, or it cannot be opened
  /// and nothing is told.
  async ask(scene: Scene, reference: string, plan: Plan | null, frames: number): Promise<Opening | null> {
    this.clear()
    this.scene = scene
    const opening = await openValve(reference, plan, frames).catch(() => null)
    if (this.scene !== scene || !opening) return null
    this.element.replaceChildren(...[diastoleWords(opening) ?? []].flat())
    return opening
  }

  isOf(scene: Scene | null): boolean {
    return this.scene === scene
  }

  clear(): void {
    this.scene = null
    this.element.replaceChildren()
  }
}

/// Nothing where it is not known.
function diastoleWords({ opening_area_mm2, gradient_mmhg, flow_ml_s }: Opening): HTMLElement | null {
  if (opening_area_mm2 === null) return null
  return h(
    'p',
    { class: valveStyle.headline, 'data-part': 'diastole' },
    h('span', { class: valveStyle.opening }, cm2(opening_area_mm2)),
    h(
      'span',
      { class: valveStyle.sure },
      term('opening', 'open in diastole'),
      ', ',
      term('gradient', 'mean gradient'),
      ` ${number(gradient_mmhg)} mmHg at ${number(flow_ml_s, 0)} ml/s`,
    ),
  )
}
