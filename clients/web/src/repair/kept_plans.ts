// Plans that were kept: named, scored over small errors of execution, saved, loaded, taken up again.
import { report } from '../api/calls'
import { ApiError } from '../api/http'
import type { RankedPlan } from '../api/types'
import { button, download, filePicker, h } from '../dom'
import { leakInFull } from '../estimate'
import { counted, percent } from '../format'
import { iconButton } from '../icons'
import { HAS_SERVICE } from '../mode'
import { leakOf } from '../search/figures'
import { problemList } from '../problems'
import type { KeptPlan } from '../state/kept_plans'
import { nameOfValve } from '../state/valves'
import { problemsOf, type Workspace } from '../workspace'
import { planFile, plansIn } from './plan_files'
import { bestOf, REGION_POINTS, scorePlans, warningsOf } from './scores'
import { describe } from './steps'
import parts from '../style/parts.module.css'
import repairStyle from './repair.module.css'

export class KeptPlans {
  readonly element = h('section', { class: parts.panel, 'aria-label': 'Kept plans' })
  private readonly list = h('div', {})
  private readonly best = h('p', { class: repairStyle.best, role: 'status' })
  private readonly said = h('p', { class: parts.hint, 'aria-live': 'polite' })
  private readonly progress = h('progress', { max: 1, hidden: true, 'aria-label': 'Plans scored' })
  private readonly problems = h('div', {})
  private readonly scores = new Map<string, RankedPlan>() // by the kept plan's id
  private shown = ''
  private readonly scoring = button('Score plans', () => void this.score(), {
    title: `${REGION_POINTS} closures each, with small errors of execution`,
  })

  constructor(private readonly workspace: Workspace) {
    this.element.append(
      h('h2', {}, 'Kept plans'),
      this.best,
      this.progress,
      this.said,
      this.problems,
      this.list,
      h(
        'p',
        { class: parts.row },
        this.scoring,
        button('Save plans', () => download('plans.json', planFile(this.workspace.kept))),
        filePicker('Plans to load', 'Load plans', { accept: '.json', use: ([file]) => void this.load(file) }),
      ),
      ...(HAS_SERVICE ? [] : [h('p', { class: parts.hint }, 'Reports require coapt-server.')]),
    )
  }

  /// The list is made anew when it has changed alone: a name in it may be in use.
  update(): void {
    const { kept, valve } = this.workspace
    const key = JSON.stringify([kept, valve?.reference, [...this.scores.keys()]])
    if (key === this.shown) return
    this.shown = key
    this.scoring.disabled = this.ofValve().length === 0
    this.tellBest()
    this.list.replaceChildren(
      kept.length === 0
        ? h('p', { class: parts.hint }, 'Keep a repair to compare and score it here.')
        : h('ol', { class: repairStyle.kept }, ...kept.map((plan) => this.item(plan))),
    )
  }

  private ofValve(): KeptPlan[] {
    return this.workspace.kept.filter(({ valve }) => valve === this.workspace.valve?.reference)
  }

  private tellBest(): void {
    const kept = this.ofValve()
    const best = bestOf(kept.map(({ id }) => this.scores.get(id)))
    const score = best === null ? undefined : this.scores.get(kept[best]?.id ?? '')
    this.best.textContent =
      best === null || !score ? '' : `Best: ${kept[best]?.name ?? ''}. Leak ${leakInFull(leakOf(score))}.`
  }

  private item(kept: KeptPlan): HTMLElement {
    const score = this.scores.get(kept.id)
    const warnings = score ? warningsOf(score) : []
    const name = h('input', {
      type: 'text',
      class: parts.name,
      value: kept.name,
      title: 'Change the name',
      'aria-label': `Name of ${kept.name}`,
      onchange: () => void this.try(() => this.workspace.rename(kept, name.value.trim() || kept.name)),
    })
    return h(
      'li',
      {},
      h(
        'div',
        { class: repairStyle.head },
        name,
        iconButton('remove', `Remove ${kept.name}`, () => void this.try(() => this.workspace.forget(kept))),
      ),
      kept.valve !== this.workspace.valve?.reference && h('p', { class: parts.hint }, `for ${nameOfValve(kept.valve)}`),
      h('p', { class: parts.hint }, kept.plan.steps.map(describe).join('; ')),
      score
        ? h('p', {}, `Leak ${leakInFull(leakOf(score))}; below 5 mm² in ${percent(score.leak_mm2.below_5)} of closures`)
        : h('p', { class: parts.hint }, 'Not scored.'),
      warnings.length > 0 && h('ul', { class: parts.warn }, ...warnings.map((warning) => h('li', {}, warning))),
      h(
        'p',
        { class: parts.row },
        button('Revise', () => void this.try(() => this.workspace.revise(kept)), {
          'aria-label': `Revise ${kept.name}`,
        }),
        HAS_SERVICE &&
          button('Report', () => void this.report(kept), {
            title: 'Report of this plan (HTML) to read, print and share',
            'aria-label': `Report on ${kept.name}`,
          }),
      ),
    )
  }

  private async score(): Promise<void> {
    const { valve } = this.workspace
    const kept = this.ofValve()
    if (!valve || kept.length === 0) return
    this.scoring.disabled = true
    this.progress.hidden = false
    await this.try(async () => {
      const scores = await scorePlans(
        valve.reference,
        kept.map(({ plan }) => plan),
        (done) => {
          this.progress.value = done / kept.length
          this.said.textContent = `closing ${kept[done]?.name ?? ''} ${REGION_POINTS} times; ${done} of ${kept.length} plans are scored`
        },
      )
      scores.forEach((score, i) => {
        if (score) this.scores.set(kept[i]?.id ?? '', score)
      })
    })
    this.progress.hidden = true
    this.said.textContent = ''
    this.shown = ''
    this.update()
  }

  private async report({ name, plan, valve }: KeptPlan): Promise<void> {
    this.said.textContent = `closing ${name} ${REGION_POINTS} times, and with errors of single sutures ...`
    const page = (evidence: boolean) => report(valve, [plan], REGION_POINTS, evidence)
    await this.try(async () => {
      download(`${name}.html`, await page(true).catch(() => page(false))) // of a fine mesh it is too much for the service
    })
    this.said.textContent = ''
  }

  private async load(chosen: File | undefined): Promise<void> {
    if (!chosen) return
    try {
      const found = plansIn(await chosen.text())
      for (const { name, plan, valve } of found) {
        const source = valve ? { reference: valve, label: nameOfValve(valve) } : this.workspace.valve
        await this.workspace.keep(name ?? chosen.name, plan, source)
      }
      this.problems.replaceChildren()
      this.said.textContent = `${counted(found.length, 'plan')} loaded from ${chosen.name}.`
    } catch (error) {
      const isRefused = error instanceof ApiError
      this.said.textContent = isRefused
        ? `${chosen.name} cannot be kept for this valve.`
        : `${chosen.name} cannot be read: ${problemsOf(error)[0]?.message ?? ''}.`
      this.problems.replaceChildren(problemList(isRefused ? problemsOf(error) : []))
    }
  }

  /// What goes wrong is said.
  private async try(does: () => Promise<unknown>): Promise<void> {
    try {
      await does()
      this.problems.replaceChildren()
    } catch (error) {
      this.problems.replaceChildren(problemList(problemsOf(error)))
    }
  }
}
