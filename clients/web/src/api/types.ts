// The documents of the service that the page reads (server/openapi.json). Millimetres, newtons, square millimetres.

export type Vector = [number, number, number]
export type Side = 'anterolateral' | 'posteromedial'
export type Leaflet = 'anterior' | 'posterior'
export type Segment = 'A1' | 'A2' | 'A3' | 'P1' | 'P2' | 'P3' | 'AC' | 'PC'
export type ChordaKind = 'marginal' | 'strut' | 'basal' | 'neochorda'
export type Status = 'converged' | 'step_limit' | 'diverged'

export interface Problem {
  code: string
  path: string // a JSON pointer into what was sent
  message: string
}

export interface LeafletPoint {
  leaflet: Leaflet
  along: number // 0 anterolateral commissure, 1 posteromedial
  height: number // 0 annulus, 1 free edge
}

export type Step =
  | { step: 'annuloplasty'; shape: string; sizes_below?: number; size_mm?: number }
  | { step: 'neochorda'; head: string; insertion: LeafletPoint; length_mm: number }
  | { step: 'chordal_length_change'; chorda: string; change_mm: number }
  | { step: 'chordal_excision'; chorda: string }
  | { step: 'chordal_transfer'; chorda: string; insertion: LeafletPoint }
  | {
      step: 'papillary_approximation'
      side: Side
      anchor: 'ipsilateral_trigone' | 'saddle_peak' | 'annulus_point'
      annulus_around?: number
      suture_length_mm: number
    }

export interface Plan {
  schema: 'coapt.plan/1'
  steps: Step[]
}

/// coapt.valve/1; the page passes it on as it is.
export interface ValveDocument {
  schema: 'coapt.valve/1'
  name?: string
  provenance?: string[]
  [field: string]: unknown
}

export interface CoaptationSection {
  along: number
  height_mm: number
  distance_mm: number | null
  contact: boolean
}

export interface Measure {
  orifice_area_mm2: number | null
  orifice_area_raw_mm2: number | null
  orifice_area_mean_mm2: number | null
  leak_mm2: number | null
  orifices: { area_mm2: number; centroid_mm: Vector; segment: Segment }[]
  coaptation: {
    height_min_mm: number | null
    height_mean_mm: number | null
    height_p10_mm: number | null
    distance_max_mm: number | null
    gap_area_mm2: number | null
    sections: CoaptationSection[]
  }
  annulus: {
    ap_mm: number
    al_pm_mm: number
    circumference_mm: number
    area_mm2: number
    saddle_height_mm: number
  }
  tenting_height_mm: number | null
  tenting_area_mm2: number | null
  tension_max_n: number | null
  tension_sum_n: number | null
  strain_circumferential_max: number | null
  strain_radial_max: number | null
}

export interface Closure extends Measure {
  schema: 'coapt.closure/1'
  valve: string
  triangles: number
  status: Status
  crossing: boolean
  residual: number | null
  steps: number
  seconds: number
  warnings: string[]
}

export interface ChordaSegment {
  parent: number
  end_mm: Vector
  tension_n: number | null
  face?: number
  weights?: Vector
}

export interface Chorda {
  id: string
  kind: ChordaKind
  head: number
  ruptured: boolean
  segments: ChordaSegment[]
}

export interface Head {
  id: string
  side: Side
  rest_mm: Vector
  tip_mm: Vector
}

/// Long lists of points are flat: x, y, z, x, y, z, ...
export interface Scene {
  schema: 'coapt.scene/1'
  plane: { origin_mm: Vector; x: Vector; y: Vector; normal: Vector }
  thickness_mm: number
  rest_mm: number[]
  closed_mm: number[] | null
  faces: number[]
  segments: Segment[]
  leaflet_coordinates: { around: number[]; height: number[] }
  annulus: number[]
  annulus_mm: number[]
  landmarks: Record<string, number>
  heads: Head[]
  chordae: Chorda[]
  sutures: { side: Side; tip_mm: Vector; anchor_mm: Vector }[]
  strain: { circumferential: number[]; radial: number[] } | null
  orifices: { area_mm2: number; contours_mm: number[][] }[]
  sections: (CoaptationSection & { point_mm: Vector; normal: Vector })[]
  motion_mm: number[][]
  closure: Closure
}

