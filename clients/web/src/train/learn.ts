// Instruction (thesis 3.2.3, 3.2.4): one case whose segments are named, with the annular plane, a cut, strain in colour, longer
// arrows; each exemplar is shown being pulled, then pulled by the learner.
import { button, field, h } from '../dom'
import { number } from '../format'
import { LiveCanvas } from '../live/canvas'
import { HookPanel, lookControls, Pressure } from '../live/controls'
import { EchoPanel } from '../echo/panel'
import { cutPoint } from '../live/drawing'
import { liveLegend } from '../live/legend'
import { liveScripts } from '../live/scripting'
import { problemList } from '../problems'
import { viewButtons } from '../valve/looks'
import { namesAround } from '../viewer/marks'
import { problemsOf } from '../workspace'
import { offer } from '../shell/scripting'
import parts from '../style/parts.module.css'
import viewerStyle from '../viewer/viewer.module.css'
import trainStyle from './train.module.css'
import type { TrainEngine } from './engine'
import { exemplars } from './exemplars'
import { Frame, panel } from './frame'
import { ShownPull } from './shown_pull'
import type { CaseB } from './types'

const AMPLIFIED = 3
const FIRST_CASE = 3 // of human-normal it is made in a few seconds

export class Learn {
  readonly element: HTMLElement
  private readonly frame = new Frame()
  private readonly canvas = new LiveCanvas({
    label: 'Practice valve: press and drag it; Enter grabs the centre, arrow keys rotate it, plus and minus zoom',
    view: 'oblique',
    isFixed: false,
    look: { strain: true, prolapse: true, plane: true, cut: null },
  })
  private readonly pressure = new Pressure((mmhg) => this.press(mmhg))
  private readonly hooks = new HookPanel(this.canvas)
  private readonly pull = new ShownPull(this.canvas)
  private readonly echo = new EchoPanel()
  private readonly examples = h('div', { 'data-part': 'exemplars' })
  private readonly legend = h('div', {})
  private readonly told = h('div', {})
  private readonly seed = h('input', {
    type: 'number',
    min: 1,
    max: 1e6,
    value: FIRST_CASE,
    onchange: () => void this.open(),
  })
  private shown = '' // valve and seed
  private made: CaseB | null = null
  private isPressed = false

  /// `valve`: of which cases are made.
  constructor(
    private readonly engine: TrainEngine,
    private readonly valve: () => string,
    back: HTMLElement,
  ) {
    const { look } = this.canvas
    this.canvas.onFailure = (message) => this.told.replaceChildren(problemList(problemsOf(new Error(message))))
    const redraw = (): void => {
      this.legend.replaceChildren(liveLegend(look))
      this.canvas.redraw()
    }
    redraw()
    const amplify = h('input', {
      type: 'checkbox',
      onchange: () => {
        look.amplified = amplify.checked ? AMPLIFIED : 1
        redraw()
      },
    })
    const looks = lookControls(look, redraw)
    looks.append(h('label', { class: parts.check }, amplify, `Force arrows ${AMPLIFIED} times as long`))
    const stage = h(
      'div',
      { class: trainStyle.learn },
      h(
        'div',
        { class: viewerStyle.tools },
        viewButtons((view) => this.canvas.view(view)),
      ),
      this.canvas.element,
      this.legend,
    )
    this.element = this.frame.element
    this.frame.show(
      'Learn',
      'Pull each free edge towards the atrium. Note how far it rises and how much force it takes.',
      stage,
      [
        panel('Examples', this.told, this.examples, field('Case', this.seed)),
        panel('Press and pull', this.pressure.element, this.hooks.element),
        looks,
        this.echo.element,
        back,
      ],
    )
  }

  show(): void {
    offer({ live: liveScripts(this.canvas, (mmhg) => this.pressure.set(mmhg)) })
    this.canvas.show()
    void this.open()
  }
  hide(): void {
    this.pull.end()
    this.canvas.hide()
  }

  /// Another case than that which stands in its field.
  take(seed: number): void {
    this.seed.value = String(seed)
    void this.open()
  }

  private async open(): Promise<void> {
    const [valve, seed] = [this.valve(), Math.max(1, Math.round(Number(this.seed.value)) || 1)]
    const asked = `${seed} ${valve}`
    if (asked === this.shown) return
    this.shown = asked
    this.engine.drop() // the case that was asked for before
    this.examples.removeAttribute('data-case')
    this.told.replaceChildren('A case is being made, which takes some seconds.')
    try {
      const made = await this.engine.make(valve, 'B', seed)
      const live = await this.canvas.start(JSON.stringify(made.valve), null, 0)
      if (asked !== this.shown) return
      this.made = made
      this.isPressed = false
      this.pressure.begin(live)
      this.pressure.set(0)
      const { look } = this.canvas
      this.canvas.onPicture = (picture) => {
        this.hooks.tell(picture, live)
        this.pull.follow(picture)
        this.echo.tell(live.scene, [picture.nodes], cutPoint(live.scene, look.cut ?? 0), picture.at_rest)
      }
      this.pull.set(live.scene.plane.normal, made.limits.pull_n)
      this.tell(made)
      const chosen = exemplars(made)
      this.canvas.name(
        namesAround(live.scene, (segment) => {
          const found = chosen.find((truth) => truth.segment === segment)
          return found ? `${segment} ${found.mobility}` : segment
        }),
      )
      this.told.replaceChildren()
    } catch (error) {
      if (asked !== this.shown) return
      this.shown = ''
      this.told.replaceChildren(problemList(problemsOf(error)))
    }
  }

  /// Papillary tips are where pressure has them, or where they are in an arrested heart.
  private press(mmhg: number): void {
    if (this.made && this.isPressed !== mmhg > 0) {
      this.isPressed = mmhg > 0
      const valve = this.isPressed ? this.made.pressed_valve : this.made.valve
      this.canvas.change(JSON.stringify(valve), null).catch(() => {}) // said by onFailure
    }
    this.canvas.setPressure(mmhg)
  }

  private tell(made: CaseB): void {
    const rows = exemplars(made).map(({ segment, mobility, height_mm, normal_mm }) =>
      h(
        'li',
        {},
        h('strong', {}, `${segment} is ${mobility}`),
        `: when pulled with ${made.limits.pull_n} N, its free edge is ${heightWords(height_mm)} the annular plane, without lesions ${heightWords(normal_mm)} it.`,
        h(
          'p',
          { class: parts.row },
          button('Show', () => this.pull.begin(segment), { 'aria-label': `Show how ${segment} is pulled` }),
          button('Grab', () => this.grab(segment), { 'aria-label': `Grab the free edge of ${segment}` }),
        ),
      ),
    )
    this.examples.setAttribute('data-case', String(made.seed))
    this.examples.replaceChildren(h('ul', { class: trainStyle.exemplars }, ...rows))
  }

  private grab(segment: string): void {
    this.pull.end()
    this.canvas.hooks.releaseAll()
    this.canvas.grabEdge(segment)
  }
}

/// "3.1 mm below"
function heightWords(height_mm: number): string {
  return `${number(Math.abs(height_mm))} mm ${height_mm < 0 ? 'below' : 'above'}`
}
