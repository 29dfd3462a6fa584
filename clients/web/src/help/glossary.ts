// What the words on the page mean, each in a sentence or two for a surgeon.
export const GLOSSARY = {
  leak: 'The area of the smallest surface that separates atrium from ventricle between the closed leaflets, including their thickness. It is an anatomic orifice area, not a regurgitant volume.',
  bounds:
    'The leak is measured on voxels of half a millimetre; its exact area on these lies between the two bounds. Errors of mesh and closure are part of the numerical error, not of the bounds.',
  opening:
    'The area of the smallest surface that separates atrium from ventricle between the open leaflets in diastole, with annulus and papillary tips in their diastolic positions. The leaflets are in equilibrium with the load at peak filling; the flow itself is not simulated.',
  gradient:
    'The mean pressure difference that drives the filling pulse through the opening, from Bernoulli’s equation.',
  coaptation:
    'The height of contact between the leaflets, measured across the coaptation line. Repairs aim for about 8 mm.',
  tenting_height: 'The distance from the annular plane to the coaptation point.',
  tenting_area:
    'The area between the annular plane and the leaflets in the mid-valve section. Parts above the plane count as negative.',
  saddle: 'The height of the saddle peak, in the middle of the anterior annulus, above the annular plane.',
  tension: 'The tensile force in a chorda of the closed valve.',
  strain:
    'The stretch of the leaflet relative to its unloaded state, along the annulus (circumferential) or from the annulus to the free edge (radial). The value is the 99th percentile: 1 % of the leaflet area is stretched more. Chordae insert at single points, so radial strains near them are overestimated.',
  error:
    'The error of the area due to mesh size and the stopping criterion of the closure; in nine of ten test valves the error was smaller. It grows with the area and does not include errors of tissue, imaging and pressure.',
  certainty:
    'Effort spent on the numerical error of the leak. Quick: the mesh as shown. Sure: also a mesh of four times as many triangles, and the mesh as shown at half the speed, which may end in another shape. Proof: also finer and finer meshes, until the leak changes by less than 0.5 mm² or 5 %, or the next mesh is too large. In nine of ten test valves the error was smaller than the one stated here; it does not include errors of tissue, imaging and pressure.',
  tissue:
    'The valve was closed in many variants of tissue and chordae within the ranges of their sources, weighted by the observations of this valve. The leak lies between the two areas in nine of ten variants.',
  margin: 'The smallest error in placing a suture or a ring that makes the valve leak more than 1 mm².',
  cost: 'The objective of the search, in mm² of leak; the sliders rank plans by it. It adds to the leak and its spread a weight, in mm² of leak, for each step, undersizing, papillary relocation, low coaptation, high chordal tension, a diastolic gradient above 3 mmHg and a small reserve against progression; the planned closure is that on the finer mesh. The weights are judgements, not measurements; see “Weights of the cost”.',
  durability:
    'How far the posteromedial papillary muscle can be displaced by progressing disease before the leak exceeds 5 mm²: the mean over eight simulated courses of up to 12 mm.',
  region:
    'The plan is closed many times with small errors of execution: lengths off by up to 1 mm and the direction of the papillary tips by up to 5°. The residual leak is the mean + sd over these closures; nine of ten of them leak an area in the interval from 5 to 95 %.',
  pareto:
    'No other ranked plan is better in leak (mean + sd), diastolic opening or reserve against progression without being worse in another of the three.',
  acceptable:
    'The repaired valve leaks less than 5 mm² with a probability of at least 95 %, given the errors of execution, tissue and mesh, and also on the finer mesh; no rule of practice rejects the plan; and the valve opens far enough.',
} as const
export type Term = keyof typeof GLOSSARY
