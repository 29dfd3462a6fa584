// The one local service of the page that is open, with its engine.
import { startThread } from './client'
import { browserValves } from './kept_valves'
import { localService } from './local_service'

export const pageService = localService({ engine: startThread(), file: (path) => fetch(path), valves: browserValves() })
