// Plays a story of examples/stories on the page to its end; leaves a picture of each slide in build/pages/stories, to be looked at.
import assert from 'node:assert/strict'
import { mkdirSync, readFileSync } from 'node:fs'
import { join } from 'node:path'
import { ROOT, settled } from './page.mjs'

const PICTURES = join(ROOT, 'build/pages/stories')

export const STORIES = ['flail-p2', 'functional', 'barlow', 'clip-against-ring']
export const storyOf = (name) => JSON.parse(readFileSync(join(ROOT, `examples/stories/${name}.json`)))

/// From a link on the page. `hasLive`: slides in the view Live are told.
export async function tell(page, name, { hasLive = true, pictures = true } = {}) {
  mkdirSync(PICTURES, { recursive: true })
  const { title, slides } = storyOf(name)
  await page.getByRole('link', { name: 'Valve', exact: true }).click()
  await page.getByRole('link', { name: title, exact: true }).last().click()
  const strip = page.locator('[data-part=story]')
  for (const [i, slide] of slides.entries()) {
    if (slide.view === 'live' && !hasLive) continue
    await page.locator(`[data-part=story][data-told="${i + 1}"]`).waitFor()
    const { view, valve, plan, story } = await page.evaluate(() => globalThis.coapt.state())
    assert.deepEqual([view, valve.reference, story.slide], [slide.view, slide.valve, i])
    assert.deepEqual(plan.steps, slide.steps ?? [])
    if (slide.vary) await page.locator('[data-part=tolerance-progress]', { hasText: /closures\./ }).waitFor()
    const words = await strip.textContent()
    assert.doesNotMatch(words, /[{}…]|unknown|may not apply/, `slide ${i + 1} of ${name}`)
    if (slide.text.includes('{leak}')) assert.match(words, /\d mm²/)
    await settled(page)
    if (pictures) await page.screenshot({ path: join(PICTURES, `${name}-${i + 1}.png`) })
    if (i + 1 < slides.length) await strip.getByRole('button', { name: 'Next' }).click()
  }
  assert.ok(await strip.getByRole('button', { name: 'Next' }).isDisabled())
  await strip.getByRole('button', { name: 'End the story' }).click()
  await strip.waitFor({ state: 'hidden' })
  assert.doesNotMatch(page.url(), /story=/)
}
