// A service of its own and a browser on its page, for the tests of the page. What the browser says against the page
// (errors, blocked by policy, requests to elsewhere) is collected in `complaints`.
import assert from 'node:assert/strict'
import { execFileSync, spawn } from 'node:child_process'
import { mkdtempSync, readFileSync, rmSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { fileURLToPath } from 'node:url'
import { createRequire } from 'node:module'
import { after, before } from 'node:test'
import { chromium } from 'playwright-core'

export const ROOT = fileURLToPath(new URL('../../../../', import.meta.url))
const SERVER = process.env.COAPT_SERVER_PROGRAM ?? join(ROOT, 'build/release/bin/coapt-server')
const BROWSER = process.env.CHROMIUM ?? '/usr/bin/chromium'
const AXE = createRequire(import.meta.url).resolve('axe-core/axe.min.js')
export const PATIENCE_MS = Number(process.env.COAPT_PATIENCE_MS ?? 1_200_000) // machines are shared and slow

/// The service; `stop` ends it and removes what it kept, `kill` leaves that for another one at the same place.
export async function startService(
  flags = [],
  { port = 0, folder = mkdtempSync(join(tmpdir(), 'coapt-page-')), web = join(ROOT, 'build/web') } = {},
) {
  const child = spawn(
    SERVER,
    [
      ...['--port', String(port), '--db', join(folder, 'jobs.sqlite'), '--web', web],
      ...['--no-token', '--request-seconds', String(PATIENCE_MS / 1000), ...flags],
    ],
    {
      stdio: ['ignore', 'ignore', 'pipe'],
    },
  )
  let said = ''
  const url = await new Promise((resolve, reject) => {
    child.once('exit', () => reject(new Error(`the service ended: ${said}`)))
    child.stderr.on('data', (part) => {
      said += part
      const found = /listening on (http:\/\/\S+:\d+)\s/.exec(said) // whole: it may come in pieces
      if (found) resolve(found[1])
    })
  })
  const stop = () =>
    new Promise((resolve) => {
      child.once('exit', () => {
        rmSync(folder, { recursive: true, force: true })
        resolve()
      })
      child.kill('SIGTERM')
    })
  const kill = () =>
    new Promise((resolve) => {
      child.once('exit', resolve)
      child.kill('SIGKILL')
    })
  return { url, folder, stop, kill }
}

/// As examples/scripts/label_map.py draws it: the real valve, 0.8 mm voxels, labels with these names or without any.
export function labelMap(names = []) {
  const folder = mkdtempSync(join(tmpdir(), 'coapt-map-'))
  try {
    const file = join(folder, 'map.nrrd')
    const script = join(ROOT, 'examples/scripts/label_map.py')
    execFileSync('/usr/bin/python3', [script, '--voxel', '0.8', '-o', file], { stdio: 'pipe' })
    const [head, ...data] = readFileSync(file).toString('latin1').split('\n\n')
    const keys = names.flatMap((name, i) => [`Segment${i}_Name:=${name}`, `Segment${i}_LabelValue:=${i + 1}`])
    return Buffer.from([[head, ...keys].join('\n'), ...data].join('\n\n'), 'latin1')
  } finally {
    rmSync(folder, { recursive: true })
  }
}

export function startBrowser() {
  const args = ['--no-sandbox', '--use-gl=angle', '--use-angle=swiftshader', '--enable-unsafe-swiftshader']
  // The processor draws: nothing but WebGL as a graphics card would, and that without smoothing edges.
  args.push('--disable-gpu-compositing', '--webgl-msaa-sample-count=0')
  return chromium.launch({ executablePath: BROWSER, args })
}

/// A page with the view `name` and a closed valve in it.
export async function openView(
  browser,
  url,
  name,
  { width = 1280, height = 800, theme = 'light', motion = 'reduce' } = {},
) {
  const context = await browser.newContext({
    viewport: { width, height },
    colorScheme: theme,
    reducedMotion: motion,
  })
  const page = await context.newPage()
  page.setDefaultTimeout(PATIENCE_MS)
  const complaints = []
  page.on('pageerror', (error) => complaints.push(error.message))
  page.on('console', (message) => {
    if (message.type() === 'error' && !/\b(400|401|422)\b/.test(message.text())) complaints.push(message.text())
  })
  page.on('request', (request) => {
    if (!request.url().startsWith(url) && !/^(blob|data):/.test(request.url())) complaints.push(`asks ${request.url()}`)
  })
  await page.goto(`${url}/#${name}`)
  await page.locator('main h1').first().waitFor({ state: 'attached' })
  return { page, complaints }
}

/// Those of openBefore().
export let service, browser, page, complaints

/// Before the tests of a file a service, a browser and a page with the view `name`, for which `ready` waits, too; after them
/// nothing has been said against the page. A file is a process of its own: what it imports is its own.
export function openBefore(name, options = {}, ready = async () => {}) {
  before(async () => {
    service = await startService()
    browser = await startBrowser()
    ;({ page, complaints } = await openView(browser, service.url, name, options))
    await ready()
  })
  after(async () => {
    await browser.close()
    await service.stop()
    assert.deepEqual(complaints, [])
  })
}

/// When the page has laid out and drawn what it was asked for: its cameras jump, and a frame draws all of it.
export const settled = (of = page) =>
  of.evaluate(() => new Promise((seen) => requestAnimationFrame(() => requestAnimationFrame(seen))))

/// Gives the window another size; the page has followed it then.
export async function resize(width, height, of = page) {
  await of.setViewportSize({ width, height })
  await of.waitForFunction(([w, h]) => innerWidth === w && innerHeight === h, [width, height])
  await settled(of)
}

/// Where on the page the point is that a label names; the label may stand beside it.
export function namedPoint(viewer, label) {
  return viewer.locator('[data-part=labels]').evaluate((labels, wanted) => {
    const i = [...labels.querySelectorAll('span')].findIndex((span) => span.textContent === wanted)
    const { x2, y2 } = labels.querySelectorAll('line')[i]
    const { x, y } = labels.getBoundingClientRect()
    return { x: x + x2.baseVal.value, y: y + y2.baseVal.value }
  }, label)
}

/// What axe-core finds against the page as it is, as text.
export async function accessProblems(page) {
  await page.evaluate(() => document.fonts.ready)
  // The page's policy allows no script of a test's; the browser's own way in is not bound by it.
  if (!(await page.evaluate(() => 'axe' in globalThis))) await page.evaluate(readFileSync(AXE, 'utf8'))
  const { violations } = await page.evaluate(() => globalThis.axe.run(document, { resultTypes: ['violations'] }))
  return violations.map(({ id, nodes }) => `${id}: ${nodes.map((node) => node.html.slice(0, 160)).join(' | ')}`)
}
