// What the page weighs, and that the service hands it out as it should.
import assert from 'node:assert/strict'
import { readdirSync, readFileSync } from 'node:fs'
import { fileURLToPath } from 'node:url'
import { gzipSync } from 'node:zlib'
import { after, before, test } from 'node:test'
import { startService } from './page.mjs'

const BUILT = fileURLToPath(new URL('../../../../build/web/', import.meta.url))
const MOST_BYTES = 400_000 // compressed

let service
before(async () => {
  service = await startService()
})
after(() => service.stop())

test('all of it is below 400 kB, compressed', () => {
  const files = ['index.html', 'favicon.svg', ...readdirSync(`${BUILT}assets`).map((name) => `assets/${name}`)]
  const bytes = files.map((name) => gzipSync(readFileSync(BUILT + name)).length).reduce((sum, size) => sum + size)
  console.log(`the page: ${bytes} bytes compressed`)
  assert.ok(bytes < MOST_BYTES)
})

test('the page may run its own scripts only, and its assets are kept', async () => {
  const page = await fetch(service.url)
  const policy = page.headers.get('content-security-policy')
  assert.match(policy, /default-src 'none'; script-src 'self' 'wasm-unsafe-eval'; worker-src 'self'; style-src 'self'/)
  assert.doesNotMatch(policy, /'unsafe/)
  assert.equal(page.headers.get('cache-control'), 'no-cache')
  const asset = /\/assets\/[^"]+\.js/.exec(await page.text())[0]
  const script = await fetch(service.url + asset)
  assert.equal(script.headers.get('content-type'), 'text/javascript; charset=utf-8')
  assert.match(script.headers.get('cache-control'), /immutable/)
})

test('there is nothing beside the files of the page', async () => {
  for (const path of ['/assets/', '/assets/none.js', '/assets/..%2f..%2fMakefile', '/index.html', '/assets/%00'])
    assert.ok([400, 404].includes((await fetch(service.url + path)).status), path)
})
