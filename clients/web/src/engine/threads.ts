// Threads that compute one request each at a time, of the page and of the package for npm. They start when they are needed. A search
// takes all that are idle: they make its closures together (team.ts), and leave it when something else waits.
import type { SearchProgress } from '../api/types'
import type { EngineReply, FromThread, ToThread } from './messages'
import type { EngineAnswer } from './module'
import { canShare, Team, type TeamPlace } from './team'

/// Of a Worker of browsers and one of node.
export interface Thread {
  postMessage(message: ToThread): void
  terminate(): void
  listen(heard: (said: FromThread) => void, died: (why: Error) => void): void
  hold(busy: boolean): void // whether node waits for it before it ends
}

export interface Asked {
  path: string
  body: string
  signal?: AbortSignal | undefined // rejects at once
  /// Ends a search with the best so far; as `signal` does where threads share no memory.
  finish?: AbortSignal | undefined
  progress?: ((now: SearchProgress) => void) | undefined
}

export type Ask = (asked: Asked) => Promise<EngineAnswer>

const SEARCHES = ['/v1/plans', '/v1/evaluations']
const PATIENCE_MS = 500 // with a thread whose answer nobody wants: a closure ends sooner than a module starts

export class Threads {
  private readonly idle: Thread[] = []
  private readonly waiting: (() => void)[] = [] // for a thread that is free
  private readonly computed = new Set<(why: unknown) => void>() // each ended by this
  private readonly helping: (() => void)[] = [] // leave their search
  private running = 0
  private ended = false

  /// `module`: is asked for with each thread; a request rejects as it does.
  constructor(
    private readonly module: () => Promise<WebAssembly.Module>,
    private readonly most: number,
    private readonly startThread: () => Promise<Thread>,
  ) {}

  /// Rejects with the signal's reason if that aborts, and with an Error if the module or its thread fails, or after end().
  async ask(asked: Asked): Promise<EngineAnswer> {
    asked.signal?.throwIfAborted()
    if (this.running < this.most) ++this.running
    else await this.turn(asked.signal)
    if (!SEARCHES.includes(asked.path)) return this.compute(asked)
    return canShare ? this.search(asked) : this.compute({ ...asked, signal: either(asked.signal, asked.finish) })
  }

  end(): void {
    this.ended = true
    for (const thread of this.idle.splice(0)) thread.terminate()
    for (const stop of this.computed) stop(closed())
  }

  private turn(signal?: AbortSignal): Promise<void> {
    this.helping.pop()?.()
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

  private release(): void {
    const next = this.waiting.shift()
    if (next) next()
    else --this.running
  }

  private async search(asked: Asked): Promise<EngineAnswer> {
    const workers = 1 + Math.max(0, this.most - this.running)
    const team = new Team(workers)
    const over = new AbortController()
    const answer = this.compute(asked, team.place(0))
    for (let number = 1; number < workers; ++number) this.help(asked, team, number, over.signal)
    const end = () => team.end()
    if (asked.finish?.aborted) end()
    asked.finish?.addEventListener('abort', end, { once: true })
    try {
      return await answer
    } finally {
      asked.finish?.removeEventListener('abort', end)
      end()
      over.abort()
    }
  }

  private help({ path, body }: Asked, team: Team, number: number, signal: AbortSignal): void {
    const leave = () => team.leave(number)
    ++this.running
    this.helping.push(leave)
    this.compute({ path, body, signal }, team.place(number))
      .catch(() => team.lose())
      .finally(() => {
        const at = this.helping.indexOf(leave)
        if (at >= 0) this.helping.splice(at, 1)
      })
  }

  /// By a thread that the caller has a turn for, which is another's when the thread is free again.
  private async compute({ path, body, signal, progress }: Asked, place?: TeamPlace): Promise<EngineAnswer> {
    let thread: Thread
    try {
      if (this.ended) throw closed()
      thread = this.idle.pop() ?? (await this.start())
    } catch (error) {
      this.release()
      throw error
    }
    thread.hold(true)
    return new Promise((resolve, reject) => {
      let patience: ReturnType<typeof setTimeout> | undefined
      const abort = () => {
        patience = setTimeout(() => free(false), PATIENCE_MS)
        reject(signal?.reason)
      }
      const stop = (why: unknown) => {
        free(false)
        reject(why)
      }
      const free = (isOfUse: boolean) => {
        if (!this.computed.delete(stop)) return
        clearTimeout(patience)
        signal?.removeEventListener('abort', abort)
        if (isOfUse && !this.ended) {
          thread.hold(false)
          this.idle.push(thread)
        } else thread.terminate()
        this.release()
      }
      this.computed.add(stop)
      if (this.ended) return stop(closed())
      thread.listen((message) => {
        const said = message as EngineReply // it moves no valve
        if ('progress' in said) return progress?.(said.progress)
        free(true)
        if ('failed' in said) reject(new Error(said.failed))
        else resolve(said)
      }, stop)
      if (signal?.aborted) {
        free(true)
        return reject(signal.reason)
      }
      signal?.addEventListener('abort', abort, { once: true })
      thread.postMessage({ path, body, ...(place && { place }) })
    })
  }

  private async start(): Promise<Thread> {
    const module = await this.module()
    const thread = await this.startThread()
    thread.postMessage({ module })
    return thread
  }
}

/// Of a Worker of the browser.
export function threadOf(worker: Worker): Thread {
  return {
    postMessage: (message) => worker.postMessage(message),
    terminate: () => worker.terminate(),
    listen(heard, died) {
      worker.onmessage = ({ data }) => heard(data)
      worker.onerror = (event) => died(new Error(diedWords(event)))
    },
    hold() {},
  }
}

/// Of a thread that has died.
export function diedWords({ message }: ErrorEvent): string {
  return message || 'The engine cannot be started; reload the page.'
}

function either(...signals: (AbortSignal | undefined)[]): AbortSignal {
  const both = new AbortController()
  for (const signal of signals) {
    if (signal?.aborted) both.abort(signal.reason)
    signal?.addEventListener('abort', () => both.abort(signal.reason), { once: true })
  }
  return both.signal
}

function closed(): Error {
  return new Error('coapt was closed')
}
