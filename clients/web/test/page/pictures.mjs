// Pictures of each view for docs/images: `node pictures.mjs FOLDER [NAME...]`, all or those. page.json beside them says of which version they are. report.png is
// the first page of out/report.html, where make demo has written it.
import { existsSync, writeFileSync } from 'node:fs'
import { join } from 'node:path'
import { labelMap, openView, PATIENCE_MS, ROOT, startBrowser, startService } from './page.mjs'

const [folder = '.', ...names] = process.argv.slice(2)
const service = await startService()
const browser = await startBrowser()
const pictures = []

/// Of the page, or of the element that `prepare` returns.
async function picture(name, view, options, prepare) {
  if (names.length > 0 && !names.includes(name)) return
  const { page } = await openView(browser, service.url, view, options)
  await page.locator('[data-part=open-valve]', { hasText: 'human-functional-mr' }).waitFor()
  const element = await prepare(page)
  await page.waitForTimeout(1500)
  await (element ?? page).screenshot({ path: join(folder, `page-${name}.png`) })
  await page.close()
  pictures.push(`page-${name}.png`)
  console.log(name)
}

await picture('valve', 'valve', {}, async (page) => {
  await page.locator('[data-part=labels] [data-part=leak]').first().waitFor()
})
await picture('cut', 'valve', { theme: 'dark' }, async (page) => {
  await page.getByLabel('Preset').selectOption('human-normal')
  await page.locator('[data-part=open-valve]', { hasText: 'human-normal' }).waitFor()
  await page.getByRole('button', { name: 'Oblique' }).click()
  await page.getByRole('combobox', { name: 'Colours' }).selectOption('strain_radial')
  await page.getByLabel('Position of the cut').fill('18')
})
await picture('repair', 'repair', {}, async (page) => {
  await page.getByRole('button', { name: 'Ring' }).click()
  await page.getByRole('button', { name: 'Suture PM' }).click()
  await page.locator('[data-part=answer]', { hasText: 'Closed' }).waitFor()
  await page.getByRole('button', { name: 'Keep this repair' }).click()
})
await picture('repair-tablet', 'repair', { width: 820, height: 1180, theme: 'dark' }, async (page) => {
  await page.getByRole('button', { name: 'Suture AL' }).click()
  await page.locator('[data-part=answer]', { hasText: 'Closed' }).waitFor()
  await page.getByRole('button', { name: 'Oblique' }).click()
})

await picture('search', 'search', { height: 1000 }, async (page) => {
  await page.getByText('Optimiser', { exact: true }).click()
  await page.getByLabel('Closures', { exact: true }).fill('300')
  await page.getByLabel('Plans to show').fill('3')
  await page.getByRole('button', { name: 'Start the search' }).click()
  await page
    .locator('[data-part=plan] [data-part=photo][data-taken]')
    .nth(2)
    .waitFor({ timeout: 5 * PATIENCE_MS })
  const plan = page.locator('[data-part=plan]').first()
  await plan.locator('summary').click()
  await plan.evaluate((card) => card.scrollIntoView())
})
await picture('studies', 'studies', { theme: 'dark' }, async (page) => {
  await page.getByRole('button', { name: 'Start the study' }).click()
  await page.locator('[data-part=plot] canvas').nth(1).waitFor()
  await page
    .locator('[data-part=study-figure]')
    .first()
    .evaluate((figure) => figure.scrollIntoView({ block: 'end' }))
  await page.locator('[data-part=plot]').first().hover()
})

const SHEETS = join(ROOT, 'examples/valves/source/bodyparts3d')
const FILES = ['anterior_leaflet_sheet.obj', 'posterior_leaflet_sheet.obj', 'annulus_centerline.csv', 'chordae.csv']
async function chooseFiles(page) {
  await page.getByText('Import meshes').click()
  const panel = page.locator('[data-part=import]')
  await panel.getByLabel('Files', { exact: true }).setInputFiles(FILES.map((name) => join(SHEETS, name)))
  await panel.getByText('24 chordae').waitFor()
  await panel.getByLabel('Name').fill('BodyParts3D')
  return panel
}
await picture('import-files', 'valve', {}, async (page) => {
  const panel = await chooseFiles(page)
  await panel.getByText('Pick landmarks').click()
  await panel.getByLabel('Mid-anterior: x, y, z').fill('0.8, 15, 2.3')
  await panel.getByLabel('Mid-anterior: x, y, z').blur()
  await panel.getByRole('button', { name: 'Pick Mid-posterior' }).click()
})
await picture('import', 'valve', {}, async (page) => {
  const panel = await chooseFiles(page)
  await panel.getByRole('button', { name: 'Import', exact: true }).click()
  await page.locator('[data-part=import-result] img').first().waitFor()
  await panel.evaluate((element) => element.scrollIntoView())
})

async function importWrongLabels(page) {
  await page.getByText('Import meshes').click()
  const panel = page.locator('[data-part=import]')
  const labels = labelMap(['Posterior leaflet', 'Anterior leaflet'])
  await panel
    .getByLabel('Files', { exact: true })
    .setInputFiles({ name: 'map.nrrd', mimeType: 'image/nrrd', buffer: labels })
  await panel.getByLabel('What label 1 is').waitFor()
  await panel.getByLabel('Name').fill('labels in the wrong order')
  await panel.getByText('Correct detected properties').click()
  await panel.getByLabel('Labels and order are correct').check()
  await panel.getByRole('button', { name: 'Import', exact: true }).click()
  const result = page.locator('[data-part=import-result]')
  await result.getByText('contrary to their shape', { exact: false }).waitFor()
  return result
}

/// As far as the valve is drawn.
function cutBelowPicture(result) {
  return result.evaluate((whole) => {
    const { bottom } = whole.querySelector('img').getBoundingClientRect()
    whole.style.height = `${bottom - whole.getBoundingClientRect().top + 20}px`
    whole.style.overflow = 'hidden'
  })
}

await picture('import-labels-wrong', 'valve', { height: 1500 }, async (page) => {
  const result = await importWrongLabels(page)
  await cutBelowPicture(result)
  return result
})
await picture('import-labels-mended', 'valve', { height: 1500 }, async (page) => {
  const result = await importWrongLabels(page)
  await result.getByLabel('What label 1 is').selectOption('anterior')
  await result.locator('dd[data-subject=leaflets]', { hasText: 'label 1 is the anterior leaflet' }).waitFor()
  await cutBelowPicture(result)
  return result
})

const report = join(ROOT, 'out/report.html')
if (names.length === 0 && existsSync(report)) {
  const page = await browser.newPage({ viewport: { width: 1078, height: 1524 } })
  await page.goto(`file://${report}`)
  await page.screenshot({ path: join(folder, 'report.png') })
  console.log('report')
}

if (names.length === 0) {
  const { version } = await (await fetch(`${service.url}/version`)).json()
  writeFileSync(join(folder, 'page.json'), `${JSON.stringify({ version, pictures }, null, 2)}\n`)
}

await browser.close()
await service.stop()
