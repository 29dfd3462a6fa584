// Which study of the open valve, and how.
import type { Problem } from '../api/types'
import { field, h, select } from '../dom'
import type { Asked, JobForm } from '../jobs/job_view'
import { problemList } from '../problems'
import { DEFAULT_PROTOCOLS, hasAnchors, PROTOCOLS, STUDIES, studyOf, type StudyName } from './options'
import jobsStyle from '../jobs/jobs.module.css'
import parts from '../style/parts.module.css'
import studiesStyle from './studies.module.css'

export function studyForm(start: (study: Asked) => void): JobForm {
  let name: StudyName = 'annulus'
  let step_mm = 1
  const valve = h('strong', { class: parts.oneLine }, 'opening ...')
  const protocols = PROTOCOLS.map(([word, label]) => {
    const input = h('input', { type: 'checkbox', value: word, checked: DEFAULT_PROTOCOLS.includes(word) })
    return {
      input,
      label: h('label', { class: parts.check }, input, h('span', {}, h('strong', {}, word), `: ${label}`)),
    }
  })
  const points = h('input', { type: 'number', min: 17, max: 1089, placeholder: 'default' })
  const sites = h('input', { type: 'number', min: 0, max: 360, placeholder: 'default' })
  const slots = new Map(
    ['/study/protocols', '/study/displacement_step_mm', '/study/region_points', '/study/scan_sites'].map((pointer) => [
      pointer,
      h('div', {}),
    ]),
  )
  const rest = h('div', {})
  const steps = select(
    [1, 2, 3, 6].map((step): [string, string] => [String(step), String(step)]),
    '1',
    (chosen) => (step_mm = Number(chosen)),
  )
  const anchors = h(
    'div',
    { hidden: true },
    h(
      'fieldset',
      {},
      h('legend', {}, 'Orifice of each position'),
      ...protocols.map(({ label }) => label),
      slots.get('/study/protocols'),
    ),
    field('Displacements by', steps, 'mm'),
    slots.get('/study/displacement_step_mm'),
    field('Region points', points),
    slots.get('/study/region_points'),
    field('Anchors around the annulus', sites),
    slots.get('/study/scan_sites'),
  )
  const go = h('button', { type: 'submit', class: parts.primary }, 'Start the study')
  const which = select(STUDIES, name, (chosen) => {
    name = chosen as StudyName
    anchors.hidden = !hasAnchors(name)
  })
  const element = h(
    'form',
    {
      class: `${parts.panel} ${jobsStyle.form} ${studiesStyle.studyForm}`,
      'data-part': 'form',
      'aria-label': 'A study',
      novalidate: true,
    },
    h('h2', {}, 'Study ', valve),
    field('Study', which),
    anchors,
    rest,
    h('div', { class: parts.row }, go),
  )
  element.addEventListener('submit', (event) => {
    event.preventDefault()
    start(
      studyOf({
        name,
        protocols: protocols.filter(({ input }) => input.checked).map(({ input }) => input.value),
        displacement_step_mm: step_mm,
        region_points: numberOf(points),
        scan_sites: numberOf(sites),
      }),
    )
  })

  return {
    element,
    show: (label) => (valve.textContent = valve.title = label ?? 'opening ...'),
    complain(problems) {
      const at = (pointer: string) => problems.filter(({ path }) => `${path}/`.startsWith(`${pointer}/`))
      for (const [pointer, slot] of slots) slot.replaceChildren(...listOf(at(pointer)))
      const placed = [...slots.keys()].flatMap(at)
      rest.replaceChildren(...listOf(problems.filter((problem) => !placed.includes(problem))))
    },
    busy: (is) => (go.disabled = is),
  }
}

function listOf(problems: Problem[]): HTMLElement[] {
  return problems.length > 0 ? [problemList(problems)] : []
}

function numberOf(input: HTMLInputElement): number | null {
  return input.value === '' ? null : Number(input.value)
}
