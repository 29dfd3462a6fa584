// The one local service of the page that is open, with its engine, and the one that searches, which is loaded when it is asked.
import { browserValves } from './kept_valves'
import { localJobs } from './local_jobs'
import { localService } from './local_service'
import { PLANNER_FILE, startThreads } from './thread'

const MOST_THREADS = 8 // of a search: each takes some 50 MB

const engine = startThreads(2) // a valve's draws of tissue beside its closures
const planner = startThreads(Math.min(navigator.hardwareConcurrency || 1, MOST_THREADS), PLANNER_FILE)

export const pageService = localService({
  engine: (asked) => engine.ask(asked),
  scoring: (asked) => planner.ask(asked),
  jobs: localJobs((asked) => planner.ask(asked)),
  file: (path) => fetch(path),
  valves: browserValves(),
})
