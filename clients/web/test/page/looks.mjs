// Looks at a page as it is: its layout in four sizes of the window and with larger letters, what axe-core finds, what the browser
// has complained of. Leaves a picture.
import assert from 'node:assert/strict'
import { mkdirSync } from 'node:fs'
import { join } from 'node:path'
import { layoutFaults } from './layout.mjs'
import { accessProblems, resize, ROOT } from './page.mjs'

const WINDOWS = [
  [1440, 900],
  [390, 844],
  [820, 1180],
  [1280, 800],
]
const LARGER = '125%' // of the letters that a browser has else
const FONTS = ['DejaVu Serif', 'DejaVu Sans Condensed', 'DejaVu Serif Condensed', 'Liberation Sans'] // besides the system's, where there are any; the page asks for what the system has
const NAMED =
  /^\s*- (button|link|textbox|searchbox|slider|spinbutton|combobox|checkbox|radio|img|dialog|listbox)(?: \[[^\]]*\])*:?$/
const PICTURES = join(ROOT, 'build/pages')

/// Nothing is drawn but for pictures: the processor would take most of the time for that.
export function drawNothing() {
  globalThis.drawsNothing = true
  for (const name of ['drawElements', 'drawArrays', 'drawElementsInstanced', 'drawArraysInstanced']) {
    const draw = WebGL2RenderingContext.prototype[name]
    WebGL2RenderingContext.prototype[name] = function (...how) {
      if (!globalThis.drawsNothing) draw.apply(this, how)
    }
  }
}

/// `said`: complaints of the browser so far. `theme`: in which the picture is taken and axe looks.
export async function looks(name, of, said, { theme = 'light' } = {}) {
  mkdirSync(PICTURES, { recursive: true })
  const found = []
  const look = async (width, height, letters) => {
    await of.evaluate((size) => (document.documentElement.style.fontSize = size), letters)
    await resize(width, height, of)
    for (const fault of await of.evaluate(layoutFaults)) found.push(`${name}, ${width} px ${letters}: ${fault}`)
  }
  const drewNothing = await of.evaluate(() => {
    const before = globalThis.drawsNothing
    globalThis.drawsNothing = true
    return before
  })
  await look(...WINDOWS[1], LARGER)
  for (const [width, height] of WINDOWS) await look(width, height, '')
  for (const font of FONTS) {
    await of.evaluate((name) => (document.documentElement.style.fontFamily = name), font)
    await look(...WINDOWS[3], '')
  }
  await of.evaluate(() => (document.documentElement.style.fontFamily = ''))
  found.push(...(await namelessOnes(of)).map((line) => `${name}: a screen reader hears no name of “${line}”`))
  await of.evaluate(() => (globalThis.drawsNothing = false))
  await picture(name, of, theme)
  found.push(...(await accessProblems(of)))
  if (process.env.COAPT_PICTURES === 'all')
    for (const window of WINDOWS)
      for (const colours of ['light', 'dark']) await picture(`${name}-${window[0]}-${colours}`, of, colours, window)
  await of.evaluate((before) => (globalThis.drawsNothing = before), drewNothing)
  if (theme !== 'light') await of.emulateMedia({ colorScheme: 'light' })
  assert.deepEqual([...found, ...said], [])
}

/// Of what a screen reader is told of the page, the parts that have no name though one needs it.
async function namelessOnes(of) {
  const tree = await of.locator('body').ariaSnapshot()
  return tree.split('\n').filter((line) => NAMED.test(line))
}

async function picture(name, of, colorScheme, [width, height] = [1440, 900]) {
  await of.emulateMedia({ colorScheme })
  await resize(width, height, of) // all is drawn anew
  await of.waitForFunction(() => !document.querySelector('[data-part=photo]:not([data-taken])'))
  await of.screenshot({ path: join(PICTURES, `${name}.png`) })
}
