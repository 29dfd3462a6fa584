// A thread of the engine with a valve that moves. It is another one than that of requests (static page), so that a closure of
// half a second does not hold up the hand; the script is the same, and it answers requests, too.
import { refusal } from '../api/http'
import type { Plan, ValveShape } from '../api/types'
import type { LiveCommand, LiveReply } from '../engine/live_loop'
import { type EngineThread, engineWords, requireSimd, startThread } from '../engine/thread'
import { diedWords } from '../engine/threads'

/// Of a valve that is started: what does not move.
export interface LiveValve {
  scene: ValveShape
  systole_mmhg: number
  cables: [chorda: number, segment: number][] // chorda -1: of a tie
  hooks: boolean[] // whether each holds something still
}

export type LivePicture = Extract<LiveReply, { live: 'picture' }>
export type LiveThread = EngineThread<LiveCommand, LiveReply> & Pick<Worker, 'terminate'>
type Hand = Exclude<LiveCommand, { live: 'start' | 'change' }>

export class LiveClient {
  onPicture: (picture: LivePicture) => void = () => {}
  onFailure: (message: string) => void = () => {}
  private readonly waiting = new Map<number, { resolve(valve: LiveValve): void; reject(error: unknown): void }>()
  private count = 0

  constructor(private readonly thread: LiveThread) {
    thread.onmessage = ({ data }) => this.take(data)
    thread.onerror = (event) => this.fail(diedWords(event))
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
    if (status === 200) asked?.resolve(said as LiveValve)
    else asked?.reject(refusal(status, said))
  }

  private fail(message: string): void {
    const words = engineWords(message)
    for (const { reject } of this.waiting.values()) reject(new Error(words))
    this.waiting.clear()
    this.onFailure(words)
  }
}

function planField(plan: Plan | null): string {
  return plan ? `,"plan":${JSON.stringify(plan)}` : ''
}

/// Throws where the browser cannot.
export function startLive(): LiveClient {
  requireSimd()
  return new LiveClient(startThread())
}
