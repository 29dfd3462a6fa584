// What the engine says of a valve that moves, once a picture: a flat list of numbers (LiveEngine::take_picture).
import type { Vector } from '../api/types'
import { at, length } from '../viewer/geometry'

export const HOOKS = 2
const STATE = 5 // numbers before the hooks
const HOOK = 10 // numbers of a hook

export interface HookState {
  spot_mm: Vector // of the tissue
  hand_mm: Vector
  force: Vector // on the tissue, N
  force_n: number
}

export interface Picture {
  pressure_mmhg: number
  at_rest: boolean
  beats: boolean // on its way to its unstressed shape, after the last hook was let go
  returns: number // how often leaflets would have crossed
  longest_move_mm: number // of a node, in the last step
  hooks: (HookState | null)[] // null: holds nothing
  nodes: Float32Array // in the order of Scene.motion_mm
  cables: Float32Array // tension (N) and strain of each
}

/// `cables`: how many there are.
export function readPicture(numbers: Float32Array, cables: number): Picture {
  const first = STATE + HOOKS * HOOK
  const end = numbers.length - 2 * cables
  return {
    pressure_mmhg: numbers[0] ?? 0,
    at_rest: numbers[1] === 1,
    beats: numbers[2] === 1,
    returns: numbers[3] ?? 0,
    longest_move_mm: numbers[4] ?? 0,
    hooks: Array.from({ length: HOOKS }, (_, i) =>
      readHook(numbers.subarray(STATE + HOOK * i, STATE + HOOK * (i + 1))),
    ),
    nodes: numbers.subarray(first, end),
    cables: numbers.subarray(end),
  }
}

function readHook(numbers: Float32Array): HookState | null {
  if (numbers[0] !== 1) return null
  const [spot_mm, hand_mm, force] = [1, 4, 7].map((from) => at(numbers.subarray(from, from + 3), 0)) as [
    Vector,
    Vector,
    Vector,
  ]
  return { spot_mm, hand_mm, force, force_n: length(force) }
}
