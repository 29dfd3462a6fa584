// Searches in place of coapt-server's jobs, for the page without one, kept as long as the page is open.
import type { Job, JobProgress } from '../api/types'
import type { EngineAnswer } from './module'
import type { Ask } from './threads'

export interface LocalJobs {
  /// Searches for plans of a valve, given as its `reference` and a whole request as text. What is refused is answered at once.
  start(reference: string, request: string): Promise<Response>
  /// GET, POST and DELETE below /v1/jobs; null: there is nothing of that kind.
  answer(method: string, path: string): Response | null
}

interface Search {
  job: Job
  events: string[] // as a stream of server-sent events has them
  result: string // JSON; '' before the end
  stop: AbortController // drops it
  finish: AbortController // ends it with what it has
  waiting: (() => void)[] // for the next event
}

const PLANS = /^\/plans\/([1-9][0-9]*)$/

export function localJobs(ask: Ask, now_ms: () => number = Date.now): LocalJobs {
  const searches = new Map<string, Search>()
  let count = 0

  function start(reference: string, body: string): Promise<Response> {
    if ([...searches.values()].some(({ job }) => job.finished === null))
      return Promise.resolve(refusal(409, 'a search is already running in this page; wait for it, or cancel it'))
    const search: Search = {
      job: newJob(`here-${++count}`, reference, time(now_ms())),
      events: [],
      result: '',
      stop: new AbortController(),
      finish: new AbortController(),
      waiting: [],
    }
    const begun_ms = now_ms()
    return new Promise((resolve) => {
      /// The first sign of life: a request that is refused has none but its answer.
      const begin = () => {
        if (searches.has(search.job.id) || search.stop.signal.aborted) return
        searches.set(search.job.id, search)
        resolve(json(202, search.job))
      }
      ask({
        path: '/v1/plans',
        body,
        signal: search.stop.signal,
        finish: search.finish.signal,
        progress(now) {
          begin()
          tell(search, 'progress', { ...now, seconds: (now_ms() - begun_ms) / 1e3 })
        },
      }).then(
        (answered) => {
          const text = new TextDecoder().decode(answered.body)
          if (!searches.has(search.job.id) && answered.status >= 400)
            return resolve(new Response(text, { status: answered.status, headers: JSON_TYPE }))
          begin()
          settle(search, answered, text)
        },
        (error: Error) => {
          begin()
          if (search.finish.signal.aborted) end(search, 'CANCELLED', {})
          else fail(search, error.message)
        },
      )
    })
  }

  function tell(search: Search, event: string, data: object): void {
    if (event === 'progress') search.job = { ...search.job, progress: data as JobProgress }
    search.events.push(`id: ${search.events.length + 1}\nevent: ${event}\ndata: ${JSON.stringify(data)}\n\n`)
    for (const hear of search.waiting.splice(0)) hear()
  }

  function end(search: Search, state: Job['state'], more: Partial<Job>): void {
    if (search.job.finished !== null) return
    search.job = { ...search.job, state, finished: time(now_ms()), ...more }
    tell(search, 'state', { state })
  }

  function settle(search: Search, { status }: EngineAnswer, text: string): void {
    const said = JSON.parse(text) as { detail?: string; stop?: string }
    if (status >= 400) {
      fail(search, said.detail ?? '')
      return
    }
    search.result = text
    const links = { ...search.job.links, result: `${search.job.links.self}/result` }
    end(search, said.stop === 'cancelled' ? 'CANCELLED' : 'SUCCEEDED', { links })
  }

  function fail(search: Search, message: string): void {
    end(search, 'FAILED', { problems: [{ code: 'unsupported', path: '', message }] })
  }

  /// From after `last` on, until the search has ended.
  function stream(search: Search, last: number): Response {
    if (search.job.finished !== null && last >= search.events.length) return new Response(null, { status: 204 })
    let next = last
    const encoder = new TextEncoder()
    const body = new ReadableStream<Uint8Array<ArrayBuffer>>({
      async pull(controller) {
        while (next >= search.events.length && search.job.finished === null)
          await new Promise<void>((resolve) => search.waiting.push(resolve))
        for (const event of search.events.slice(next)) controller.enqueue(encoder.encode(event))
        next = search.events.length
        if (search.job.finished !== null) controller.close()
      },
    })
    return new Response(body, { headers: { 'Content-Type': 'text/event-stream' } })
  }

  function answer(method: string, path: string): Response | null {
    const [place = '', query = ''] = path.split('?', 2)
    if (`${method} ${place}` === 'GET /v1/jobs')
      return json(200, { jobs: [...searches.values()].reverse().map(({ job }) => job) })
    const [, id = '', rest = ''] = /^\/v1\/jobs\/([^/:]+)(.*)$/.exec(place) ?? []
    const search = searches.get(id)
    if (search === undefined)
      return id === ''
        ? null
        : refusal(404, 'there is no such job; without coapt-server the page keeps searches only while it is open')
    switch (`${method} ${rest}`) {
      case 'GET ':
        return json(200, search.job)
      case 'DELETE ':
        search.stop.abort()
        end(search, 'CANCELLED', {})
        searches.delete(id)
        return new Response(null, { status: 204 })
      case 'POST :cancel':
        search.job = { ...search.job, cancel_requested: true }
        search.finish.abort()
        return json(200, search.job)
      case 'GET /events':
        return stream(search, Number(new URLSearchParams(query).get('last_event_id') ?? 0))
      case 'GET /result':
        if (search.result !== '') return new Response(search.result, { headers: JSON_TYPE })
    }
    const rank = PLANS.exec(rest)?.[1]
    if (method !== 'GET' || rank === undefined || search.result === '') return null
    const { plans } = JSON.parse(search.result) as { plans: object[] }
    const plan = plans[Number(rank) - 1]
    return plan ? json(200, plan) : refusal(404, `there is no plan ${rank}`)
  }

  return { start, answer }
}

const JSON_TYPE = { 'Content-Type': 'application/json' }

function json(status: number, value: object): Response {
  return new Response(JSON.stringify(value), { status, headers: JSON_TYPE })
}

function refusal(status: number, detail: string): Response {
  return json(status, { status, detail, problems: [] })
}

function time(ms: number): string {
  return new Date(ms).toISOString()
}

function newJob(id: string, valve: string, created: string): Job {
  const self = `/v1/jobs/${id}`
  return {
    id,
    kind: 'plans',
    state: 'RUNNING',
    created,
    started: created,
    finished: null,
    valve,
    cancel_requested: false,
    waiting_for: null,
    queue_position: null,
    progress: {
      stage: 'searching',
      closures: 0,
      closures_planned: 0,
      best_leak_mm2: null,
      best_cost: null,
      random_cost: null,
      seconds: 0,
    },
    problems: [],
    links: { self, events: `${self}/events`, cancel: `${self}:cancel` },
  }
}
