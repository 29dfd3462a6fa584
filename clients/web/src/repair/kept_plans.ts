// Plans that were kept: loaded, saved, scored over small errors of execution, taken up again.
import { evaluate, report } from '../api/calls'
import type { Plan, RankedPlan } from '../api/types'
import { button, download, h } from '../dom'
import { number, percent, withUnit } from '../format'
import { doubts } from '../search/figures'
import { problemList } from '../problems'
import { problemsOf, type KeptPlan, type Workspace } from '../workspace'
import { describe } from './steps'

const REGION_POINTS = 65

export class KeptPlans {
  readonly element = h('section', { class: 'panel', 'aria-label': 'Kept plans' })
  private readonly list = h('div', {})
  private readonly said = h('p', { class: 'hint', 'aria-live': 'polite' })
  private readonly problems = h('div', {})
  private readonly scores = new Map<KeptPlan, RankedPlan>()
  private readonly file = h('input', { type: 'file', accept: '.json', class: 'unseen', tabindex: -1, 'aria-label': 'Plans to load', onchange: () => void this.load() })

  constructor(private readonly workspace: Workspace) {
    this.element.append(
      h('h2', {}, 'Kept plans'),
      this.list,
      h(
        'p',
        { class: 'row' },
        button('Score them', () => void this.score(), { title: `${REGION_POINTS} closures each over small errors of execution` }),
        button('Save plans', () => this.save()),
        button('Load plans', () => this.file.click()),
        this.file,
      ),
      this.said,
      this.problems,
    )
  }

  update(): void {
    const kept = this.workspace.kept
    if (kept.length === 0) {
      this.list.replaceChildren(h('p', { class: 'hint' }, 'Accept a repair and it is kept here, to be compared and scored.'))
      return
    }
    this.list.replaceChildren(h('ol', { class: 'kept' }, ...kept.map((plan) => this.item(plan))))
  }

  private item(kept: KeptPlan): HTMLElement {
    const score = this.scores.get(kept)
    const leak = score?.leak_mm2
    const warnings = score ? [...doubts(score), ...score.warnings] : []
    return h(
      'li',
      {},
      h('strong', {}, kept.name),
      kept.valve.reference !== this.workspace.valve?.reference && ` of ${kept.valve.label}`,
      h('p', { class: 'hint' }, kept.plan.steps.map(describe).join('; ')),
      leak
        ? h('p', {}, `Leak ${number(leak.mean)} ± ${withUnit(leak.sd, 'mm²')}, below 5 mm² in ${percent(leak.below_5)}`)
        : h('p', { class: 'hint' }, 'Not scored.'),
      warnings.length > 0 && h('ul', { class: 'warn' }, ...warnings.map((warning) => h('li', {}, warning))),
      h(
        'p',
        { class: 'row' },
        button('Report', () => void this.report(kept), { title: 'One page to read, print and hand on', 'aria-label': `Report on ${kept.name}` }),
        button('Revise', () => void this.revise(kept), { 'aria-label': `Revise ${kept.name}` }),
        button('Remove', () => this.workspace.forget(kept), { class: 'quiet', 'aria-label': `Remove ${kept.name}` }),
      ),
    )
  }

  /// Opens the plan's valve first, if another one is open.
  private async revise({ plan, valve }: KeptPlan): Promise<void> {
    try {
      if (valve.reference !== this.workspace.valve?.reference) await this.workspace.open(valve)
      await this.workspace.setPlan(plan.steps)
    } catch (error) {
      this.problems.replaceChildren(problemList(problemsOf(error)))
    }
  }

  private async score(): Promise<void> {
    const { valve } = this.workspace
    const kept = this.workspace.kept.filter((plan) => plan.valve.reference === valve?.reference)
    if (!valve || kept.length === 0) return this.say('There is no kept plan of this valve.')
    this.say(`closing each plan ${REGION_POINTS} times ...`)
    try {
      const { plans } = await evaluate(valve.reference, kept.map(({ plan }) => plan), REGION_POINTS)
      for (const scored of plans) {
        const plan = kept[scored.index]
        if (plan) this.scores.set(plan, scored)
      }
      const best = plans.find(({ rank }) => rank === 1)
      this.say(best ? `Best: ${kept[best.index]?.name ?? ''}.` : '')
      this.problems.replaceChildren()
    } catch (error) {
      this.say('They cannot be scored.')
      this.problems.replaceChildren(problemList(problemsOf(error)))
    }
    this.update()
  }

  private async report({ name, plan, valve }: KeptPlan): Promise<void> {
    this.say(`closing ${name} ${REGION_POINTS} times, and for evidence ...`)
    const page = (evidence: boolean) => report(valve.reference, [plan], REGION_POINTS, evidence)
    try {
      download(`${name}.html`, await page(true).catch(() => page(false))) // of a fine mesh it is too much for the service
      this.say('')
      this.problems.replaceChildren()
    } catch (error) {
      this.say(`There is no report on ${name}.`)
      this.problems.replaceChildren(problemList(problemsOf(error)))
    }
  }

  private save(): void {
    const plans = this.workspace.kept
    download('plans.json', new Blob([JSON.stringify({ plans }, null, 1)], { type: 'application/json' }))
  }

  /// A list as save() writes it, or one coapt.plan/1.
  private async load(): Promise<void> {
    const chosen = this.file.files?.[0]
    if (!chosen) return
    try {
      const found = plansIn(await chosen.text())
      if (!this.workspace.valve) throw new Error('open a valve first')
      for (const { name, plan, valve } of found) this.workspace.keep(name ?? chosen.name, plan, valve ?? this.workspace.valve)
      this.say(`${found.length} loaded from ${chosen.name}.`)
    } catch (error) {
      this.say(`${chosen.name} cannot be read: ${error instanceof Error ? error.message : ''}`)
    }
    this.file.value = ''
  }

  private say(words: string): void {
    this.said.textContent = words
  }
}

/// What save() has written, or one plan. Those that cannot be said in words are no plans.
export function plansIn(text: string): Partial<KeptPlan>[] & { plan: Plan }[] {
  const json = JSON.parse(text) as { plans?: Partial<KeptPlan>[] } & Partial<Plan>
  const entries = json.schema === 'coapt.plan/1' ? [{ plan: json as Plan }] : (json.plans ?? [])
  const plans = entries.filter((entry): entry is Partial<KeptPlan> & { plan: Plan } => isPlan(entry?.plan))
  if (plans.length === 0) throw new Error('it holds no plan (coapt.plan/1)')
  return plans
}

function isPlan(plan: Plan | undefined): boolean {
  try {
    return plan !== undefined && plan.steps.map(describe).every((words) => typeof words === 'string')
  } catch {
    return false
  }
}