export interface Ring {
  name: string
  ap_over_transverse: number
  transverse_factor: number
  saddle_over_transverse: number
  note: string
}

export interface Rings {
  rings: Ring[]
  sizes_mm: { min: number; max: number; step: number }
}

export interface Statistics {
  nominal: number | null
  mean: number | null
  sd: number | null
  worst: number | null
  p95: number | null
  below_5: number | null
  below_10: number | null
  below_20: number | null
}

export interface Gate {
  rule: string
  severity: 'pass' | 'warn' | 'reject' | 'not_assessed'
  finding: string
  source: string
}

/// Rows of `leak_mm2` by length, columns by angle; null: not closed.
export interface LeakMap {
  muscle: 'both' | Side
  suture_length_mm: number[]
  outwards_deg: number[]
  leak_mm2: (number | null)[][]
}

export interface ParetoPlan {
  plan: Plan
  description: string[]
  mean_mm2: number | null
  sd_mm2: number | null
  steps: number
  ring_sizes_below: number
  nodes: number
}

export interface RankedPlan {
  rank: number
  plan: Plan
  description: string[]
  orifice_area_mm2: Statistics
  leak_mm2: Statistics
  cost: number | null
  status: Status
  crossing: boolean
  measure: Measure
  steps: number
  ring_sizes_below: number
  anterolateral_movement_mm: number
  posteromedial_movement_mm: number
  region_closures: number
  region_failures: number
  margin_to_leak: { suture_length_mm: number | null; angle_deg: number | null; share: number | null }
  pareto: boolean
  probability_outranks_next: number | null
  tie_with_next: boolean
  leak_map: LeakMap[]
  sobol: Record<'first' | 'total', Record<'suture_length' | 'outwards' | 'posterior', number | null>>
  independent_leak_mm2: Statistics
  remodelling: { direction: string; leak_mm2: (number | null)[] }[]
  gates: Gate[]
  warnings: string[]
}

export interface CostPoint {
  closures: number
  cost: number | null
}

/// coapt.plans/1: the result of a search.
export interface SearchResult {
  before: Measure & { status: Status; crossing: boolean }
  any_competent: boolean
  plans: RankedPlan[]
  progress: CostPoint[]
  random_progress: CostPoint[]
  pareto_front: ParetoPlan[]
  cut: { what: string; why: string }[]
  plans_possible: number
  plans_tried: number
  stop: string
  closures: number
  evaluations: number
  seconds: number
  not_modelled: string[]
}

export interface Evaluations {
  before: Measure & { status: Status; crossing: boolean }
  plans: (RankedPlan & { index: number })[]
}

export type JobState = 'QUEUED' | 'RUNNING' | 'SUCCEEDED' | 'FAILED' | 'CANCELLED'

export interface JobProgress {
  stage: string
  evaluations: number
  evaluations_planned: number
  best_leak_mm2: number | null
  best_cost: number | null
  random_cost: number | null
  seconds: number
}

export interface Job {
  id: string
  kind: 'plans' | 'study'
  state: JobState
  created: string
  started: string | null
  finished: string | null
  valve: string // the id of its content
  cancel_requested: boolean
  waiting_for: string | null
  queue_position: number | null
  progress: JobProgress
  problems: Problem[]
  findings?: number // of a study that has ended
  agree?: number
  links: Record<string, string>
}

export interface JobFile {
  name: string
  type: string
  bytes: number
  path: string
}

export interface Finding {
  finding: string
  section: string // of the thesis
  thesis: string
  ours: string
  judged: string
  agrees: boolean
}

/// What a study ends with.
export interface StudyResult {
  study: string
  valve: string
  configurations: number // five end states each
  closures: number // made now
  untrusted: number
  seconds: number
  findings: Finding[]
  agree: number
}
