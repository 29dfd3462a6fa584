// What may be done on this valve, then how the search goes about it; each with what the service says against it.
import { rings } from '../api/calls'
import type { Plan, Problem } from '../api/types'
import { button, field, h, select, type Child } from '../dom'
import type { Asked, JobForm } from '../jobs/job_view'
import { placeInWords, problemList } from '../problems'
import * as options from './options'
import jobsStyle from '../jobs/jobs.module.css'
import parts from '../style/parts.module.css'

export function searchForm(start: (search: Asked) => void): JobForm {
  const inputs = new Map<options.NumberOption, HTMLInputElement>()
  const switches = new Map<options.Switch, HTMLInputElement>()
  const kinds = new Map<string, HTMLInputElement>()
  const slots = new Map<string, HTMLElement>() // pointer -> where its problems are shown
  const names = new Map<string, string>() // pointer -> what the field is called
  const rest = h('div', {})
  const valve = h('strong', { class: parts.oneLine }, 'opening ...')
  const keeps = h('span', {})
  const fixed = h('input', { type: 'checkbox', disabled: true })
  const go = h('button', { type: 'submit', class: parts.primary }, 'Start the search')
  const muscles = select(
    options.SUTURES.map(({ name, label }) => [name, label] as const),
    'both',
    () => {},
  )
  let plan: Plan | null = null

  function slot(pointer: string, name: string): HTMLElement {
    const place = h('div', {})
    slots.set(pointer, place)
    names.set(pointer, name)
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
    return optionField(option, field(option.label, input, option.unit))
  }

  function switchField(option: options.Switch): HTMLElement {
    const input = h('input', { type: 'checkbox', checked: option.fallback })
    switches.set(option, input)
    return optionField(option, check(option.label, input))
  }

  function optionField(option: options.NumberOption | options.Switch, control: HTMLElement): HTMLElement {
    return h(
      'div',
      { class: jobsStyle.option, 'data-part': 'option' },
      control,
      option.hint && h('p', { class: parts.hint }, option.hint),
      slot(option.pointer, option.label),
    )
  }

  function kindBox({ word, label, hint, title }: options.Kind): HTMLElement {
    const input = h('input', { type: 'checkbox', checked: true })
    kinds.set(word, input)
    return check(label, input, hint, title)
  }

  const shelf = h('div', {})
  const showRings = (found: { name: string; note: string }[]) =>
    shelf.replaceChildren(...options.ringKinds(found).map(kindBox))
  rings().then(
    (answer) => showRings(answer.rings),
    () => showRings([]),
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
    h('div', { class: parts.row }, go, button('Defaults', reset, { class: parts.quiet })),
    rest,
    group('Available rings', shelf, slot('/rules/forbidden', 'Techniques')),
    group(
      'Sutures and chordae',
      field('Papillary sutures', muscles),
      numberField(options.NEOCHORDAE),
      ...options.STEPS_ON_REQUEST.map(switchField),
    ),
    group(
      'Time and results',
      ...options.ANSWER.map(numberField),
      check(keeps, fixed),
      slot('/rules/fixed', 'Steps of the manual repair'),
    ),
    folded(
      'Limits of the steps',
      ...options.LIMITS.map(numberField),
      group('Sutures to', ...options.ANCHORS.map(kindBox)),
      group('Neochordae to', ...options.LEAFLETS.map(kindBox)),
    ),
    folded('Optimiser', ...options.OPTIMISER.map(numberField), switchField(options.EVIDENCE)),
    folded(
      'Weights of the cost',
      h('p', { class: parts.hint }, 'Plans are ranked by their cost. Weights are in mm² of leak.'),
      ...options.WEIGHTS.map(numberField),
    ),
  )
  element.addEventListener('submit', (event) => {
    event.preventDefault()
    start(options.searchOf(choices()))
  })

  function choices(): options.Choices {
    const sutures = options.SUTURES.find(({ name }) => name === muscles.value)
    const unticked = [...kinds].filter(([, input]) => !input.checked).map(([word]) => word)
    return {
      numbers: new Map([...inputs].map(([option, input]) => [option, input.value === '' ? null : Number(input.value)])),
      switches: new Map([...switches].map(([option, input]) => [option, input.checked])),
      forbidden: [...(sutures?.forbidden ?? []), ...unticked],
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
      place.replaceChildren(...(of.length > 0 ? [problemList(of, () => '', nameOf)] : []))
      if (of.length > 0) place.closest('details')?.setAttribute('open', '')
    }
    const others = placed(null)
    rest.replaceChildren(...(others.length > 0 ? [problemList(others)] : []))
    element.querySelector('[data-part=problems]')?.scrollIntoView({ block: 'nearest' })
  }

  /// What the page calls the field that a pointer leads to, where it leads to one.
  function nameOf(path: string): string {
    return names.get(path.replace('/search', '')) ?? placeInWords(path)
  }

  return {
    element,
    show(label, present) {
      valve.textContent = valve.title = label ?? 'opening ...'
      plan = present
      const count = present.steps.length
      fixed.disabled = count === 0
      if (count === 0) fixed.checked = false
      keeps.textContent =
        count === 0
          ? 'Include the steps of the manual repair (none yet)'
          : `Keep the ${count === 1 ? 'step' : `${count} steps`} of the manual repair in every plan`
    },
    complain,
    busy(is) {
      go.disabled = is
    },
  }
}

function check(label: string | HTMLElement, input: HTMLInputElement, hint = '', title = ''): HTMLElement {
  return h(
    'label',
    { class: parts.check, title: title || null },
    input,
    h('span', {}, label, hint && h('span', { class: parts.hint }, ` ${hint}`)),
  )
}

function group(title: string, ...children: Child[]): HTMLElement {
  return h('fieldset', {}, h('legend', {}, title), ...children)
}

function folded(title: string, ...children: Child[]): HTMLElement {
  return h('details', { class: parts.more }, h('summary', {}, title), ...children)
}
