// What the generated clients are for: a closure by each, and a search.
import createClient from 'openapi-fetch'
import { client } from './hey/client.gen'
import * as hey from './hey/sdk.gen'
import * as orval from './orval'
import type { paths } from './schema'

export async function run(url: string) {
  const fetched = createClient<paths>({ baseUrl: url })
  client.setConfig({ baseUrl: url })
  const direct = globalThis.fetch // orval's functions have no base
  globalThis.fetch = (at, options) => direct(typeof at === 'string' ? new URL(at, url) : at, options)

  const valve = 'human-functional-mr'
  const closures = [
    (await fetched.POST('/v1/closures', { body: { valve } })).data,
    (await hey.closeValve({ body: { valve } })).data,
    (await orval.closeValve({ valve })).data,
  ]
  const leaks = closures.map((closure) => (closure && 'leak' in closure ? closure.leak.area_mm2 : null))

  const search = { evaluations: 20, plans: 1, region_points: 1, evidence: false, model_draws: 0 }
  let job = (await hey.searchPlans({ body: { valve, search }, headers: { Prefer: 'wait=60' } })).data
  const params = { path: { job: job?.id ?? '' } }
  while (job?.state === 'QUEUED' || job?.state === 'RUNNING') {
    await new Promise((awake) => setTimeout(awake, 1000))
    job = (await fetched.GET('/v1/jobs/{job}', { params })).data
  }
  const result = (await fetched.GET('/v1/jobs/{job}/result', { params })).data
  const refused = (await fetched.POST('/v1/closures', { body: { valve: 'no-such-valve' } })).error
  return { leaks, state: job?.state, result, refused }
}
