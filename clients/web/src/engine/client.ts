// Requests to the engine's thread, one at a time.
import type { EngineAnswer } from './module'
import { diedWords, type EngineThread } from './thread'
import type { EngineReply, EngineRequest } from './worker'

export type AskEngine = (path: string, body: string, signal?: AbortSignal) => Promise<EngineAnswer>

interface Waiting {
  request: EngineRequest
  signal: AbortSignal | undefined
  resolve(answer: EngineAnswer): void
  reject(error: unknown): void
}

/// What is aborted while it waits is never computed; what is being computed is finished and dropped, for a thread cannot be
/// interrupted.
export function engineClient(thread: EngineThread<EngineRequest, EngineReply>): AskEngine {
  const waiting: Waiting[] = []
  let running: Waiting | null = null
  let dead: Error | null = null // the thread, of an error of its own
  thread.onmessage = ({ data }) => {
    if ('progress' in data) return // nobody looks
    end((asked) => ('failed' in data ? asked.reject(new Error(data.failed)) : asked.resolve(data)))
  }
  thread.onerror = (event) => {
    dead = new Error(diedWords(event))
    end((asked) => asked.reject(dead))
  }

  function end(settle: (asked: Waiting) => void): void {
    if (running) settle(running)
    running = null
    next()
  }

  function next(): void {
    while (!running && waiting.length > 0) {
      const first = waiting.shift() as Waiting
      if (first.signal?.aborted) continue
      if (dead) {
        first.reject(dead)
        continue
      }
      running = first
      thread.postMessage(first.request)
    }
  }

  return (path, body, signal) =>
    new Promise((resolve, reject) => {
      signal?.throwIfAborted()
      signal?.addEventListener('abort', () => reject(signal.reason), { once: true })
      waiting.push({ request: { path, body }, signal, resolve, reject })
      next()
    })
}
