// A thread of the package, in a browser or in node: the module first, then requests, each of which gets one answer.
import { type Engine, startEngine } from '../src/engine/module'
import type { FromThread, ToThread } from './messages'

interface Port {
  postMessage(message: FromThread): void
  onmessage: ((event: { data: ToThread }) => void) | null
}

const isBrowser = 'WorkerGlobalScope' in globalThis
const port = (isBrowser ? globalThis : (await import('node:worker_threads')).parentPort) as unknown as Port

let module: WebAssembly.Module | null = null
let engine: Promise<Engine> | null = null

/// After a failure the next request starts the module anew.
async function reply(path: string, body: string): Promise<FromThread> {
  try {
    engine ??= startEngine(module as WebAssembly.Module, (done, planned) =>
      port.postMessage({ progress: [done, planned] }),
    )
    return (await engine).answer(path, body)
  } catch (error) {
    engine = null
    return { failed: error instanceof Error ? error.message : String(error) }
  }
}

port.onmessage = ({ data }) => {
  if ('module' in data) module = data.module
  else void reply(data.path, data.body).then((said) => port.postMessage(said))
}
