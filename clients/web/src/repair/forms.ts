// The controls of one step. `change` gets the step as it is set; `passing` while a slider is dragged.
import type { LeafletPoint, Rings, Step } from '../api/types'
import { button, field, h, select } from '../dom'
import {
  ANCHORS,
  CHANGE_MM,
  EDGE_ALONG,
  EDGE_DEVICES,
  EDGE_MM,
  NEOCHORDA_MM,
  newApproximation,
  reachable,
  RESECTION_ALONG,
  RESECTION_HEIGHT,
  RESECTION_SHAPES,
  resectionWidths,
  reshaped,
  ringName,
  sutureRange,
  within,
  type Anatomy,
  type Annuloplasty,
  type Approximation,
  type EdgeToEdge,
  type Resection,
} from './steps'
import parts from '../style/parts.module.css'
import repairStyle from './repair.module.css'

export interface StepContext extends Anatomy {
  rings: Rings
  change(step: Step, passing: boolean): void
  pickInsertion(use: (point: LeafletPoint) => void): void
  pickAnchor(use: (around: number) => void): void
}

export function stepForm(step: Step, context: StepContext): HTMLElement {
  switch (step.step) {
    case 'annuloplasty':
      return ringForm(step, context)
    case 'papillary_approximation':
      return approximationForm(step, context)
    case 'neochorda':
      return h(
        'div',
        {},
        slider('Length', step.length_mm, NEOCHORDA_MM, 'mm', (length_mm, passing) =>
          context.change({ ...step, length_mm }, passing),
        ),
        headField(step.head, context, (head) => context.change({ ...step, head }, false)),
        insertionFields(step.insertion, context, (insertion, passing) =>
          context.change({ ...step, insertion }, passing),
        ),
      )
    case 'edge_to_edge':
      return edgeForm(step, context)
    case 'leaflet_resection':
      return resectionForm(step, context)
    case 'chordal_length_change':
      return slider('Length change', step.change_mm, CHANGE_MM, 'mm', (change_mm, passing) =>
        context.change({ ...step, change_mm }, passing),
      )
    case 'chordal_excision':
      return h('p', { class: parts.hint }, 'A cut chorda carries no load.')
    case 'chordal_transfer':
      return insertionFields(step.insertion, context, (insertion, passing) =>
        context.change({ ...step, insertion }, passing),
      )
  }
}

function edgeForm(step: EdgeToEdge, context: StepContext): HTMLElement {
  return h(
    'div',
    {},
    field(
      'Device',
      select(EDGE_DEVICES, step.device, (device) =>
        context.change({ ...step, device: device as EdgeToEdge['device'] }, false),
      ),
    ),
    slider('Along (AL to PM)', step.along, EDGE_ALONG, '', (along, passing) =>
      context.change({ ...step, along }, passing),
    ),
    slider('Width', step.width_mm, EDGE_MM, 'mm', (width_mm, passing) =>
      context.change({ ...step, width_mm }, passing),
    ),
    h('p', { class: parts.hint }, 'Holds opposite points of both free edges, or both edges of a cleft, together.'),
  )
}

const LEAFLETS = [
  ['anterior', 'Anterior'],
  ['posterior', 'Posterior'],
] as const

function resectionForm(step: Resection, context: StepContext): HTMLElement {
  const { along, width_mm } = step
  const choose = (shape: string): void =>
    context.change(
      reshaped(
        shape === 'triangular'
          ? { step: 'leaflet_resection', shape, leaflet: 'posterior', along, width_mm, height: 0.7 }
          : { step: 'leaflet_resection', shape: 'quadrangular', along, width_mm, sliding: true },
      ),
      false,
    )
  return h(
    'div',
    {},
    field('Shape', select(RESECTION_SHAPES, step.shape, choose)),
    step.shape === 'triangular'
      ? field(
          'Leaflet',
          select(LEAFLETS, step.leaflet, (leaflet) =>
            context.change(reshaped({ ...step, leaflet: leaflet as LeafletPoint['leaflet'] }), false),
          ),
        )
      : field(
          'Annulus',
          select(
            [
              ['sliding', 'sliding plasty'],
              ['plication', 'plication'],
            ] as const,
            step.sliding ? 'sliding' : 'plication',
            (how) => context.change(reshaped({ ...step, sliding: how === 'sliding' }), false),
          ),
        ),
    slider('Along (AL to PM)', along, RESECTION_ALONG, '', (to, passing) =>
      context.change({ ...step, along: to }, passing),
    ),
    slider('Width', width_mm, resectionWidths(step), 'mm', (to, passing) =>
      context.change({ ...step, width_mm: to }, passing),
    ),
    step.shape === 'triangular' &&
      slider('Height', step.height, RESECTION_HEIGHT, '', (height, passing) =>
        context.change({ ...step, height }, passing),
      ),
    h('p', { class: parts.hint }, 'Chordae of the resected tissue are also cut.'),
  )
}

