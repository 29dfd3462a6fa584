// A thread of the engine, in a browser or in node, so that whoever asks stays responsive while a valve closes or moves.
import { type LiveCommand, LiveLoop, type LiveReply } from './live_loop'
import type { EngineReply, EngineRequest, FromThread, ToThread } from './messages'
import { type Engine, startEngine } from './module'

/// Of a worker's own scope, and of node's parentPort.
export interface Port {
  postMessage(message: FromThread, transfer: Transferable[]): void
  onmessage: ((event: { data: ToThread }) => void) | null
}

const decoder = new TextDecoder()

export function serve(port: Port): void {
  let give: (module: WebAssembly.Module) => void
  let refuse: (why: Error) => void
  const module = new Promise<WebAssembly.Module>((resolve, reject) => {
    give = resolve
    refuse = reject
  })
  module.catch(() => {}) // said with the first reply
  let engine: Promise<Engine> | null = null // after a failure another one is started with the next request
  let loop: LiveLoop | null = null

  const start = async () =>
    startEngine(await module, (now) => port.postMessage({ progress: JSON.parse(decoder.decode(now)) }, []))

  async function reply({ path, body, place }: EngineRequest): Promise<EngineReply> {
    try {
      engine ??= start()
      return (await engine).answer(path, body, place)
    } catch (error) {
      engine = null
      return { failed: said(error) }
    }
  }

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
    port.postMessage(answer, transfer)
  }

  async function move(command: LiveCommand): Promise<void> {
    try {
      engine ??= start()
      const { live } = await engine
      loop ??= new LiveLoop(live, { send, later: soon(attempt), now: () => performance.now() })
    } catch (error) {
      engine = null
      return send({ live: 'failed', message: said(error) })
    }
    attempt(() => loop?.take(command))
  }

  port.onmessage = ({ data }) => {
    if ('module' in data) give(data.module)
    else if ('missing' in data) refuse(new Error(data.missing))
    else if ('live' in data) void move(data)
    else void reply(data).then((said) => port.postMessage(said, 'body' in said ? [said.body.buffer] : []))
  }
}

/// Calls what it is given by `attempt`, after the messages that wait: a timer would wait for 4 ms.
function soon(attempt: (does: () => void) => void): (does: () => void) => void {
  const channel = new MessageChannel()
  let next = (): void => {}
  channel.port1.onmessage = () => attempt(next)
  return (does) => {
    next = does
    channel.port2.postMessage(null)
  }
}

function said(error: unknown): string {
  return error instanceof Error ? error.message : String(error)
}
