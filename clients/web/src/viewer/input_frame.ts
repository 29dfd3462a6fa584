// How files of unknown frame and unit are looked at: turned as a valve is, by what is known of them, and of one size.
import type { FileLookedAt, Vector } from '../api/types'
import type { Role } from '../valve/parts'
import { dot, minus, unit } from './geometry'

export interface Part {
  file: FileLookedAt
  role: Role
}

export interface InputFrame {
  origin: Vector
  axes: [Vector, Vector, Vector] // x to the right as the atrium sees it, y anterior, z to the atrium
  scale: number // of the picture over the files
}

const SIZE = 60 // of the picture, across all files

export function cross(a: Vector, b: Vector): Vector {
  return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

export function pointsOf({ points }: FileLookedAt): Vector[] {
  const list: Vector[] = []
  for (let i = 0; i + 2 < points.length; i += 3)
    list.push([points[i] as number, points[i + 1] as number, points[i + 2] as number])
  return list
}

function mean(points: Vector[]): Vector {
  const sum: Vector = [0, 0, 0]
  for (const point of points) for (const k of [0, 1, 2] as const) sum[k] += point[k] / points.length
  return sum
}

/// Twice the area vector of a closed line.
function areaVector(loop: Vector[], about: Vector): Vector {
  const sum: Vector = [0, 0, 0]
  loop.forEach((point, i) => {
    const turn = cross(minus(point, about), minus(loop[(i + 1) % loop.length] as Vector, about))
    for (const k of [0, 1, 2] as const) sum[k] += turn[k]
  })
  return sum
}

/// Null if there is no point.
export function inputFrame(parts: Part[]): InputFrame | null {
  const of = (choose: (part: Part) => boolean): Vector[] => parts.filter(choose).flatMap(({ file }) => pointsOf(file))
  const all = of(() => true)
  if (all.length === 0) return null
  const loop = of(({ file, role }) => role === 'annulus' || (role === 'folder' && file.content === 'curve'))
  const surfaces = of(({ file }) => file.faces.length > 0)
  const origin = mean(loop.length > 2 ? loop : all)
  const chordae = parts.filter(({ file }) => file.content === 'chordae').flatMap(({ file }) => pointsOf(file))
  const tips = [...of(({ file }) => file.content === 'tips'), ...chordae.filter((_, i) => i % 2 === 1)]
  let z: Vector = loop.length > 2 ? areaVector(loop, origin) : [0, 0, 1]
  z = Math.hypot(...z) > 0 ? unit(z) : [0, 0, 1]
  const below = tips.length > 0 ? tips : surfaces
  if (loop.length > 2 && below.length > 0 && dot(minus(mean(below), origin), z) > 0) z = [-z[0], -z[1], -z[2]]
  const leaflet = (role: Role, word: RegExp): Vector[] =>
    of((part) => part.role === role || (part.role === 'folder' && word.test(part.file.name)))
  const front = leaflet('anterior', /anterior/i)
  const back = leaflet('posterior', /posterior/i)
  const forwards = front.length > 0 && back.length > 0 ? minus(mean(front), mean(back)) : ([0, 1, 0] as Vector)
  const y = across(forwards, z)
  const far = all.reduce((most, point) => Math.max(most, Math.hypot(...minus(point, origin))), 0)
  return { origin, axes: [cross(y, z), y, z], scale: far > 0 ? SIZE / (2 * far) : 1 }
}

/// The part of `way` across z, of length 1; any one if there is none.
function across(way: Vector, z: Vector): Vector {
  for (const one of [way, [0, 1, 0], [1, 0, 0]] as Vector[]) {
    const up = dot(one, z)
    const flat: Vector = [one[0] - up * z[0], one[1] - up * z[1], one[2] - up * z[2]]
    if (Math.hypot(...flat) > 1e-6 * Math.hypot(...one)) return unit(flat)
  }
  return [1, 0, 0]
}

export function intoView({ origin, axes, scale }: InputFrame, point: Vector): Vector {
  const from = minus(point, origin)
  return axes.map((axis) => scale * dot(from, axis)) as unknown as Vector
}

export function intoFile({ origin, axes, scale }: InputFrame, point: Vector): Vector {
  return [0, 1, 2].map(
    (k) =>
      (origin[k] as number) +
      axes.reduce((sum, axis, i) => sum + ((axis[k] as number) * (point[i] as number)) / scale, 0),
  ) as unknown as Vector
}
