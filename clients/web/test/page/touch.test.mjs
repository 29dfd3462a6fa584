// Fingers on the valve.
import assert from 'node:assert/strict'
import { test } from 'node:test'
import { openBefore, page, settled } from './page.mjs'

let session
openBefore('valve', { width: 820, height: 1180 }, async () => {
  await page.locator('[data-part=labels] [data-part=leak]').first().waitFor()
  session = await page.context().newCDPSession(page)
  await session.send('Emulation.setTouchEmulationEnabled', { enabled: true, maxTouchPoints: 2 })
})

const touch = (type, ...touchPoints) => session.send('Input.dispatchTouchEvent', { type, touchPoints })
/// Of a label; in one look, because labels are made anew while the valve turns.
const boxOf = async (name) =>
  (
    await page.waitForFunction((wanted) => {
      const labels = [...document.querySelectorAll('[data-part=labels] span')]
      const box = labels.find((label) => label.textContent === wanted)?.getBoundingClientRect()
      return box?.width > 0 && { x: box.x, y: box.y, width: box.width, height: box.height }
    }, name)
  ).jsonValue()
const middle = ({ x, y, width, height }) => ({ x: x + width / 2, y: y + height / 2 })

test('a finger that moves sideways turns the valve', async () => {
  const { x, y } = middle(await page.locator('[data-part=viewer] canvas').boundingBox())
  const first = await boxOf('AL trigone')
  await touch('touchStart', { x, y })
  for (let i = 1; i <= 6; ++i) await touch('touchMove', { x: x + 15 * i, y })
  await touch('touchEnd')
  await settled()
  const { x: left, y: top } = await boxOf('AL trigone')
  assert.ok(Math.hypot(left - first.x, top - first.y) > 20)
})

test('two fingers that part bring the valve nearer', async () => {
  await page.getByRole('button', { name: 'From the atrium' }).click()
  await settled()
  const { x, y } = middle(await page.locator('[data-part=viewer] canvas').boundingBox())
  const width = async () => (await boxOf('PM trigone')).x - (await boxOf('AL trigone')).x
  const first = await width()
  await touch('touchStart', { x: x - 40, y }, { x: x + 40, y })
  for (let i = 1; i <= 6; ++i) await touch('touchMove', { x: x - 40 - 3 * i, y }, { x: x + 40 + 3 * i, y })
  await touch('touchEnd')
  await settled()
  assert.ok((await width()) > 1.1 * first)
})

test('a tap tells what is there', async () => {
  await page.getByRole('button', { name: 'From the atrium' }).click()
  await settled()
  const { x, y } = middle(await boxOf('A2'))
  await touch('touchStart', { x, y })
  await touch('touchEnd')
  await page.locator('[data-part=readout]', { hasText: /^A2: / }).waitFor()
})

test('every button of the stage has a tooltip, and an icon or a label', async () => {
  const bare = await page
    .locator('main [class*=tools] button')
    .evaluateAll((buttons) => buttons.filter((button) => button.title === '' || !button.querySelector('svg')).length)
  assert.equal(bare, 0)
})
