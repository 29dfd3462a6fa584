// The button that saves what is shown as a picture for a paper.
import type { Plan, Scene } from '../api/types'
import { download, h, select } from '../dom'
import { withUnit } from '../format'
import { iconButton } from '../icons'
import { problemList } from '../problems'
import { describe } from '../repair/steps'
import { leakPlace, leakWords } from '../valve/headline'
import { problemsOf } from '../workspace'
import { figureSvg, WIDTH_MM, type Figure } from './figure'
import { drawingAsPng, drawingAsSvg, pixelsOf } from './png'
import parts from '../style/parts.module.css'

const FORMATS = [
  ['png', 'PNG'],
  ['svg', 'SVG'],
] as const

/// `width_px`: how wide the pictures of the valve are to be, all together. What goes wrong is said in `told`.
export function pictureSaver(figure: (width_px: number) => Figure, told: HTMLElement): HTMLElement {
  let format: string = FORMATS[0][0]
  const formats = select(FORMATS, format, (chosen) => (format = chosen))
  formats.setAttribute('aria-label', 'Picture format')
  const press = iconButton('picture', 'Save picture', () => void save())
  async function save(): Promise<void> {
    press.disabled = true
    try {
      const shown = figure(pixelsOf(WIDTH_MM))
      const drawing = figureSvg(shown)
      download(
        `${shown.name}.${format}`,
        format === 'svg' ? drawingAsSvg(drawing) : await drawingAsPng(drawing, WIDTH_MM),
      )
      told.replaceChildren()
    } catch (error) {
      told.replaceChildren(problemList(problemsOf(error)))
    }
    press.disabled = false
  }
  return h('span', { class: parts.joined }, press, formats)
}

/// What a picture says of a closure, and of the repair that led to it.
export function figureLines(before: Scene, after: Scene | null, plan: Plan): string[] {
  const { closure } = after ?? before
  return [
    `Leak ${leakWords(before.closure, after?.closure)}${leakPlace(closure)}`,
    `Coaptation height ${withUnit(closure.coaptation.height_mean_mm, 'mm')} on average`,
    ...(after ? plan.steps.map((step, i) => `${i + 1}. ${describe(step)}`) : []),
  ]
}
