// The one local service of the page that is open, with its engine, and the one that searches, which is loaded when it is asked.
import { type AskEngine, engineClient } from './client'
import { browserValves } from './kept_valves'
import { localJobs } from './local_jobs'
import { localService } from './local_service'
import { PLANNER_FILE, startThread } from './thread'

const planner = () => startThread(PLANNER_FILE)
let scoring: AskEngine | null = null

export const pageService = localService({
  engine: engineClient(startThread()),
  scoring(...asked) {
    scoring ??= engineClient(planner())
    return scoring(...asked)
  },
  jobs: localJobs(planner),
  file: (path) => fetch(path),
  valves: browserValves(),
})
