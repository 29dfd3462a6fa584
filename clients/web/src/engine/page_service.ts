// The one local service of the page that is open, with its engine.
import { engineClient } from './client'
import { browserValves } from './kept_valves'
import { localService } from './local_service'
import { startThread } from './thread'

export const pageService = localService({
  engine: engineClient(startThread()),
  file: (path) => fetch(path),
  valves: browserValves(),
})
