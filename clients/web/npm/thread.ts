// A thread of the package, in a browser or in node.
import { type Port, serve } from '../src/engine/serve'

const isBrowser = 'WorkerGlobalScope' in globalThis
serve((isBrowser ? globalThis : (await import('node:worker_threads')).parentPort) as unknown as Port)
