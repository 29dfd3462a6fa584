// What the words on the page mean, each in a sentence or two for a surgeon.
export const GLOSSARY = {
  leak: 'The least area of a surface in the blood that parts atrium from ventricle, between leaflets with their thickness. It is an area of the closed valve, not a volume of blood.',
  bounds:
    'The leak is measured on cubes of half a millimetre, and on these its least area lies between the two. How far mesh and closure may be off is in the error, not here.',
  opening:
    'The least area of a surface that parts atrium from ventricle between the open leaflets in diastole, with annulus and papillary tips as far apart as diastole has them. The leaflets rest under the load that blood has at the peak of filling; its flow itself is not computed.',
  gradient:
    'The mean pressure difference that the pulse of filling would need through the opening, by Bernoulli’s equation.',
  coaptation:
    'How high the contact between the leaflets is, across the line of coaptation. About 8 mm is the aim of a repair.',
  tenting_height: 'From the plane of the annulus down to where the leaflets meet.',
  tenting_area:
    'The area between the plane of the annulus and the leaflets, in the middle section. It is negative where the leaflets are above the plane.',
  saddle: 'How far the annulus rises from its plane to the saddle peak in the middle of the anterior side.',
  tension: 'The force in a chorda of the closed valve.',
  strain:
    'How much the leaflet is stretched against its unloaded state, along the annulus (circumferential) or from the annulus to the free edge (radial). Given is the 99th percentile: 1 % of the leaflet area is stretched more. Chordae pull at single points, so radial values are too high near them.',
  error:
    'How far the area may be off because the mesh is coarse and the closure ends early; nine of ten valves of a comparison were nearer. It grows with the area. What tissue, imaging and pressure add is not in it.',
  finer:
    'The valve is closed again on meshes of four and sixteen times the triangles, until the leak changes by less than 0.5 mm² or 5 %. Each mesh takes some ten times as long as the one before.',
  tissue:
    'The valve was closed many times with tissue and chordae as stiff, as long and as thick as their sources leave open, weighed by what was observed of it. Nine of ten of these closures leak between the two areas.',
  margin: 'By how much a suture or a ring may be off before the valve leaks more than 1 mm².',
  cost: 'A price in mm² of leak, by which the search climbs and by which plans are ranked if you move the sliders: the leak with its spread, and prices in mm² of leak for steps, undersizing, movement of the muscles, too little coaptation, too much tension, a gradient in diastole above 3 mmHg and further disease that the repair does not outlast; the closure as planned counts as on the finer mesh. The prices are judgements, not measurements; they stand under “Weights of the cost”.',
  durability:
    'How far disease may go on, by the way of the posteromedial papillary tip, until the valve leaks more than 5 mm²: the mean over eight courses of 12 mm.',
  region:
    'The plan is closed many times with small errors of execution: lengths up to 1 mm and the direction of the papillary tips up to 5° off. Given are the mean and the standard deviation of the leak; 95 % of these closures leak less than the next column says.',
  pareto:
    'No other ranked plan is better in one of leak (mean + sd), opening in diastole and further disease that it bears without being worse in another of them.',
  acceptable:
    'The repaired valve leaks less than 5 mm² with a probability of at least 95 %, over errors of execution, of the model’s own values and of the mesh, and on the finer mesh, too; no rule of practice rejects the plan, and the valve opens far enough.',
} as const
export type Term = keyof typeof GLOSSARY
