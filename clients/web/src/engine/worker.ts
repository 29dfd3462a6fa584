// The thread of the engine, so that the page stays responsive while a valve closes. The first message is the address of
// the engine's file, each later one a request; every request gets one reply, in order.
import { type Engine, type EngineAnswer, startEngine } from './module'

export interface EngineRequest {
  path: string
  body: string
}
export type EngineReply = EngineAnswer | { failed: string }

let address = ''
let module: Promise<WebAssembly.Module> | null = null
let engine: Promise<Engine> | null = null

async function fetchModule(): Promise<WebAssembly.Module> {
  const response = await fetch(address)
  if (!response.ok) throw new Error(`${address} cannot be loaded (${response.status})`)
  return WebAssembly.compile(await response.arrayBuffer()) // streaming would need a server that knows the file's type
}

/// After a failure another one is started with the next request.
async function start(): Promise<Engine> {
  module ??= fetchModule()
  return startEngine(
    await module.catch((error: unknown) => {
      module = null
      throw error
    }),
  )
}

async function reply({ path, body }: EngineRequest): Promise<EngineReply> {
  try {
    engine ??= start()
    return (await engine)(path, body)
  } catch (error) {
    engine = null
    return { failed: error instanceof Error ? error.message : String(error) }
  }
}

addEventListener('message', ({ data }: MessageEvent<string | EngineRequest>) => {
  if (typeof data === 'string') {
    address = data
    engine = start()
    engine.catch(() => {}) // said with the first reply
    return
  }
  void reply(data).then((said) => postMessage(said, { transfer: 'body' in said ? [said.body.buffer] : [] }))
})
