// A scene small enough to work answers out by hand: a square annulus of 20 mm and four triangles that meet at a point
// 10 mm below its middle.
import type { Scene } from '../../src/api/types'

export function pyramid(): Scene {
  const rest_mm = [10, 0, 0, 0, 10, 0, -10, 0, 0, 0, -10, 0, 0, 0, -10]
  return {
    schema: 'coapt.scene/2',
    notice: '',
    plane: { origin_mm: [0, 0, 0], x: [1, 0, 0], y: [0, 1, 0], normal: [0, 0, 1] },
    thickness_mm: 1,
    rest_mm,
    closed_mm: rest_mm,
    faces: [0, 1, 4, 1, 2, 4, 2, 3, 4, 3, 0, 4],
    segments: ['A3', 'A1', 'P1', 'P3'],
    leaflet_coordinates: { around: [0, 0.25, 0.5, 0.75, 0.25], height: [0, 0, 0, 0, 1] },
    annulus: [0, 1, 2, 3],
    annulus_mm: rest_mm.slice(0, 12),
    landmarks: { saddle_peak: 1, mid_posterior: 3, posteromedial_trigone: 0, anterolateral_trigone: 2 },
    heads: [
      { id: 'AL1', side: 'anterolateral', rest_mm: [-8, 0, -25], tip_mm: [-8, 0, -20] },
      { id: 'PM1', side: 'posteromedial', rest_mm: [8, 0, -25], tip_mm: [8, 0, -20] },
    ],
    chordae: [
      {
        id: 'branching',
        kind: 'marginal',
        head: 0,
        ruptured: false,
        segments: [
          { parent: -1, end_mm: [-4, 0, -15], tension_n: 1 },
          { parent: 0, end_mm: [0, 0, -10], tension_n: 2, face: 0, weights: [0, 0, 1] },
        ],
      },
    ],
    sutures: [],
    ties: [],
    seams: [],
    strain: { circumferential: [0, 0.1, 0.2, 0.3], radial: [0, 0, 0, 0.4] },
    leak: [],
    sections: [],
    motion_mm: [],
    closure: {} as Scene['closure'],
  }
}