function ringForm(step: Annuloplasty, context: StepContext): HTMLElement {
  const { rings, sizes_mm } = context.rings
  // A designed shape comes from a file, so it is offered only where it is.
  const designed = step.shape === 'designed' ? [['designed', ringName(step)] as const] : []
  const shapes = [
    ['own', 'shape of the annulus'] as const,
    ...rings.map(({ name }) => [name, name] as const),
    ...designed,
  ]
  const usual = 2 * Math.round(context.before.closure.annulus.al_pm_mm / 2) - 4
  const choose = (name: string): void => {
    if (name === step.shape) return
    const shape = name as Exclude<Annuloplasty['shape'], 'designed'>
    const size_mm = Math.min(Math.max(usual, sizes_mm.min), sizes_mm.max)
    context.change(
      shape === 'own' ? { step: 'annuloplasty', shape, sizes_below: 2 } : { step: 'annuloplasty', shape, size_mm },
      false,
    )
  }
  const note = rings.find(({ name }) => name === step.shape)?.note
  const size =
    'sizes_below' in step
      ? slider('Undersized by', step.sizes_below, { min: 0, max: 6, step: 1 }, 'sizes', (sizes_below, passing) =>
          context.change({ step: 'annuloplasty', shape: 'own', sizes_below }, passing),
        )
      : slider('Size', step.size_mm, sizes_mm, 'mm', (size_mm, passing) =>
          context.change({ ...step, size_mm }, passing),
        )
  return h(
    'div',
    {},
    field('Shape', select(shapes, step.shape, choose)),
    size,
    note && h('p', { class: parts.hint }, note),
  )
}

function approximationForm(step: Approximation, context: StepContext): HTMLElement {
  const around = step.anchor === 'annulus_point' ? step.annulus_around : undefined
  const choose = (anchor: string): void =>
    context.change(newApproximation(context, step.side, anchor as Approximation['anchor'], around), false)
  const place =
    step.anchor === 'annulus_point' &&
    h(
      'div',
      {},
      slider('Place', 360 * step.annulus_around, { min: 0, max: 360, step: 2 }, '°', (degrees, passing) =>
        context.change(reachable(context, { ...step, annulus_around: degrees / 360 }), passing),
      ),
      h(
        'p',
        { class: parts.hint },
        '0° posteromedial commissure, 90° saddle peak, 180° anterolateral commissure, 270° mid-posterior.',
      ),
      button('Pick on the annulus', () =>
        context.pickAnchor((annulus_around) => context.change(reachable(context, { ...step, annulus_around }), false)),
      ),
    )
  return h(
    'div',
    {},
    field('Anchor', select(ANCHORS, step.anchor, choose)),
    place,
    slider('Suture', step.suture_length_mm, sutureRange(context, step), 'mm', (suture_length_mm, passing) =>
      context.change({ ...step, suture_length_mm }, passing),
    ),
  )
}

function headField(head: string, { before }: StepContext, choose: (head: string) => void): HTMLElement {
  return field(
    'Papillary head',
    select(
      before.heads.map(({ id }) => [id, id] as const),
      head,
      choose,
    ),
  )
}

function insertionFields(
  point: LeafletPoint,
  context: StepContext,
  change: (point: LeafletPoint, passing: boolean) => void,
): HTMLElement {
  const share = { min: 0, max: 1, step: 0.01 }
  return h(
    'div',
    {},
    field(
      'Leaflet',
      select(LEAFLETS, point.leaflet, (leaflet) =>
        change({ ...point, leaflet: leaflet as LeafletPoint['leaflet'] }, false),
      ),
    ),
    slider('Along (AL to PM)', point.along, share, '', (along, passing) => change({ ...point, along }, passing)),
    slider('Height (to free edge)', point.height, share, '', (height, passing) =>
      change({ ...point, height }, passing),
    ),
    button('Pick on the leaflet', () => context.pickInsertion((picked) => change(picked, false))),
  )
}

/// `set` with passing true on each move, false when it is let go; a change is none for the browser if it ends where it began.
/// The number beside it takes what is typed, as near as the range allows.
function slider(
  label: string,
  value: number,
  range: { min: number; max: number; step: number },
  unit: string,
  set: (value: number, passing: boolean) => void,
): HTMLElement {
  const digits = range.step < 0.1 ? 2 : range.step < 1 ? 1 : 0
  const name = unit ? `${label}, ${unit}` : label
  const typed = h('input', {
    type: 'number',
    ...range,
    value: value.toFixed(digits),
    'aria-label': `${name} as a number`,
    onchange: () => set(within(Number(typed.value), range), false),
  })
  const input = h('input', {
    type: 'range',
    ...range,
    value,
    'aria-label': name,
    oninput: () => {
      typed.value = Number(input.value).toFixed(digits)
      set(Number(input.value), true)
    },
    onchange: () => set(Number(input.value), false),
    onpointerup: () => set(Number(input.value), false),
  })
  return h(
    'div',
    { class: repairStyle.slider },
    h('span', {}, label),
    typed,
    h('span', { class: parts.unit }, unit),
    input,
  )
}
