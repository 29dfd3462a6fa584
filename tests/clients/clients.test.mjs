// Clients that three generators make of the contract compile in strict TypeScript, and run against a server.
// node --test clients.test.mjs, with NODE_MODULES (of package.json), PROGRAMS and CONTRACT in the environment.
import assert from 'node:assert/strict'
import { execFileSync, spawn } from 'node:child_process'
import { copyFileSync, mkdtempSync, rmSync, symlinkSync, writeFileSync } from 'node:fs'
import { createRequire } from 'node:module'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { after, before, test } from 'node:test'

const { NODE_MODULES, PROGRAMS, CONTRACT } = process.env
const folder = mkdtempSync(join(tmpdir(), 'coapt-clients-'))
const call = (program, ...options) =>
  execFileSync(join(NODE_MODULES, '.bin', program), options, { cwd: folder, stdio: ['ignore', 'pipe', 'pipe'] })
let server, url

before(async () => {
  symlinkSync(NODE_MODULES, join(folder, 'node_modules'))
  copyFileSync(CONTRACT, join(folder, 'openapi.json'))
  copyFileSync(new URL('run.ts', import.meta.url), join(folder, 'run.ts'))
  server = spawn(join(PROGRAMS, 'coapt-server'), ['--port', '0', '--no-token', '--db', join(folder, 'jobs.sqlite')])
  let said = ''
  url = await new Promise((found, failed) => {
    server.once('exit', () => failed(new Error(`the service ended: ${said}`)))
    server.stderr.on('data', (part) => {
      said += part
      const address = /listening on (http:\S+)\n/.exec(said) // whole: it may come in pieces
      if (address) found(address[1])
    })
  })
})

after(() => {
  server.kill()
  rmSync(folder, { recursive: true, force: true })
})

test('generated clients compile and run', async () => {
  call('openapi-typescript', 'openapi.json', '-o', 'schema.ts')
  call('openapi-ts', '-i', 'openapi.json', '-o', 'hey', '-c', '@hey-api/client-fetch')
  call('orval', '--input', 'openapi.json', '--output', 'orval.ts', '--client', 'fetch')
  const options = { strict: true, target: 'ES2022', module: 'CommonJS', moduleResolution: 'node10', outDir: 'out' }
  const libraries = { lib: ['ES2022', 'DOM', 'DOM.Iterable'], types: [], skipLibCheck: true }
  const project = { compilerOptions: { ...options, ...libraries }, files: ['run.ts'] }
  writeFileSync(join(folder, 'tsconfig.json'), JSON.stringify(project))
  call('tsc', '-p', '.')

  const { run } = createRequire(import.meta.url)(join(folder, 'out', 'run.js'))
  const { leaks, state, result, refused } = await run(url)
  assert.ok(leaks[0] > 0)
  assert.deepEqual(leaks, [leaks[0], leaks[0], leaks[0]])
  assert.equal(state, 'SUCCEEDED')
  assert.ok(Array.isArray(result.plans[0].steps))
  assert.equal(refused.status, 422)
})
