// Pictures for papers: what is saved is read back.
import assert from 'node:assert/strict'
import { copyFileSync, readFileSync } from 'node:fs'
import { join } from 'node:path'
import { test } from 'node:test'
import { openBefore, page, service } from './page.mjs'

openBefore('valve', {}, () => page.locator('[data-part=labels] [data-part=leak]').first().waitFor())

async function saved(format) {
  await page.getByLabel('Picture format').selectOption(format)
  const [download] = await Promise.all([
    page.waitForEvent('download'),
    page.getByRole('button', { name: 'Save picture' }).click(),
  ])
  const file = join(service.folder, download.suggestedFilename())
  await download.saveAs(file)
  if (process.env.KEEP) copyFileSync(file, join(process.env.KEEP, `${await page.title()}.${format}`))
  return { name: download.suggestedFilename(), bytes: readFileSync(file) }
}

/// Name and content of each chunk of a PNG.
function chunks(png) {
  const found = new Map()
  for (let at = 8; at < png.length; at += 12 + png.readUInt32BE(at))
    found.set(png.toString('latin1', at + 4, at + 8), png.subarray(at + 8, at + 8 + png.readUInt32BE(at)))
  return found
}

test('a PNG is 180 mm wide at 300 dpi', async () => {
  const { name, bytes } = await saved('png')
  assert.equal(name, 'human-functional-mr.png')
  const parts = chunks(bytes)
  const width = parts.get('IHDR').readUInt32BE(0)
  assert.equal(width, 2126)
  assert.equal(parts.get('pHYs').readUInt32BE(0), 11811) // a metre, across
  assert.equal(parts.get('pHYs').readUInt32BE(4), 11811)
  assert.equal(parts.get('pHYs')[8], 1)
  assert.ok(Math.abs((1000 * width) / 11811 - 180) < 0.1)
})

test('an SVG has its size in millimetres, and words, scale bar, leak and notice as text', async () => {
  const { name, bytes } = await saved('svg')
  assert.equal(name, 'human-functional-mr.svg')
  const drawing = bytes.toString('utf8')
  assert.match(drawing, /<svg[^>]* width="180mm" height="\d+\.\d\dmm"/)
  for (const words of [
    'human-functional-mr',
    /Leak \d+ ± \d+ mm² at [AP]\d and [AP]\d, \d+\.\d mm wide/,
    />10 mm</,
    />A2</,
    />\d+ mm²</,
    /opening, darker where wider/,
    /coapt: research software, not a medical device/,
  ])
    assert.match(drawing, new RegExp(words))
  assert.match(drawing, /<image href="data:image\/png;base64,/)
})

test('the scale bar is as long as 10 mm of the annulus, seen from the atrium', async () => {
  const drawing = (await saved('svg')).bytes.toString('utf8')
  const [, x1, x2] = drawing.match(/<line x1="([\d.]+)"[^>]* x2="([\d.]+)"[^>]* stroke-width="0\.6"/).map(Number)
  const place = (name) => Number(drawing.match(new RegExp(`<text x="([\\d.]+)"[^>]*>${name}<`))[1])
  const across = place('PM commissure') - place('AL commissure') // names stand 1.14 times as far apart
  const scene = await (
    await fetch(`${service.url}/v1/scenes`, { method: 'POST', body: '{"valve": "human-functional-mr"}' })
  ).json()
  const at = (vertex) => scene.rest_mm.slice(3 * vertex, 3 * vertex + 3)
  const { anterolateral_commissure: al, posteromedial_commissure: pm } = scene.landmarks
  const expected = 1.14 * Math.hypot(...at(al).map((part, axis) => part - at(pm)[axis]))
  const measured = (10 * across) / (x2 - x1)
  assert.ok(Math.abs(measured / expected - 1) < 0.05, `${measured} mm, not ${expected} mm`)
})

test('colours of strain bring their scale', async () => {
  await page.getByRole('combobox', { name: 'Colours' }).selectOption('strain_radial')
  const drawing = (await saved('svg')).bytes.toString('utf8')
  assert.match(drawing, /linearGradient/)
  assert.match(drawing, /radial strain of the closed valve/)
})

test('a repair is drawn beside the valve before it, with its steps', async () => {
  await page.goto(`${service.url}/#/repair?valve=human-functional-mr`)
  await page.getByRole('button', { name: 'Ring', exact: true }).click()
  await page.locator('[data-part=answer]', { hasText: 'Closed and measured' }).waitFor()
  const drawing = (await saved('svg')).bytes.toString('utf8')
  assert.equal(drawing.match(/<image /g).length, 2)
  for (const words of [/>Before</, />Repaired</, />ring</, /1\. Ring in the annulus/, /Leak \d+ → [\d.]+ ± [\d.]+ mm²/])
    assert.match(drawing, words)
  assert.equal(
    chunks((await saved('png')).bytes)
      .get('IHDR')
      .readUInt32BE(0),
    2126,
  )
})
