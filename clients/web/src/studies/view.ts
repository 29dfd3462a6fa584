// The thesis's studies of the open valve.
import { h } from '../dom'
import { JobView, type JobKind } from '../jobs/job_view'
import type { View } from '../view'
import type { Workspace } from '../workspace'
import { studyForm } from './form'
import { studyPanel } from './job_panel'
import parts from '../style/parts.module.css'

export class StudiesView implements View {
  readonly element: HTMLElement
  private readonly jobs: JobView

  constructor(workspace: Workspace) {
    const studies: JobKind = {
      kind: 'study',
      path: '/v1/studies',
      member: 'study',
      earlier: 'Earlier studies',
      another: 'New study and earlier ones',
      form: studyForm,
      note: (study) => String(study.name),
      outcome: () => null, // the service's list does not tell
      empty: empty(),
      panel: studyPanel,
    }
    this.jobs = new JobView(workspace, studies)
    this.element = this.jobs.element
  }

  show(): void {
    void this.jobs.show()
  }
  hide(): void {}
}

function empty(): HTMLElement {
  return h(
    'div',
    {},
    h('h1', {}, 'Studies'),
    h(
      'div',
      { class: parts.panel },
      h(
        'p',
        {},
        'The studies of the thesis “Fast Surgical Simulation to Improve Mitral Valve Repair”, repeated on this valve: ' +
          'each finding of the thesis is compared with this valve.',
      ),
      h('p', {}, 'The annulus study takes seconds; all studies take about a minute on two cores.'),
    ),
  )
}
