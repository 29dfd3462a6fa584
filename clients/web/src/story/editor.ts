// Writing a story: each slide records what the page shows, and its words. What is written stands in the address at once, so that the link is the story.
import { button, download, field, filePicker, h, select } from '../dom'
import { problemList } from '../problems'
import { viewTitle } from '../shell/views'
import type { View } from '../view'
import type { Workspace } from '../workspace'
import { problemsOf } from '../workspace'
import { SEGMENTS } from '../viewer/marks'
import { FIGURE_LIST } from './figures'
import { CAMERAS, encodeStory, EXPECTED, problemsOfStory, readStory, StoryFault, TOLD_VIEWS } from './story'
import type { Slide, Story } from './types'
import parts from '../style/parts.module.css'
import storyStyle from './story.module.css'

const LIFT_MM = { min: -20, max: 20, value: 6 }
const NONE = ''
const RECORDED = 'recorded' // camera
type Change = { [Field in keyof Slide]?: Slide[Field] | undefined }

/// `shown`: the view in the page.
export function storyEditor(
  workspace: Workspace,
  shown: () => { name: string; view: View | null },
): { element: HTMLElement; follow(story: Story, slide: number): void } {
  let story: Story | null = null
  let slide = 0
  const told = h('div', {})
  const said = h('span', { role: 'status', class: parts.hint })
  const called = h('input', { type: 'text', onchange: () => change((to) => (to.title = called.value)) })
  const title = h('input', { type: 'text', onchange: () => set({ title: title.value }) })
  const text = h('textarea', { onchange: () => set({ text: text.value }) })
  const figure = select(
    [[NONE, 'Insert a figure'], ...FIGURE_LIST.map(([name, about]) => [name, about] as const)],
    NONE,
    (name) => {
      text.setRangeText(`{${name}}`, text.selectionStart, text.selectionEnd, 'end')
      figure.value = NONE
      set({ text: text.value })
    },
  )
  figure.setAttribute('aria-label', 'Insert a figure')
  const camera = select([[NONE, 'unchanged']], NONE, (name) => {
    if (name !== RECORDED) set({ camera: CAMERAS.find((known) => known === name) })
  })
  const expect = select(
    [
      [NONE, 'does not depend on the leak'],
      ['leaks', 'assumes that the valve leaks'],
      ['closed', 'assumes that the valve closes'],
    ],
    NONE,
    (name) => set({ expect: EXPECTED.find((known) => known === name) }),
  )
  const pulled = select([[NONE, 'nothing'], ...SEGMENTS.map((name) => [name, name] as const)], NONE, () => pull())
  const lift = h('input', { type: 'number', ...LIFT_MM, step: 1, 'aria-label': 'Lift, mm', onchange: () => pull() })
  const vary = select([[NONE, 'no step']], NONE, (step) => set({ vary: step ? Number(step) : undefined }))
  const element = h(
    'div',
    { class: storyStyle.editor, role: 'group', 'aria-label': 'Write the story' },
    h(
      'div',
      {},
      field('Story', called),
      field('Slide', title),
      h('label', {}, h('span', { class: parts.unseen }, 'Words of the slide'), text),
      h('p', { class: parts.row }, figure),
    ),
    h(
      'div',
      {},
      h(
        'p',
        { class: parts.row },
        button('Record this page', () => set(recorded()), { title: 'Current view, valve, plan and camera' }),
        button('Add a slide', () =>
          change((to) => to.slides.splice(slide + 1, 0, { ...recorded(), title: 'Next', text: '{leak}' }), 1),
        ),
        button('Remove', () => change((to) => to.slides.splice(slide, 1), -1), { 'aria-label': 'Remove this slide' }),
        button('Earlier', () => move(-1), { 'aria-label': 'Move this slide earlier' }),
        button('Later', () => move(1), { 'aria-label': 'Move this slide later' }),
      ),
      field('Seen from', camera),
      field('The text', expect),
      field('Live: pull', pulled),
      field('Lift', lift, 'mm'),
      field('Repair: vary', vary),
      h(
        'p',
        { class: parts.row },
        button('Copy the link', () => void copy()),
        button('Save file', () => save()),
        filePicker('Story file', 'Open file', { accept: '.json', use: ([file]) => void open(file) }),
        said,
      ),
    ),
    told,
  )

  function follow(shown: Story, at: number): void {
    story = shown
    slide = at
    const present = shown.slides[at]
    if (!present) return
    for (const [input, value] of [
      [called, shown.title],
      [title, present.title],
      [text, present.text],
      [expect, present.expect ?? NONE],
      [pulled, present.pull?.segment ?? NONE],
      [lift, String(present.pull?.lift_mm ?? LIFT_MM.value)],
    ] as const)
      if (document.activeElement !== input && input.value !== value) input.value = value
    const seen = typeof present.camera === 'object' ? RECORDED : (present.camera ?? NONE)
    const cameras = [[NONE, 'unchanged'], ...CAMERAS.map((name) => [name, name])]
    if (seen === RECORDED) cameras.push([RECORDED, 'as recorded'])
    camera.replaceChildren(...cameras.map(([value, words]) => h('option', { value }, words)))
    camera.value = seen
    const steps = (present.steps ?? []).map((_, i) => String(i + 1))
    vary.replaceChildren(
      ...[NONE, ...steps].map((step) => h('option', { value: step }, step === NONE ? 'no step' : `step ${step}`)),
    )
    vary.value = String(present.vary ?? NONE)
  }

  /// The page as it is.
  function recorded(): Required<Pick<Slide, 'view' | 'valve' | 'steps'>> & Pick<Slide, 'camera'> {
    const { name, view } = shown()
    const told = TOLD_VIEWS.find((known) => known === name)
    if (!told || !workspace.valve) throw new Error(`A story shows the views ${TOLD_VIEWS.map(viewTitle).join(', ')}.`)
    const { steps } = workspace.plan
    return {
      view: told,
      valve: workspace.valve.reference,
      steps: [...steps],
      ...(view?.sight && { camera: view.sight }),
    }
  }

  function set(some: Change): void {
    change((to) => Object.assign(to.slides[slide] as Slide, some))
  }

  function pull(): void {
    const segment = SEGMENTS.find((name) => name === pulled.value)
    set({ pull: segment && { segment, lift_mm: Number(lift.value) } })
  }

  function move(way: 1 | -1): void {
    change((to) => to.slides.splice(slide + way, 0, ...to.slides.splice(slide, 1)), way)
  }

  /// What is wrong is said, and nothing is changed then.
  function change(apply: (story: Story) => unknown, way = 0): void {
    if (!story) return
    try {
      const next = structuredClone(story)
      apply(next)
      const written = JSON.parse(JSON.stringify(next)) as Story // without fields that are undefined
      const problems = problemsOfStory(written)
      told.replaceChildren(problemList(problems))
      if (problems.length === 0) void show(written, Math.min(Math.max(slide + way, 0), written.slides.length - 1))
    } catch (error) {
      told.replaceChildren(problemList(problemsOf(error)))
    }
  }

  async function show(written: Story, at: number): Promise<void> {
    story = written
    slide = at
    workspace.tell({ reference: await encodeStory(written), slide: at })
  }

  async function copy(): Promise<void> {
    const words = await navigator.clipboard.writeText(location.href).then(
      () => 'The link was copied; it contains the story.',
      () => 'The browser does not allow copying; use the address of this page as the link.',
    )
    said.textContent = words
  }

  function save(): void {
    if (story) download(`${story.name}.json`, new Blob([JSON.stringify(story, null, 2)], { type: 'application/json' }))
  }

  async function open(file: File | undefined): Promise<void> {
    if (!file) return
    try {
      told.replaceChildren()
      await show(readStory(await file.text()), 0)
    } catch (error) {
      told.replaceChildren(problemList(error instanceof StoryFault ? error.problems : problemsOf(error)))
    }
  }

  return { element, follow }
}
