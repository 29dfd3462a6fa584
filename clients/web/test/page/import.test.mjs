// Files of a segmentation tool become a valve; what is wrong stands beside the file.
import assert from 'node:assert/strict'
import { readFileSync } from 'node:fs'
import { join } from 'node:path'
import { test } from 'node:test'
import { ROOT, openBefore, page } from './page.mjs'

const CONTRACT = JSON.parse(readFileSync(join(ROOT, 'server/openapi.json')))
const { leaflets, annulus, chordae } = CONTRACT.components.examples.one_skirt.value
const fileOf = ({ name, text }) => ({ name, mimeType: 'text/plain', buffer: Buffer.from(text) })

openBefore('valve')

test('a damaged file is named, the others are not; the whole set becomes a valve that is shown', async () => {
  await page.getByText('Import meshes').click()
  const panel = page.locator('[data-part=import]')
  const damaged = { ...annulus, text: annulus.text.replace(/\d+\.\d/, 'nowhere') }
  await panel.getByLabel('Files').setInputFiles([...leaflets, damaged, chordae].map(fileOf))
  assert.equal(await panel.getByLabel('What skirt.obj is').inputValue(), 'anterior')
  assert.equal(await panel.getByLabel('What annulus.csv is').inputValue(), 'annulus')
  await panel.getByRole('button', { name: 'Import' }).click()
  const rows = panel.locator('li', { has: page.locator('select') })
  await rows.filter({ hasText: 'annulus.csv' }).locator('[data-part=problems] li').waitFor()
  assert.equal(await rows.filter({ hasText: 'chordae.csv' }).locator('[data-part=problems] li').count(), 0)
  assert.match(await panel.textContent(), /No valve can be made of these files: one problem\./)

  await panel.getByLabel('Files').setInputFiles([...leaflets, annulus, chordae].map(fileOf))
  await panel.getByLabel('Name').fill('my first import')
  await panel.getByLabel('Triangles').fill('100')
  await panel.getByRole('button', { name: 'Import' }).click()
  await page.getByText('my first import is open.').waitFor()
  assert.match(page.url(), /valve=[0-9a-f]{64}/)
})
