// Threads of the engine (worker.ts) in the page: how they are started, and what they say, for a person.
import { Threads, threadOf } from './threads'

/// Of a Worker, what is used of it.
export interface EngineThread<Message, Reply> {
  postMessage(message: Message): void
  onmessage: ((event: MessageEvent<Reply>) => void) | null
  onerror: ((event: ErrorEvent) => void) | null
}

const NO_SIMD = 'This view requires WebAssembly with SIMD, which this browser does not support. Please use a newer one.'
const FILE = 'coapt-engine.wasm'
const NO_ENGINE = `This view requires the engine (${FILE}), which is not installed. The administrator of the service can add it with “make wasm web”.`

/// Whether its file stands beside the page; yes while nobody answers.
export function hasEngine(): Promise<boolean> {
  return fetch(FILE, { method: 'HEAD' }).then(
    ({ status }) => status !== 404,
    () => true,
  )
}

/// The module that searches, too.
export const PLANNER_FILE = 'coapt-planner.wasm'

const modules = new Map<string, Promise<WebAssembly.Module>>()

/// Of a file beside the page; one that could not be loaded is asked for again.
function moduleOf(file: string): Promise<WebAssembly.Module> {
  const loaded = modules.get(file) ?? loadModule(new URL(file, document.baseURI).href)
  modules.set(file, loaded)
  loaded.catch(() => modules.delete(file))
  return loaded
}

async function loadModule(address: string): Promise<WebAssembly.Module> {
  const response = await fetch(address)
  if (!response.ok) throw new Error(`${address} cannot be loaded (${response.status})`)
  return WebAssembly.compile(await response.arrayBuffer()) // streaming would need a server that knows the file's type
}

const startWorker = () => new Worker(new URL('./worker.ts', import.meta.url), { type: 'module' })

/// For a valve that moves.
export function startThread(): Worker {
  const thread = startWorker()
  moduleOf(FILE).then(
    (module) => thread.postMessage({ module }),
    (error: Error) => thread.postMessage({ missing: error.message }),
  )
  return thread
}

/// For requests: so many at a time.
export function startThreads(most = 1, file = FILE): Threads {
  return new Threads(
    () => moduleOf(file),
    most,
    async () => threadOf(startWorker()),
  )
}

export function engineWords(message: string): string {
  return message.includes('(404)') ? NO_ENGINE : message
}

// A function that returns a v128: (module (func (result v128) i32.const 0 i8x16.splat)).
const SIMD = [0, 97, 115, 109, 1, 0, 0, 0, 1, 5, 1, 96, 0, 1, 123, 3, 2, 1, 0, 10, 8, 1, 6, 0, 65, 0, 253, 15, 11]

/// Throws where the browser cannot run the engine.
export function requireSimd(): void {
  if (typeof WebAssembly !== 'object' || !WebAssembly.validate(Uint8Array.from(SIMD))) throw new Error(NO_SIMD)
}
