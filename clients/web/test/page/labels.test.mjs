// Words over the valve: none covers another or the leak, at four sizes.
import assert from 'node:assert/strict'
import { test } from 'node:test'
import { openBefore, page, resize, service, settled } from './page.mjs'

const SIZES = [
  [1440, 900],
  [1280, 800],
  [820, 1180],
  [390, 844],
]
const VIEWS = ['From the atrium', 'Oblique', 'From anterior', 'From lateral']

openBefore('valve')

/// What stands over the visible canvases: its words, and in which boxes.
const words = () =>
  page.locator('[data-part=labels] span:visible').evaluateAll((spans) =>
    spans.map((span) => {
      const { left, top, right, bottom } = span.getBoundingClientRect()
      return { text: span.textContent, kind: span.dataset.part, left, top, right, bottom }
    }),
  )

/// Of boxes of the page, how many pixels in each are as solid blue as the opening, with all words away.
async function leakUnder(boxes) {
  const fade = (opacity) =>
    page.locator('[data-part=labels]').evaluateAll((all, value) => {
      for (const { style } of all) style.opacity = value
    }, opacity)
  await fade('0')
  const png = (await page.screenshot()).toString('base64')
  await fade('')
  return page.evaluate(
    async ([letters, found]) => {
      const bytes = Uint8Array.from(atob(letters), (letter) => letter.charCodeAt(0))
      const picture = await createImageBitmap(new Blob([bytes]))
      const pen = new OffscreenCanvas(picture.width, picture.height).getContext('2d')
      pen.drawImage(picture, 0, 0)
      return found.map(({ left, top, right, bottom }) => {
        const { data } = pen.getImageData(left, top, right - left, bottom - top)
        let blue = 0
        for (let i = 0; i < data.length; i += 4)
          if (Math.abs(data[i] - 0x16) + Math.abs(data[i + 1] - 0x68) + Math.abs(data[i + 2] - 0xd6) < 12) ++blue
        return blue
      })
    },
    [png, boxes],
  )
}

function assertApart(boxes, where) {
  for (const [i, a] of boxes.entries())
    for (const b of boxes.slice(i + 1)) {
      const apart = a.right <= b.left || b.right <= a.left || a.bottom <= b.top || b.bottom <= a.top
      assert.ok(apart, `${where}: ${a.text} over ${b.text}`)
    }
}

async function assertReadable(where, least) {
  await settled()
  const boxes = await words()
  assert.ok(boxes.length >= least, `${where}: ${boxes.length} words`)
  assert.ok(
    boxes.some(({ kind }) => kind === 'leak'),
    `${where}: the leak has no figure`,
  )
  assertApart(boxes, where)
  for (const [i, pixels] of (await leakUnder(boxes)).entries())
    assert.equal(pixels, 0, `${where}: ${boxes[i].text} over the leak`)
}

for (const valve of ['human-functional-mr', 'human-p2-prolapse'])
  test(`words on ${valve} stand apart and beside the leak`, async () => {
    await page.goto(`${service.url}/#/valve?valve=${valve}`)
    await page.locator('[data-part=open-valve]', { hasText: valve }).waitFor()
    for (const [width, height] of SIZES) {
      await resize(width, height)
      for (const view of VIEWS) {
        await page.getByRole('button', { name: view, exact: true }).click()
        await assertReadable(`${valve}, ${width} x ${height}, ${view}`, 9)
      }
    }
  })

test('words on a repair stand apart and beside the leak', async () => {
  await resize(1280, 800)
  await page.goto(`${service.url}/#/repair?valve=human-functional-mr`)
  await page.getByRole('button', { name: 'Suture PM' }).click()
  await page.locator('[data-part=answer]', { hasText: 'Closed and measured' }).waitFor()
  for (const [width, height] of SIZES.slice(0, 2)) {
    await resize(width, height)
    await assertReadable(`repair, ${width} x ${height}`, 12)
  }
})
