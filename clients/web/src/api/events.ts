// Server-sent events over fetch: EventSource cannot carry a token.
import { noAnswer } from './health'
import { ApiError, request } from './http'

export interface ServerEvent {
  id: string
  event: string
  data: string
}

/// Splits a stream into events as its text comes in; what has no blank line after it yet waits for the rest.
export class EventReader {
  private rest = ''

  read(text: string): ServerEvent[] {
    const parts = (this.rest + text).split('\n\n')
    this.rest = parts.pop() ?? ''
    const events: ServerEvent[] = []
    for (const part of parts) {
      const event: ServerEvent = { id: '', event: 'message', data: '' }
      for (const line of part.split('\n')) {
        const colon = line.indexOf(': ')
        const name = line.slice(0, colon)
        if (name === 'id' || name === 'event' || name === 'data') event[name] = line.slice(colon + 2)
      }
      if (event.data !== '') events.push(event)
    }
    return events
  }
}

const PAUSE_MS = 1000

/// Follows a job's events until it has ended or `signal` says so, and goes on after a lost connection where it was.
/// `seen` is called for each event. A service without time is waited for; what it refuses otherwise is thrown at once.
export async function follow(path: string, seen: (event: ServerEvent) => void, signal: AbortSignal): Promise<void> {
  let last = '0'
  while (!signal.aborted) {
    try {
      const response = await request('GET', `${path}?last_event_id=${last}`, undefined, signal)
      if (response.status === 204 || response.body === null) return
      const reader = new EventReader()
      const decoder = new TextDecoder()
      const stream = response.body.getReader()
      for (;;) {
        const { done, value } = await stream.read()
        if (done) break
        for (const event of reader.read(decoder.decode(value, { stream: true }))) {
          last = event.id
          seen(event)
        }
      }
    } catch (error) {
      if (signal.aborted) return
      if (!(error instanceof ApiError)) noAnswer()
      const isBusy = error instanceof ApiError && (error.status === 429 || error.status === 503)
      if (!isBusy && error instanceof ApiError) throw error
      await new Promise((resolve) => setTimeout(resolve, PAUSE_MS))
    }
  }
}
