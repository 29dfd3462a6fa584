// Short names for the service's documents (openapi.ts). Millimetres, newtons, square millimetres.
import type { components } from './openapi.js'

type Schemas = components['schemas']

export type Vector = Schemas['Vector']
export type Problem = Omit<Schemas['Fault'], 'code'> & { code: string } // the page has some of its own
export type ValveDocument = Schemas['Valve']
export type Head = Schemas['Valve.head']
export type Side = Head['side']

export type LeafletPoint = Schemas['Plan.leaflet_point']
export type Leaflet = LeafletPoint['leaflet']
export type Plan = Schemas['Plan']
export type Step = Plan['steps'][number]

export type Measure = Schemas['Measure']
export type Closure = Schemas['Closure']
export type Scene = Schemas['Scene']
/// What of a scene does not need a closure.
export type ValveShape = Omit<Scene, 'closure'>
export type Leak = Schemas['Leak']
export type Estimate = Schemas['Estimate']
export type LeakSurfaces = Schemas['LeakSurfaces']
export type Opening = Schemas['Opening']
export type OpeningScene = Schemas['OpeningScene']
export type Observed = NonNullable<Schemas['Valve']['observed']>
export type Information = Schemas['Information']
export type Physiology = Schemas['Physiology']
export type PhysiologyRow = Schemas['PhysiologyRow']
export type Segment = Scene['segments'][number]
export type FileToImport = Schemas['FileToImport']
export type FileLookedAt = Schemas['FileLookedAt']
/// FilesToFit; its leaflets are a list while they come together.
export type ImportRequest = Omit<Schemas['FilesToFit'], 'leaflets'> & { leaflets?: FileToImport[] }
export type ImportResult = Schemas['ImportResult']
export type ImportDecision = Schemas['ImportDecision']
export type LabelTaken = Schemas['LabelTaken']
export type VoxelGrid = Schemas['VoxelGrid']
export type FitResult = Schemas['FitResult']
export type Rings = Omit<Schemas['Rings'], 'notice'>

export type RankedPlan = Schemas['RankedPlan']
export type CostTerms = Schemas['CostTerms']
export type Gate = RankedPlan['gates'][number]
export type LeakMap = RankedPlan['leak_map'][number]
export type SearchResult = Schemas['Plans']
export type FrontPlan = SearchResult['pareto_front'][number]
export type CostPoint = SearchResult['progress'][number]
export type PreferenceCase = Schemas['PreferenceCase']
export type PreferenceAnswer = Schemas['PreferenceAnswer']
export type Preference = Schemas['Preference']
export type LearnedWeights = Schemas['LearnedWeights']
export type Evaluations = Schemas['Evaluations']

export type Farm = Omit<Schemas['Farm'], 'notice'>

export type Job = Schemas['Job']
export type JobState = Schemas['JobState']
export type JobProgress = Schemas['Progress']
export type SearchProgress = Omit<JobProgress, 'seconds'>
export type JobFile = Schemas['Files']['files'][number]
export type StudyResult = Schemas['StudyResult']
export type Finding = StudyResult['findings'][number]
