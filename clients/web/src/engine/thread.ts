// A thread of the engine (worker.ts): how it is started, and what it says, for a person.

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

export function startThread(file = FILE): Worker {
  const thread = new Worker(new URL('./worker.ts', import.meta.url), { type: 'module' })
  thread.postMessage(new URL(file, document.baseURI).href)
  return thread
}

/// Of a thread that has died.
export function diedWords({ message }: ErrorEvent): string {
  return message || 'The engine cannot be started; reload the page.'
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
