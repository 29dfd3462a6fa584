// The npm package as a small service on this machine, for Slicer without a coapt-server: the paths of openapi.json that it has,
// plans as jobs. Usage: node module.mjs PACKAGE TOKEN-FILE. It ends with its standard input.
import { readFileSync } from 'node:fs'
import { createServer } from 'node:http'
import { pathToFileURL } from 'node:url'

const [folder, tokenFile] = process.argv.slice(2)
const token = readFileSync(tokenFile, 'utf8').trim()
const { load } = await import(pathToFileURL(`${folder}/index.js`))
const coapt = await load()
const jobs = []

const refusal = (error) => ({
  detail: error.message,
  problems: error.problems ?? [{ path: '', code: 'failed', message: error.message }],
})

function search({ valve, search }) {
  const stop = new AbortController()
  const self = `/v1/jobs/${jobs.length}`
  const job = { kind: 'plans', state: 'RUNNING', problems: [], plans: null }
  job.progress = { stage: 'searching', closures: 0, closures_planned: 0 }
  job.links = { self, cancel: `${self}:cancel`, result: `${self}/result` }
  const progress = (done, planned) => Object.assign(job.progress, { closures: done, closures_planned: planned })
  coapt
    .ask('/v1/plans', { valve, search: search ?? {} }, { progress, signal: stop.signal })
    .then(({ plans, any_competent }) => Object.assign(job, { state: 'SUCCEEDED', plans, any_competent }))
    .catch((error) => {
      job.state = stop.signal.aborted ? 'CANCELLED' : 'FAILED'
      job.problems = stop.signal.aborted ? [] : refusal(error).problems
    })
  jobs.push({ job, stop })
  return job
}

async function answer(method, path, body) {
  const [, number, cancels] = path.match(/^\/v1\/jobs\/(\d+)(:cancel)?$/) ?? []
  const known = jobs[number]
  if (known && cancels) {
    known.stop.abort()
    if (known.job.state === 'RUNNING') known.job.state = 'CANCELLED'
  }
  if (known) return known.job
  if (path === '/v1/presets') return { presets: coapt.presets }
  if (method === 'POST' && path === '/v1/plans') return search(JSON.parse(body))
  return await coapt.ask(path, body)
}

const server = createServer(async (request, response) => {
  const reply = (status, document) => {
    response.writeHead(status, { 'Content-Type': 'application/json' })
    response.end(JSON.stringify(document))
  }
  if (request.headers.authorization !== `Bearer ${token}`) return reply(401, { detail: 'requests need the token' })
  const parts = []
  for await (const part of request) parts.push(part)
  try {
    reply(200, await answer(request.method, request.url, Buffer.concat(parts).toString()))
  } catch (error) {
    reply(error.status ?? (error instanceof SyntaxError ? 400 : 500), refusal(error))
  }
})
server.listen(0, '127.0.0.1', () => console.log(`http://127.0.0.1:${server.address().port}`))
process.stdin.on('end', () => process.exit()).resume()
