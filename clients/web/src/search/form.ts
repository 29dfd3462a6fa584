// The options of a search, each with what the service says against it.
import { rings } from '../api/calls'
import type { Plan, Problem } from '../api/types'
import { button, field, h } from '../dom'
import type { Asked, JobForm } from '../jobs/job_view'
import { problemList } from '../problems'
import * as options from './options'
import jobsStyle from '../jobs/jobs.module.css'
import parts from '../style/parts.module.css'

export function searchForm(start: (search: Asked) => void): JobForm {
  const inputs = new Map<options.NumberOption, HTMLInputElement>()
  const switches = new Map<options.Switch, HTMLInputElement>()
  const kinds = new Map<string, HTMLInputElement>()
  const slots = new Map<string, HTMLElement>() // pointer -> where its problems are shown
  const rest = h('div', {})
  const valve = h('strong', {}, 'opening ...')
  const steps = h('span', { class: parts.unit })
  const fixed = h('input', { type: 'checkbox', disabled: true })
  const go = h('button', { type: 'submit', class: parts.primary }, 'Start the search')
  let plan: Plan | null = null

  function slot(pointer: string): HTMLElement {
    const place = h('div', {})
    slots.set(pointer, place)
    return place
  }

  function numberField(option: options.NumberOption): HTMLElement {
    const input = h('input', {
      type: 'number',
      min: option.least,
      max: option.most,
      step: option.step === 1 ? 1 : 'any',
      value: option.fallback,
      placeholder: option.fallback === null ? 'no limit' : String(option.fallback),
    })
    inputs.set(option, input)
    return h(
      'div',
      { class: jobsStyle.option, 'data-part': 'option' },
      field(option.label, input, option.unit),
      option.hint && h('p', { class: parts.hint }, option.hint),
      slot(option.pointer),
    )
  }

  function switchField(option: options.Switch): HTMLElement {
    const input = h('input', { type: 'checkbox', checked: option.fallback })
    switches.set(option, input)
    return h(
      'div',
      { class: jobsStyle.option, 'data-part': 'option' },
      check(option.label, input),
      option.hint && h('p', { class: parts.hint }, option.hint),
      slot(option.pointer),
    )
  }

  function techniqueFields(technique: options.Technique): HTMLElement {
    const boxes = technique.kinds.map(([word, label]) => {
      const input = h('input', { type: 'checkbox', checked: true })
      kinds.set(word, input)
      return check(label, input)
    })
    return h('fieldset', {}, h('legend', {}, technique.title), ...boxes)
  }

  const allowed = h('div', {})
  rings().then(
    (answer) =>
      allowed.replaceChildren(...options.techniques(answer.rings.map((ring) => ring.name)).map(techniqueFields)),
    () => allowed.replaceChildren(...options.techniques([]).map(techniqueFields)),
  )

  const element = h(
    'form',
    {
      class: `${parts.panel} ${jobsStyle.form}`,
      'data-part': 'form',
      'aria-label': 'Options of a search',
      novalidate: true,
    },
    h('h2', {}, 'Search for repairs of ', valve),
    ...options.BUDGET.map(numberField),
    switchField(options.EVIDENCE),
    h(
      'div',
      { class: jobsStyle.option, 'data-part': 'option' },
      check('Keep the steps tried by hand', fixed),
      steps,
      slot('/rules/fixed'),
    ),
    section('Stop early', ...options.STOPS.map(numberField)),
    section(
      'Allowed',
      allowed,
      h('fieldset', {}, h('legend', {}, 'Chordae'), ...options.CHORDAL_STEPS.map(switchField)),
      slot('/rules/forbidden'),
    ),
    section('Limits of the steps', ...options.LIMITS.map(numberField)),
    section(
      'Weights',
      h('p', { class: parts.hint }, 'Each weight is a cost in mm² of leak.'),
      ...options.WEIGHTS.map(numberField),
    ),
    rest,
    h('div', { class: parts.row }, go, button('Defaults', reset, { class: parts.quiet })),
  )
  element.addEventListener('submit', (event) => {
    event.preventDefault()
    start(options.searchOf(choices()))
  })

  function choices(): options.Choices {
    return {
      numbers: new Map([...inputs].map(([option, input]) => [option, input.value === '' ? null : Number(input.value)])),
      switches: new Map([...switches].map(([option, input]) => [option, input.checked])),
      forbidden: [...kinds].filter(([, input]) => !input.checked).map(([word]) => word),
      fixed: fixed.checked ? plan : null,
    }
  }

  function reset(): void {
    element.reset()
    complain([])
  }

  function complain(problems: Problem[]): void {
    const pointers = [...slots.keys()]
    const placed = (pointer: string | null) =>
      problems.filter((problem) => options.placeOf(problem, pointers) === pointer)
    for (const [pointer, place] of slots) {
      const of = placed(pointer)
      place.replaceChildren(...(of.length > 0 ? [problemList(of)] : []))
      if (of.length > 0) place.closest('details')?.setAttribute('open', '')
    }
    const others = placed(null)
    rest.replaceChildren(...(others.length > 0 ? [problemList(others)] : []))
    element.querySelector('[data-part=problems]')?.scrollIntoView({ block: 'nearest' })
  }

  return {
    element,
    show(label, present) {
      valve.textContent = label ?? 'opening ...'
      plan = present
      const count = present.steps.length
      fixed.disabled = count === 0
      if (count === 0) fixed.checked = false
      steps.textContent =
        count === 0
          ? 'The present plan has no steps.'
          : `Every plan contains the ${count === 1 ? 'step' : `${count} steps`} of the present plan.`
    },
    complain,
    busy(is) {
      go.disabled = is
    },
  }
}

function check(label: string, input: HTMLInputElement): HTMLElement {
  return h('label', { class: parts.check }, input, h('span', {}, label))
}

function section(title: string, ...fields: HTMLElement[]): HTMLElement {
  return h('details', { class: parts.more }, h('summary', {}, title), ...fields)
}
