// A repair by grabbing it on the valve: with the pointer, a finger and the keyboard.
import assert from 'node:assert/strict'
import { test } from 'node:test'
import { accessProblems, openBefore, page, settled } from './page.mjs'

openBefore('repair', { width: 1440, height: 900 }, () =>
  page.locator('[data-part=labels] [data-part=leak]').first().waitFor(),
)

const handle = (name) => page.locator('[data-part=handles]').getByRole('slider', { name })
const steps = () => page.locator('[data-part=steps] [data-part=step]').allTextContents()
const leaks = () => page.evaluate(() => globalThis.coapt.state().leak_mm2)
const told = () => page.locator('[data-part=viewer]').last().locator('[data-part=dragged]')
const isAnswered = () => page.locator('[aria-busy=false]').waitFor()
const titled = (words) =>
  page.waitForFunction((wanted) => document.querySelector('[data-part=steps]')?.textContent?.includes(wanted), words)

/// Down on the handle, along the way; not let go. The handle has followed.
async function dragBy(name, across, down) {
  await isAnswered()
  await settled()
  const { x, y, width, height } = await handle(name).boundingBox()
  await page.mouse.move(x + width / 2, y + height / 2)
  await page.mouse.down()
  const to = [x + width / 2 + across, y + height / 2 + down]
  await page.mouse.move(...to, { steps: 5 })
  await handle(name).evaluate(
    (button, [left, top]) =>
      new Promise((isThere) => {
        const look = () => {
          const box = button.getBoundingClientRect()
          const away = Math.hypot(box.x + box.width / 2 - left, box.y + box.height / 2 - top)
          if (away < 1) isThere()
          else requestAnimationFrame(look)
        }
        look()
      }),
    to,
  )
}

test("a suture's end is dragged: its length is told, applied once when it is let go, and one undo takes it back", async () => {
  await page.getByRole('button', { name: 'Suture PM' }).click()
  await handle('Suture length, posteromedial').waitFor()
  await isAnswered()
  await page.getByRole('button', { name: 'Oblique' }).click()
  const [title] = await steps()
  const leak = await leaks()
  await dragBy('Suture length, posteromedial', -12, -60)
  const length = (await told().textContent()).match(/^suture (\d+\.\d) mm$/)?.[1]
  assert.ok(Number(length) < 26, length)
  assert.deepEqual(await steps(), [title])
  await page.mouse.up()
  await titled(`suture ${length} mm`)
  await isAnswered()
  assert.notDeepEqual(await leaks(), leak)
  assert.equal(await page.getByRole('spinbutton', { name: /^Suture/ }).inputValue(), length)
  assert.ok(!(await told().isVisible()))
  await page.keyboard.press('Control+z')
  await titled(title)
  await isAnswered()
  assert.deepEqual(await leaks(), leak)
})

test('a handle stays under the pointer when the tissue error comes', async () => {
  const range = page.locator('[data-part=narrowing]')
  const suture = handle('Suture length, posteromedial')
  let tell
  const isAsked = new Promise((told) => (tell = told))
  await page.route('**/v1/information', (route) => isAsked.then(() => route.continue()))
  await suture.press('ArrowUp')
  await range.waitFor({ state: 'detached' })
  await isAnswered()
  await settled()
  const place = await suture.boundingBox()
  tell()
  await range.waitFor()
  assert.deepEqual(await suture.boundingBox(), place)
  await page.unroute('**/v1/information')
  await page.keyboard.press('Control+z')
  await isAnswered()
})

test('Escape leaves a handle that is held where it was', async () => {
  const before_ = await steps()
  await dragBy('Suture length, posteromedial', 0, -30)
  await page.keyboard.press('Escape')
  await page.mouse.up()
  assert.ok(!(await told().isVisible()))
  assert.deepEqual(await steps(), before_)
})

test('arrow keys set what is grabbed, step by step; the focus stays', async () => {
  const value = async () => Number(await handle('Suture length, posteromedial').getAttribute('aria-valuenow'))
  const first = await value()
  await handle('Suture length, posteromedial').focus()
  await page.keyboard.press('ArrowDown')
  await page.keyboard.press('ArrowDown')
  await titled(`suture ${(first - 1).toFixed(1)} mm`)
  await isAnswered()
  assert.equal(await value(), first - 1)
  assert.ok(await handle('Suture length, posteromedial').evaluate((node) => node === document.activeElement))
})

test('the other end is tied to another point of the annulus', async () => {
  await page.getByRole('button', { name: 'From the atrium' }).click()
  await dragBy('Suture anchor, posteromedial', 20, 60)
  assert.match(await told().textContent(), /^anchor at \d+°, suture \d+\.\d mm$/)
  await page.mouse.up()
  await titled('to the annulus at ')
})

test('a ring is drawn smaller', async () => {
  await page.getByRole('button', { name: 'Clear' }).click()
  await page.getByRole('button', { name: 'Ring', exact: true }).click()
  await titled('undersized by 2 sizes')
  await dragBy('Ring size', 0, -15)
  const sizes = Number(/\d+/.exec(await told().textContent())[0])
  assert.ok(sizes > 2, String(sizes))
  await page.mouse.up()
  await titled(`undersized by ${sizes} sizes`)
})

test('a neochorda is put elsewhere on the leaflet', async () => {
  await page.getByRole('button', { name: 'Clear' }).click()
  await page.getByRole('button', { name: 'Neochorda' }).click()
  await page.getByLabel('or choose the place').selectOption('P2')
  await page.getByLabel('or choose the head').selectOption('PM1')
  await titled('Neochorda from PM1 to P2')
  await handle(/^Neochorda insertion/).waitFor()
  await dragBy(/^Neochorda insertion/, 40, 60)
  assert.match(await told().textContent(), /^P\d, (free edge|belly|base): along 0\.\d\d, height \d\.\d\d$/)
  await page.mouse.up()
  await page.waitForFunction(
    () => !/P2, free edge/.test(document.querySelector('[data-part=steps]')?.textContent ?? ''),
  )
  await page.getByRole('button', { name: 'Undo' }).click()
  await titled('P2, free edge')
})

test('a cut hides the handles of the half that it hides, and shows them again when it is gone', async () => {
  await page.getByRole('button', { name: 'Clear' }).click()
  await page.getByRole('button', { name: 'Suture AL' }).click()
  await page.getByRole('button', { name: 'Suture PM' }).click()
  const ends = ['antero', 'postero'].map((side) => handle(new RegExp(`^Suture length, ${side}`)))
  await ends[1].waitFor()
  await isAnswered()
  await page.getByLabel('Cut', { exact: true }).check()
  await page.getByLabel('Position of the cut').fill('18')
  await settled()
  assert.equal((await Promise.all(ends.map((end) => end.isVisible()))).filter(Boolean).length, 1)
  await page.getByLabel('Cut', { exact: true }).uncheck()
  for (const end of ends) await end.waitFor()
  await page.getByRole('button', { name: 'Clear' }).click()
  await page.getByRole('button', { name: 'Neochorda' }).click()
  await page.getByLabel('or choose the place').selectOption('P2')
  await page.getByLabel('or choose the head').selectOption('PM1')
  await handle(/^Neochorda insertion/).waitFor()
})

test('handles are named and no smaller than a finger needs', async () => {
  assert.deepEqual(await accessProblems(page), [])
  const { width, height } = await handle(/^Neochorda insertion/).boundingBox()
  assert.ok(width >= 24 && height >= 24)
})
