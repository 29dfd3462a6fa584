// A thread of the engine, so that the page stays responsive while a valve closes or moves. The first message is the address
// of the engine's file, each later one a request, which gets one reply, in order, or a command to the valve that moves.
import { type LiveCommand, LiveLoop, type LiveReply } from './live_loop'
import { type Engine, type EngineAnswer, startEngine } from './module'

export interface EngineRequest {
  path: string
  body: string
}
/// `progress`: of a search that goes on; closures done and planned.
export type EngineReply = EngineAnswer | { failed: string } | { progress: [done: number, planned: number] }

let address = ''
let module: Promise<WebAssembly.Module> | null = null
let engine: Promise<Engine> | null = null
let loop: LiveLoop | null = null

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
    (done, planned) => postMessage({ progress: [done, planned] } satisfies EngineReply),
  )
}

async function reply({ path, body }: EngineRequest): Promise<EngineReply> {
  try {
    engine ??= start()
    return (await engine).answer(path, body)
  } catch (error) {
    engine = null
    return { failed: said(error) }
  }
}

const channel = new MessageChannel() // a timer would wait for 4 ms
let next = (): void => {}
channel.port1.onmessage = () => attempt(next)

/// A valve that fails moves no more until it is started anew.
function attempt(does: () => void): void {
  try {
    does()
  } catch (error) {
    engine = loop = null
    send({ live: 'failed', message: said(error) })
  }
}

function send(answer: LiveReply): void {
  const transfer =
    answer.live === 'picture' ? [answer.numbers.buffer] : answer.live === 'started' ? [answer.body.buffer] : []
  postMessage(answer, { transfer })
}

async function move(command: LiveCommand): Promise<void> {
  try {
    engine ??= start()
    const { live } = await engine
    loop ??= new LiveLoop(live, {
      send,
      later(does) {
        next = does
        channel.port2.postMessage(null)
      },
      now: () => performance.now(),
    })
  } catch (error) {
    engine = null
    return send({ live: 'failed', message: said(error) })
  }
  attempt(() => loop?.take(command))
}

function said(error: unknown): string {
  return error instanceof Error ? error.message : String(error)
}

addEventListener('message', ({ data }: MessageEvent<string | EngineRequest | LiveCommand>) => {
  if (typeof data === 'string') {
    address = data
    engine = start()
    engine.catch(() => {}) // said with the first reply
    return
  }
  if ('live' in data) return void move(data)
  void reply(data).then((said) => postMessage(said, { transfer: 'body' in said ? [said.body.buffer] : [] }))
})
