// What images show of the closed valve besides its shape. The valve is stored with it, under the same name, and opened: its draws are
// weighed by it from then on.
import { observeValve, storeValve } from '../api/calls'
import type { Observed } from '../api/types'
import { button, field, h } from '../dom'
import { problemList } from '../problems'
import { nameValve, valveText } from '../state/valves'
import { problemsOf, type Workspace } from '../workspace'
import parts from '../style/parts.module.css'

type Figure = keyof Observed
const FIGURES: Record<Figure, readonly [name: string, unit: string]> = {
  leak_mm2: ['Regurgitant area', 'mm²'],
  widest_gap_mm: ['Widest gap', 'mm'],
  tenting_area_mm2: ['Tenting area', 'mm²'],
}
const NAMES = Object.keys(FIGURES) as Figure[]

export function observedPanel(workspace: Workspace, open: (id: string, name: string) => Promise<void>): HTMLElement {
  const inputs = NAMES.map((figure) => {
    const [name, unit] = FIGURES[figure]
    const value = numberInput(name)
    const sd = numberInput(`Standard deviation of the ${name.toLowerCase()}`)
    return { figure, value, sd, row: h('div', { class: parts.row }, field(name, value), h('span', {}, '±'), sd, unit) }
  })
  const problems = h('div', { 'aria-live': 'polite' })
  let shown: string | null = null // the valve whose figures are in the inputs
  workspace.subscribe(() => void follow())

  /// What was observed of the valve that is open.
  async function follow(): Promise<void> {
    const reference = workspace.valve?.reference ?? null
    if (reference === shown) return
    shown = reference
    problems.replaceChildren()
    const observed = reference === null ? {} : await observedOf(reference)
    if (reference !== shown) return
    for (const { figure, value, sd } of inputs) {
      value.value = String(observed[figure]?.value ?? '')
      sd.value = String(observed[figure]?.sd ?? '')
    }
  }

  async function use(): Promise<void> {
    const { valve } = workspace
    if (!valve) return
    const observed: Observed = {}
    for (const { figure, value, sd } of inputs)
      if (value.value !== '' || sd.value !== '') observed[figure] = { value: value.valueAsNumber, sd: sd.valueAsNumber }
    try {
      const id = await storeValve(await observeValve(valve.reference, observed))
      nameValve(id, valve.label)
      await open(id, valve.label)
    } catch (error) {
      problems.replaceChildren(problemList(problemsOf(error)))
    }
  }

  return h(
    'details',
    { class: parts.panel, 'data-part': 'observed' },
    h('summary', {}, 'What images show'),
    h(
      'p',
      { class: parts.hint },
      'Enter what was measured of this valve, each figure with its standard deviation. The range of the leak, and the plans of a search, then rest on tissue that agrees with it.',
    ),
    ...inputs.map(({ row }) => row),
    button('Use these figures', () => void use()),
    problems,
  )
}

const numberInput = (label: string): HTMLInputElement =>
  h('input', { type: 'number', step: 'any', 'aria-label': label })

async function observedOf(reference: string): Promise<Observed> {
  try {
    return (JSON.parse(await valveText(reference)) as { observed?: Observed }).observed ?? {}
  } catch {
    return {} // a valve that is gone has none
  }
}
