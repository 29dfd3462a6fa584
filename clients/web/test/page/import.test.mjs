// Files of a segmentation tool become a valve; what is wrong stands beside the file.
import assert from 'node:assert/strict'
import { mkdirSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { test } from 'node:test'
import { gunzipSync, gzipSync } from 'node:zlib'
import { accessProblems, labelMap, ROOT, openBefore, page, service, settled } from './page.mjs'

const CONTRACT = JSON.parse(readFileSync(join(ROOT, 'server/openapi.json')))
const { leaflets, annulus, chordae } = CONTRACT.components.examples.one_skirt.value
const fileOf = ({ name, text }) => ({ name, mimeType: 'text/plain', buffer: Buffer.from(text) })

openBefore('valve')

test('a damaged file is named, the others are not; the whole set becomes a valve that is shown', async () => {
  await page.getByText('Import meshes').click()
  const panel = page.locator('[data-part=import]')
  const damaged = { ...annulus, text: annulus.text.replace(/\d+\.\d/, 'nowhere') }
  await panel.getByLabel('Files', { exact: true }).setInputFiles([...leaflets, damaged, chordae].map(fileOf))
  assert.equal(await panel.getByLabel('What skirt.obj is').inputValue(), 'detected')
  assert.equal(await panel.getByLabel('What annulus.csv is').inputValue(), 'detected')
  await panel.getByRole('button', { name: 'Import', exact: true }).click()
  const rows = panel.locator('li', { has: page.locator('select') })
  await rows.filter({ hasText: 'annulus.csv' }).locator('[data-part=problems] li').waitFor()
  assert.equal(await rows.filter({ hasText: 'chordae.csv' }).locator('[data-part=problems] li').count(), 0)
  await panel.getByText('No valve can be made from these files: one problem.').waitFor()

  await panel.getByLabel('Files', { exact: true }).setInputFiles([...leaflets, annulus, chordae].map(fileOf))
  await panel.getByLabel('Name').fill('my first import')
  await panel.getByLabel('Triangles').fill('100')
  await panel.getByRole('button', { name: 'Import', exact: true }).click()
  await page.getByText('my first import is open.').waitFor()
  assert.match(page.url(), /valve=[0-9a-f]{64}/)
})

test('files dropped on the page are seen before they are imported, a landmark is picked, the result leads to a search', async () => {
  await page.goto(`${service.url}/#/valve`)
  const dropped = await page.evaluateHandle(
    (files) => {
      const data = new DataTransfer()
      for (const { name, text } of files) data.items.add(new File([text], name))
      return data
    },
    [...leaflets, annulus, chordae],
  )
  await page.locator('main > div').dispatchEvent('drop', { dataTransfer: dropped })
  const panel = page.locator('[data-part=import]')
  await panel.getByText('10 chordae').waitFor()
  const files = page.locator('[data-part=input-viewer] canvas')
  await files.waitFor()

  await panel.getByText('Pick landmarks').click()
  const pick = panel.getByRole('button', { name: 'Pick Mid-anterior' })
  await pick.click()
  assert.equal(await pick.getAttribute('aria-pressed'), 'true')
  await page.getByRole('button', { name: 'From the atrium' }).click()
  await settled()
  const { x, y, width, height } = await files.boundingBox()
  const place = panel.getByLabel('Mid-anterior: x, y, z')
  for (let share = 0.05; share < 0.5 && (await place.inputValue()) === ''; share += 0.02)
    await page.mouse.click(x + width / 2, y + share * height)
  const [across, forwards] = (await place.inputValue()).split(', ').map(Number)
  assert.ok(Math.abs(across) < 3 && forwards > 10, `${across}, ${forwards}`)
  assert.equal(await pick.getAttribute('aria-pressed'), 'false')
  assert.deepEqual(await accessProblems(page), [])

  await panel.getByLabel('Mid-posterior: x, y, z').fill('nowhere')
  await panel.getByLabel('Mid-posterior: x, y, z').blur()
  assert.equal(await panel.getByLabel('Mid-posterior: x, y, z').getAttribute('aria-invalid'), 'true')
  await panel.getByLabel('Mid-posterior: x, y, z').fill('0, -80, 0')
  await panel.getByRole('button', { name: 'Import', exact: true }).click()
  await panel.getByText('lies', { exact: false }).waitFor()
  await panel.getByLabel('Mid-posterior: x, y, z').fill('')
  await panel.getByRole('button', { name: 'Import', exact: true }).click()
  const result = page.locator('[data-part=import-result]')
  await result.waitFor()
  await result
    .locator('img')
    .first()
    .evaluate((picture) => picture.decode())
  assert.match(await result.textContent(), /saddle peak as given/)
  assert.deepEqual(await accessProblems(page), [])
  await result.getByRole('link', { name: 'Continue to search' }).click()
  await page.getByRole('button', { name: 'Start the search' }).waitFor()
  assert.match(page.url(), /#\/search\?valve=[0-9a-f]{64}/)
})

test('a valve is fitted to closed leaflets', async () => {
  const ask = (path, body) =>
    fetch(service.url + path, {
      method: 'POST',
      headers: { 'Content-Type': 'application/json' },
      body: JSON.stringify(body),
    })
  const { id } = await (await ask('/v1/valves:import', { leaflets, annulus, chordae, triangles: 300 })).json()
  const closed = Buffer.from(await (await ask('/v1/exports', { valve: id, format: 'stl' })).arrayBuffer())
  await page.goto(`${service.url}/#/valve`)
  const panel = page.locator('[data-part=import]')
  await panel
    .getByLabel('Files', { exact: true })
    .setInputFiles([
      ...[...leaflets, annulus, chordae].map(fileOf),
      { name: 'closed.stl', mimeType: 'model/stl', buffer: closed },
    ])
  assert.equal(await panel.getByLabel('What closed.stl is').inputValue(), 'surface')
  await panel.getByText('10 chordae').waitFor()
  await panel.getByLabel('Triangles').fill('300')
  await panel.getByLabel('Segmented surface').selectOption('middle')
  await panel.getByRole('button', { name: 'Import and fit' }).click()
  const fit = page.locator('[data-part=fit]')
  await fit.waitFor()
  assert.match(await fit.textContent(), /distance, rms\d\.\d+ mm before, 0\.[0-3]\d mm after/)
})

/// Left in build/pages, with what came of an import whole on it.
async function picture(result, name) {
  const drawn = result.locator('img').first()
  await drawn.evaluate((image) => image.decode())
  await page.setViewportSize({ width: 1280, height: 1500 })
  mkdirSync(join(ROOT, 'build/pages'), { recursive: true })
  await page.screenshot({ path: join(ROOT, 'build/pages', `${name}.png`) })
  await page.setViewportSize({ width: 1280, height: 800 })
}

test('a label map dropped on the page becomes a valve, and that a search', async () => {
  await page.goto(`${service.url}/#/valve`)
  const dropped = await page.evaluateHandle((letters) => {
    const data = new DataTransfer()
    data.items.add(new File([Uint8Array.from(atob(letters), (letter) => letter.charCodeAt(0))], 'map.nrrd'))
    return data
  }, labelMap().toString('base64'))
  await page.locator('main > div').dispatchEvent('drop', { dataTransfer: dropped })
  const panel = page.locator('[data-part=import]')
  await panel.getByText('triangles', { exact: false }).first().waitFor()
  await page.locator('[data-part=input-viewer] canvas').waitFor()
  assert.equal(await panel.getByLabel('What map.nrrd is').inputValue(), 'detected')
  assert.ok(await panel.getByLabel('Synthesise chordae').isChecked())
  await panel.getByLabel('Name').fill('from a label map')
  await panel.getByRole('button', { name: 'Import', exact: true }).click()
  await page.getByText('from a label map is open.').waitFor()

  const result = page.locator('[data-part=import-result]')
  await result
    .locator('img')
    .first()
    .evaluate((picture) => picture.decode())
  const decisions = await result.textContent()
  for (const words of [
    'label 1 is the anterior leaflet',
    'replaced by its mid-surface',
    'imaged open',
    'not imaged; synthesised',
  ])
    assert.ok(decisions.includes(words), words)
  assert.deepEqual(await accessProblems(page), [])

  await result.getByRole('link', { name: 'Continue to search' }).click()
  await page.locator('[data-part=form] h2', { hasText: 'from a label map' }).waitFor()
  const folds = page.locator('[data-part=form] details', { hasText: 'Optimiser' })
  await folds.evaluate((details) => (details.open = true))
  for (const [label, value] of [
    ['Closures', '12'],
    ['Plans to show', '1'],
    ['Region points', '5'],
  ])
    await page.getByLabel(label, { exact: true }).fill(value)
  await page.getByLabel('Evidence').uncheck()
  await page.getByRole('button', { name: 'Start the search' }).click()
  await page.locator('[data-part=plan]').first().waitFor()
})

test('labels with the names of each other are refused, then trusted, then mended by one control', async () => {
  await page.goto(`${service.url}/#/valve`)
  const panel = page.locator('[data-part=import]')
  const names = ['Posterior leaflet', 'Anterior leaflet']
  await panel
    .getByLabel('Files', { exact: true })
    .setInputFiles({ name: 'map.nrrd', mimeType: 'image/nrrd', buffer: labelMap(names) })
  await panel.getByLabel('What label 1 is').waitFor()
  await panel.getByLabel('Name').fill('named the other way round')
  await panel.getByRole('button', { name: 'Import', exact: true }).click()
  const problem = panel.locator('[data-part=problems] li')
  assert.match(
    await problem.textContent(),
    /has the shape of the posterior one: .*--label anterior=1 --label posterior=2/,
  )

  await panel.getByText('Correct detected properties').click()
  await panel.getByLabel('Labels and order are correct').check()
  await panel.getByRole('button', { name: 'Import', exact: true }).click()
  const result = page.locator('[data-part=import-result]')
  const first = result.getByLabel('What label 1 is')
  await first.waitFor()
  assert.equal(await first.inputValue(), 'posterior')
  const leaflets = result.locator('dd[data-subject=leaflets]')
  assert.match(await leaflets.textContent(), /label 2 is the anterior leaflet.*contrary to their shape/)
  await picture(result, 'labels-before')

  await first.selectOption('anterior')
  await leaflets.filter({ hasText: 'label 1 is the anterior leaflet' }).waitFor()
  assert.equal(await result.getByLabel('What label 2 is').inputValue(), 'posterior')
  assert.doesNotMatch(await leaflets.textContent(), /contrary/)
  await picture(result, 'labels-after')
  assert.deepEqual(await accessProblems(page), [])

  await result.getByRole('button', { name: 'The atrium is on the other side' }).click()
  const atrium = result.locator('dd[data-subject=atrium]')
  await atrium.filter({ hasText: 'opposite to the side suggested by the shape, as given' }).waitFor()
  await result.getByRole('button', { name: 'Back to the detected side' }).click()
  await result.getByRole('button', { name: 'The atrium is on the other side' }).waitFor()
})

const SOURCE = join(ROOT, 'examples/valves/source/bodyparts3d')
const meshOf = (side, name) => ({
  ...{ name, mimeType: 'text/plain' },
  buffer: readFileSync(join(SOURCE, `${side}_leaflet_sheet.obj`)),
})
const ring = () => ({
  ...{ name: 'ring.csv', mimeType: 'text/csv' },
  buffer: readFileSync(join(SOURCE, 'annulus_centerline.csv')),
})

/// Of an import that has ended; `triangles` few, so that it is soon.
async function imported(panel, name) {
  await panel.getByLabel('Name').fill(name)
  await panel.getByLabel('Triangles').fill('200')
  await panel.getByRole('button', { name: 'Import', exact: true }).click()
  const result = page.locator('[data-part=import-result]')
  await result.locator('strong', { hasText: name }).waitFor()
  return result
}

test('the picker takes every format of the service', async () => {
  await page.goto(`${service.url}/#/valve`)
  for (const label of ['Your file', 'Files', 'Others to add']) {
    const accepted = await page.getByLabel(label, { exact: true }).getAttribute('accept')
    for (const format of ['.gz', '.bz2', '.fcsv', '.vtm', '.tsv', '.nhdr', '.glb'])
      assert.ok(accepted.split(',').includes(format), `${label}: ${format}`)
  }
})

test('a folder of bare files is sorted by the service, and its leaflets are exchanged and exchanged back', async (t) => {
  const folder = mkdtempSync(join(tmpdir(), 'coapt-folder-'))
  t.after(() => rmSync(folder, { recursive: true })) // the browser reads it when files are asked for
  for (const { name, buffer } of [meshOf('posterior', 'x.obj'), meshOf('anterior', 'y.obj'), ring()])
    writeFileSync(join(folder, name), buffer)
  writeFileSync(join(folder, 'LICENSE.txt'), 'free')
  writeFileSync(join(folder, 'photo.png'), 'no picture')
  await page.goto(`${service.url}/#/valve`)
  const panel = page.locator('[data-part=import]')
  await panel.getByLabel('Folder').setInputFiles(folder)
  await panel.getByText('2 files are left out', { exact: false }).waitFor()
  assert.equal(await panel.getByLabel('What x.obj is').inputValue(), 'detected')
  const result = await imported(panel, 'from a folder')
  const leaflets = result.locator('dd[data-subject=leaflets]')
  const which = /file (\d) is the anterior leaflet/.exec(await leaflets.textContent())
  assert.ok(which, await leaflets.textContent())
  assert.equal(await result.locator('dd[data-subject=files] select').count(), 3)
  assert.deepEqual(await accessProblems(page), [])

  await result.getByRole('button', { name: 'Exchange the leaflets' }).click()
  await leaflets.filter({ hasText: 'contrary to their shape' }).waitFor()
  await picture(result, 'files-exchanged')
  await result.getByRole('button', { name: 'Exchange the leaflets' }).click()
  await leaflets.filter({ hasNotText: 'contrary' }).waitFor()
})

test('axes, mirror image, tissue and thickness are changed beside their decisions', async () => {
  await page.goto(`${service.url}/#/valve`)
  const panel = page.locator('[data-part=import]')
  await panel
    .getByLabel('Files', { exact: true })
    .setInputFiles([meshOf('anterior', 'anterior.obj'), meshOf('posterior', 'posterior.obj'), ring()])
  await panel.getByText('triangles', { exact: false }).first().waitFor()
  const result = await imported(panel, 'corrected')
  const said = (subject) => result.locator(`dd[data-subject=${subject}]`)

  await result.getByLabel('Axes').selectOption('RAS')
  await said('axes').filter({ hasText: 'RAS, converted to LPS as given' }).first().waitFor()
  await result.getByRole('button', { name: 'The files are a mirror image' }).click()
  await said('frame').filter({ hasText: 'they are a mirror image, as given' }).waitFor()
  await result.getByRole('button', { name: 'The files are not a mirror image' }).click()
  await result.getByRole('button', { name: 'The files are a mirror image' }).waitFor()
  await result.getByLabel('Leaflets in the files are').selectOption('in_vivo')
  await said('state').filter({ hasText: 'unpressurised heart' }).waitFor()
  await result.getByLabel('Seed').fill('4')
  await result.getByLabel('Seed').press('Enter')
  await said('chordae').filter({ hasText: 'seed 4' }).waitFor()
  assert.equal(await panel.getByLabel('Seed of synthesised chordae').inputValue(), '4')

  await result.getByLabel('Lengths are in').selectOption('m')
  const told = result.locator('[data-part=told]')
  await told.getByText('This change cannot be made; the valve is as it was before.').waitFor()
  assert.ok((await told.locator('[data-part=problems] li').count()) > 0)
  assert.equal(await result.getByLabel('Lengths are in').inputValue(), 'mm')
  assert.deepEqual(await accessProblems(page), [])
})

/// The map at three times; nothing at the first.
function labelMapInTime() {
  const [head, ...data] = labelMap().toString('latin1').split('\n\n')
  const voxels = gunzipSync(Buffer.from(data.join('\n\n'), 'latin1'))
  const times = head
    .replace('dimension: 3', 'dimension: 4')
    .replace(/sizes: .*/, '$& 3')
    .replace(/space directions: .*/, '$& none')
    .replace('kinds: domain domain domain', 'kinds: domain domain domain time')
  return Buffer.concat([
    Buffer.from(`${times}\n\n`, 'latin1'),
    gzipSync(Buffer.concat([Buffer.alloc(voxels.length), voxels, voxels])),
  ])
}

test('another phase of a label map is taken beside the decision', async () => {
  await page.goto(`${service.url}/#/valve`)
  const panel = page.locator('[data-part=import]')
  await panel
    .getByLabel('Files', { exact: true })
    .setInputFiles({ name: 'map.nrrd', mimeType: 'image/nrrd', buffer: labelMapInTime() })
  await panel.getByLabel('What label 1 is').waitFor()
  const result = await imported(panel, 'at three times')
  const labels = result.locator('dd[data-subject=labels]')
  await labels.filter({ hasText: 'phase 2 of 3 is used' }).waitFor()
  const phase = result.getByLabel('Phase')
  assert.equal(await phase.inputValue(), '2')
  await phase.fill('3')
  await phase.press('Enter')
  await labels.filter({ hasText: 'phase 3 of 3 is used as given' }).waitFor()
  assert.deepEqual(await accessProblems(page), [])
})
