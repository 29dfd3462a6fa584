// Pictures of every view, to be looked at: `node views.mjs FOLDER`. Four sizes, light and dark.
import { mkdirSync } from 'node:fs'
import { join } from 'node:path'
import { openView, startBrowser, startService } from './page.mjs'

const SIZES = [
  [1440, 900],
  [1280, 800],
  [820, 1180],
  [390, 844],
]
const folder = process.argv[2] ?? '.'
mkdirSync(folder, { recursive: true })
const service = await startService()
const browser = await startBrowser()

/// Also the whole of it, at the widest and the narrowest; says what sticks out to the side.
async function shoot(page, name) {
  for (const [width, height] of SIZES)
    for (const theme of ['light', 'dark']) {
      await page.setViewportSize({ width, height })
      await page.emulateMedia({ colorScheme: theme })
      await page.waitForTimeout(400)
      await page.screenshot({ path: join(folder, `${name}-${width}-${theme}.png`) })
      const over = await page.evaluate(() => document.documentElement.scrollWidth - innerWidth)
      if (over > 0) console.log(`${name} at ${width}: ${over} px too wide`)
    }
  for (const [width, theme] of [
    [1440, 'light'],
    [390, 'dark'],
  ]) {
    await page.setViewportSize({ width, height: 900 })
    await page.emulateMedia({ colorScheme: theme })
    const long = await page.evaluate(
      () => document.querySelector('main').scrollHeight + innerHeight - document.querySelector('main').clientHeight,
    )
    await page.setViewportSize({ width, height: Math.min(long, 5000) })
    await page.waitForTimeout(600)
    await page.screenshot({ path: join(folder, `${name}-${width}-whole.png`) })
  }
  console.log(name)
}

const { page, complaints } = await openView(browser, service.url, 'valve')
await page.locator('[data-part=open-valve]', { hasText: 'human-functional-mr' }).waitFor()
await shoot(page, 'valve')
await page.getByRole('link', { name: 'Repair' }).click()
await page.getByRole('button', { name: 'Ring' }).click()
await page.locator('[data-part=answer]', { hasText: 'Closed' }).waitFor()
await shoot(page, 'repair')
await page.getByRole('link', { name: 'Search' }).click()
await page.getByRole('button', { name: 'Start the search' }).waitFor()
await shoot(page, 'search-form')
await page.getByLabel('Plans to show').fill('0')
await page.getByRole('button', { name: 'Start the search' }).click()
await page.locator('[data-part=problems]').waitFor()
await shoot(page, 'search-problem')
await page.getByLabel('Plans to show').fill('5')
await page.getByLabel('Time, at most').fill('30')
await page.getByRole('button', { name: 'Start the search' }).click()
await page.locator('[data-part=leading] [data-part=photo][data-taken]').nth(1).waitFor()
await shoot(page, 'search-running')
await page.locator('[data-part=plan]').nth(4).waitFor()
await page.waitForTimeout(3000)
await shoot(page, 'search-results')
await page.getByRole('checkbox', { name: 'Compare plan 1' }).check()
await page.getByRole('checkbox', { name: 'Compare plan 3' }).check()
await page.locator('[data-part=plan] summary', { hasText: 'Evidence' }).nth(2).click()
await page.locator('[data-part=plan] [data-part=heat]').first().waitFor()
await shoot(page, 'search-compared')
await page.getByRole('link', { name: 'Studies' }).click()
await page.getByRole('button', { name: 'Start the study' }).waitFor()
await shoot(page, 'studies-form')
await page.getByRole('button', { name: 'Start the study' }).click()
await page.locator('[data-part=plot] canvas').nth(1).waitFor()
await shoot(page, 'studies-results')
if (complaints.length > 0) console.log(complaints)
await browser.close()
await service.stop()
