import { expect, test } from 'vitest'
import {
  anchorPoint,
  describe,
  newApproximation,
  newNeochorda,
  reshaped,
  sutureRange,
  type Resection,
} from '../../src/repair/steps'
import { plansIn } from '../../src/repair/plan_files'
import { placeOf } from '../../src/valve/open'
import { colourOf, scaleOf } from '../../src/viewer/colours'
import { EventReader } from '../../src/api/events'
import { number, percent, seconds, withUnit } from '../../src/format'
import { pyramid } from './scenes'

test('a suture may leave from half of the distance to its anchor to the whole of it', () => {
  const anatomy = { before: pyramid(), ringed: pyramid() }
  const step = newApproximation(anatomy, 'anterolateral', 'ipsilateral_trigone')
  // From (-8, 0, -20) to the trigone at (-10, 0, 0): 20.1 mm.
  expect(anchorPoint(pyramid(), step)).toEqual([-10, 0, 0])
  expect(sutureRange(anatomy, step)).toEqual({ min: 12, max: 20, step: 0.5 })
  expect(step.suture_length_mm).toBe(17)
})

test('a suture is tied to the ringed annulus', () => {
  const ringed = pyramid()
  ringed.annulus_mm = ringed.annulus_mm.map((x) => 0.8 * x)
  const anatomy = { before: pyramid(), ringed }
  // From (-8, 0, -20) to the trigone at (-8, 0, 0).
  expect(sutureRange(anatomy, newApproximation(anatomy, 'anterolateral', 'ipsilateral_trigone')).max).toBe(20)
  // To the saddle peak at (0, 8, 0): 23 mm; without the ring it is 23.7.
  expect(sutureRange(anatomy, newApproximation(anatomy, 'anterolateral', 'saddle_peak')).max).toBe(22.5)
})

test('a new neochorda reaches the place of the other leaflet', () => {
  // The only vertex of the anterior leaflet at the free edge is (0, 0, -10); from (8, 0, -20) that is 12.8 mm.
  const step = newNeochorda(pyramid(), 'PM1', { leaflet: 'posterior', along: 0.5, height: 1 })
  expect(step).toMatchObject({ step: 'neochorda', head: 'PM1', length_mm: 13 })
  expect(describe(step)).toBe('Neochorda from PM1 to P2, free edge, 13.0 mm')
})

test('resections and edge-to-edge repairs are told in surgical words', () => {
  const place = { along: 0.5, width_mm: 12 }
  const wedge: Resection = {
    step: 'leaflet_resection',
    shape: 'triangular',
    leaflet: 'posterior',
    height: 0.7,
    ...place,
  }
  expect(describe(wedge)).toBe('Triangular resection of P2, 12.0 mm wide, over 70 % of the height')
  expect(describe({ step: 'leaflet_resection', shape: 'quadrangular', sliding: true, ...place })).toBe(
    'Quadrangular resection of P2, 12.0 mm wide, with sliding plasty',
  )
  expect(describe({ step: 'edge_to_edge', device: 'clip', along: 0.2, width_mm: 6 })).toBe(
    'Clip from A1 to P1, 6.0 mm wide',
  )
})

test('a resection that is reshaped keeps to the widths of its shape', () => {
  const wide: Resection = { step: 'leaflet_resection', shape: 'quadrangular', along: 0.5, width_mm: 25, sliding: true }
  expect(reshaped(wide).width_mm).toBe(25)
  expect(reshaped({ ...wide, sliding: false }).width_mm).toBe(15)
  const wedge = { step: 'leaflet_resection', shape: 'triangular', along: 0.5, width_mm: 25, height: 0.7 } as const
  expect(reshaped({ ...wedge, leaflet: 'anterior' }).width_mm).toBe(10)
})

test('plans are read from a list or alone, and nothing else is', () => {
  const plan = { schema: 'coapt.plan/1', steps: [] }
  expect(plansIn(JSON.stringify(plan))).toHaveLength(1)
  expect(plansIn(JSON.stringify({ plans: [{ name: 'a', plan }, {}] }))).toEqual([{ name: 'a', plan }])
  expect(() => plansIn('{}')).toThrow(/no plan/)
  expect(() => plansIn('{"schema": "coapt.plan/1", "steps": [null]}')).toThrow(/no plan/)
  expect(() => plansIn('{"schema": "coapt.plan/1", "steps": [{"step": "papillary_approximation"}]}')).toThrow(/no plan/)
  expect(() => plansIn('[')).toThrow()
})

test('a JSON pointer leads to what stands there', () => {
  expect(placeOf('{"a/b": [1, {"x": 2}]}', '/a~1b/1/x')).toBe('2')
  expect(placeOf('{"a": 1}', '/a/b/c')).toBe('')
  expect(placeOf('no JSON', '/a')).toBe('')
})

test('colours run along the scale and stop at its ends', () => {
  const scale = scaleOf('strain_radial', [pyramid()])
  if (!scale) throw new Error('strain has a scale')
  expect(scale.to).toBeGreaterThan(0)
  expect(colourOf(scale, -5)).toEqual(scale.stops[0])
  expect(colourOf(scale, 1e9)).toEqual(scale.stops.at(-1))
  expect(scaleOf('leaflets', [pyramid()])).toBeNull()
})

test('events are put together from parts that come as they like', () => {
  const reader = new EventReader()
  expect(reader.read('retry: 2000\n\nid: 7\nevent: pro')).toEqual([])
  expect(reader.read('gress\ndata: {"a": 1}\n\n: heartbeat\n\n')).toEqual([
    { id: '7', event: 'progress', data: '{"a": 1}' },
  ])
})

test('what is not known is said so', () => {
  expect(number(null)).toBe('unknown')
  expect(number(-0.01)).toBe('0.0')
  expect(withUnit(NaN, 'mm')).toBe('unknown')
  expect(withUnit(1.25, 'mm', 2)).toBe('1.25 mm')
  expect(percent(0.31)).toBe('31 %')
  expect(seconds(75)).toBe('1 min 15 s')
})
