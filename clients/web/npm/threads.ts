// Threads that compute one request each at a time. They start when they are needed, and a request that is aborted ends its thread.
import type { FromThread, ToThread } from './messages'

/// Of a Worker of browsers and one of node.
interface Thread {
  postMessage(message: ToThread): void
  terminate(): void
  listen(heard: (said: FromThread) => void, died: (why: Error) => void): void
  hold(busy: boolean): void // whether node waits for it before it ends
}

export interface Asked {
  path: string
  body: string
  signal?: AbortSignal | undefined
  progress?: ((done: number, planned: number) => void) | undefined
}
export type Answered = Extract<FromThread, { status: number }>

async function startThread(): Promise<Thread> {
  const address = new URL('./thread.js', import.meta.url)
  if (typeof Worker === 'function') {
    const worker = new Worker(address, { type: 'module' })
    return {
      postMessage: (message) => worker.postMessage(message),
      terminate: () => worker.terminate(),
      listen(heard, died) {
        worker.onmessage = ({ data }) => heard(data)
        worker.onerror = ({ message }) => died(new Error(message || 'the thread cannot be started'))
      },
      hold() {},
    }
  }
  const { Worker: NodeWorker } = await import('node:worker_threads')
  const worker = new NodeWorker(address, { execArgv: [] }) // none of the program's own
  return {
    postMessage: (message) => worker.postMessage(message),
    terminate: () => void worker.terminate(),
    listen(heard, died) {
      worker.removeAllListeners('message').removeAllListeners('error')
      worker.on('message', heard).on('error', died)
    },
    hold: (busy) => (busy ? worker.ref() : worker.unref()),
  }
}

export class Threads {
  private readonly idle: Thread[] = []
  private readonly waiting: (() => void)[] = [] // for the place of one that is computed
  private readonly computed = new Set<(why: unknown) => void>() // each ended by this
  private running = 0
  private ended = false

  constructor(
    private readonly module: WebAssembly.Module,
    private readonly most: number,
  ) {}

  /// Rejects with the signal's reason if that aborts, and with an Error if the module or its thread fails, or after end().
  async ask(asked: Asked): Promise<Answered> {
    asked.signal?.throwIfAborted()
    if (this.running < this.most) ++this.running
    else await this.turn(asked.signal)
    try {
      if (this.ended) throw closed()
      return await this.compute(asked)
    } finally {
      const next = this.waiting.shift()
      if (next) next()
      else --this.running
    }
  }

  end(): void {
    this.ended = true
    for (const thread of this.idle.splice(0)) thread.terminate()
    for (const stop of this.computed) stop(closed())
  }

  private turn(signal?: AbortSignal): Promise<void> {
    return new Promise((resolve, reject) => {
      const go = () => {
        signal?.removeEventListener('abort', leave)
        resolve()
      }
      const leave = () => {
        const at = this.waiting.indexOf(go)
        if (at >= 0) this.waiting.splice(at, 1)
        reject(signal?.reason)
      }
      signal?.addEventListener('abort', leave, { once: true })
      this.waiting.push(go)
    })
  }

  private async compute({ path, body, signal, progress }: Asked): Promise<Answered> {
    const thread = this.idle.pop() ?? (await this.start())
    thread.hold(true)
    const abort = () => stop(signal?.reason)
    let stop = (_why: unknown): void => {}
    try {
      const answer = await new Promise<Answered>((resolve, reject) => {
        stop = reject
        this.computed.add(stop)
        if (this.ended) return reject(closed())
        if (signal?.aborted) return abort()
        signal?.addEventListener('abort', abort, { once: true })
        thread.listen((said) => {
          if ('progress' in said) progress?.(...said.progress)
          else if ('failed' in said) reject(new Error(said.failed))
          else resolve(said)
        }, reject)
        thread.postMessage({ path, body })
      })
      this.idle.push(thread)
      thread.hold(false)
      return answer
    } catch (error) {
      thread.terminate() // it may be computing still, or its module may be of no use any more
      throw error
    } finally {
      this.computed.delete(stop)
      signal?.removeEventListener('abort', abort)
    }
  }

  private async start(): Promise<Thread> {
    const thread = await startThread()
    thread.postMessage({ module: this.module })
    return thread
  }
}

function closed(): Error {
  return new Error('coapt was closed')
}
