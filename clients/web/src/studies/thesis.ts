// Numbers that the thesis "Fast Surgical Simulation to Improve Mitral Valve Repair" gives, to stand beside ours.

/// Figure 4.5: orifice, mm2, at anteroposterior dilations, percent; at first "negligible" (4.3.1).
export const DILATED = { percent: [0, 10, 20, 30], mm2: [0, 6.7, 32.0, 86.9] }

/// Table 4.1: largest orifice by class and displaced axes, mm2.
export const AXES = ['T', 'P', 'A', 'T + P', 'T + A', 'P + A', 'all'] as const
export const DISPLACED_MM2: Record<string, number[]> = {
  AL: [1.2, 0.5, 20.2, 4.1, 40.8, 29.6, 66.6],
  PM: [2.6, 6.6, 41.1, 17.5, 67.6, 60.6, 88.6],
  both: [14.6, 4.0, 97.7, 26.0, 186.5, 106.6, 191.7],
}

/// Table 4.2: largest ratio to the properly sized annulus under rings one to three sizes below, percent.
export const RING_PERCENT: Record<string, number[]> = {
  AL: [54.5, 27.3, 13.0],
  PM: [75.4, 52.8, 32.4],
  both: [81.9, 64.1, 47.3],
}
