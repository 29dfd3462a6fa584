// A story and its slides (io/schema/story.schema.json).
import type { Segment, Step } from '../api/types'
import type { ColourMode } from '../viewer/colours'
import type { Camera } from '../viewer/camera'

export interface Pull {
  segment: Segment // by the middle of its free edge
  lift_mm: number // towards the atrium
  pressure_mmhg?: number // that of systole, if none is said
}

export interface Slide {
  title: string
  text: string // {leak} and the like are figures
  view: 'valve' | 'repair' | 'live'
  valve: string // a preset's name, or a stored valve's id
  steps?: Step[] // of the plan
  camera?: Camera
  colours?: ColourMode
  cut?: boolean // across the middle
  pull?: Pull // in the live view
  vary?: number // step whose tolerance is shown, the first is 1; in the view Repair
  expect?: 'leaks' | 'closed' // what the text takes for granted
}

export interface Story {
  schema: 'coapt.story/1'
  name: string
  title: string
  about: string
  slides: Slide[]
}
