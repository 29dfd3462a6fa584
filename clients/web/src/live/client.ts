// A thread of the engine with a valve that moves. It is another one than that of requests (static page), so that a closure of
// half a second does not hold up the hand; the script is the same, and it answers requests, too.
import { ApiError } from '../api/http'
import type { Plan, Problem, ValveShape } from '../api/types'
import type { LiveCommand, LiveReply } from '../engine/live_loop'

/// Of a valve that is started: what does not move.
export interface LiveValve {
  scene: ValveShape
  systole_mmhg: number
  cables: [chorda: number, segment: number][] // chorda -1: of a tie
  hooks: boolean[] // whether each holds something still
}

export type LivePicture = Extract<LiveReply, { live: 'picture' }>
type Hand = Exclude<LiveCommand, { live: 'start' | 'change' }>

/// Of a Worker, what is used here.
export interface LiveThread {
  postMessage(message: string | LiveCommand): void
  onmessage: ((event: MessageEvent<LiveReply>) => void) | null
  onerror: ((event: ErrorEvent) => void) | null
  terminate(): void
}

export const NO_SIMD = 'This needs WebAssembly with SIMD, which this browser does not have: use a newer one.'
const NO_ENGINE =
  'This needs the engine beside the page (coapt-engine.wasm), which is not there: make wasm builds it, then make web puts it there; start coapt-server anew.'

export class LiveClient {
  onPicture: (picture: LivePicture) => void = () => {}
  onFailure: (message: string) => void = () => {}
  private readonly waiting = new Map<number, { resolve(valve: LiveValve): void; reject(error: unknown): void }>()
  private count = 0

  /// `address`: of the engine's file.
  constructor(
    private readonly thread: LiveThread,
    address: string,
  ) {
    thread.postMessage(address)
    thread.onmessage = ({ data }) => this.take(data)
    thread.onerror = ({ message }) => this.fail(message || 'The engine cannot be started; reload the page.')
  }

  /// `valve`: a document, as text. Another valve, under the pressure of systole if none is said; rejects with an ApiError.
  start(valve: string, plan: Plan | null, pressure_mmhg?: number): Promise<LiveValve> {
    const pressure = pressure_mmhg === undefined ? '' : `,"pressure_mmhg":${pressure_mmhg}`
    return this.ask('start', `{"valve":${valve}${planField(plan)}${pressure}}`)
  }

  /// The same valve with another plan, or another valve with the same mesh: goes on from where the leaflets are.
  change(valve: string, plan: Plan | null): Promise<LiveValve> {
    return this.ask('change', `{"valve":${valve}${planField(plan)}}`)
  }

  send(command: Hand): void {
    this.thread.postMessage(command)
  }

  end(): void {
    this.thread.terminate()
  }

  private ask(live: 'start' | 'change', body: string): Promise<LiveValve> {
    const id = ++this.count
    return new Promise((resolve, reject) => {
      this.waiting.set(id, { resolve, reject })
      this.thread.postMessage({ live, body, id })
    })
  }

  private take(reply: LiveReply): void {
    if (reply.live === 'picture') this.onPicture(reply)
    else if (reply.live === 'failed') this.fail(reply.message)
    else this.answer(reply)
  }

  private answer({ id, status, body }: Extract<LiveReply, { live: 'started' }>): void {
    const asked = this.waiting.get(id)
    this.waiting.delete(id)
    const said: unknown = JSON.parse(new TextDecoder().decode(body))
    if (status === 200) {
      asked?.resolve(said as LiveValve)
      return
    }
    const { detail, problems } = said as { detail: string; problems: Problem[] }
    asked?.reject(new ApiError(status, detail, problems))
  }

  private fail(message: string): void {
    const words = engineWords(message)
    for (const { reject } of this.waiting.values()) reject(new Error(words))
    this.waiting.clear()
    this.onFailure(words)
  }
}

/// What its thread says, for a person.
export function engineWords(message: string): string {
  return message.includes('(404)') ? NO_ENGINE : message
}

function planField(plan: Plan | null): string {
  return plan ? `,"plan":${JSON.stringify(plan)}` : ''
}

// A function that returns a v128: (module (func (result v128) i32.const 0 i8x16.splat)).
const SIMD = [0, 97, 115, 109, 1, 0, 0, 0, 1, 5, 1, 96, 0, 1, 123, 3, 2, 1, 0, 10, 8, 1, 6, 0, 65, 0, 253, 15, 11]

export function hasSimd(): boolean {
  return typeof WebAssembly === 'object' && WebAssembly.validate(Uint8Array.from(SIMD))
}

/// Throws where the browser cannot.
export function startLive(): LiveClient {
  if (!hasSimd()) throw new Error(NO_SIMD)
  const thread = new Worker(new URL('../engine/worker.ts', import.meta.url), { type: 'module' })
  return new LiveClient(thread, new URL('coapt-engine.wasm', document.baseURI).href)
}
