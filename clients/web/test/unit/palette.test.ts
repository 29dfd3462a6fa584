import { expect, test } from 'vitest'
import canvas from '../../../../io/picture/canvas.h?raw'
import { TINTS } from '../../src/viewer/colours'

test('reports and pictures have the colours of the page', () => {
  const drawn = Object.fromEntries(
    [...canvas.matchAll(/Colour k(\w+) = hex\("(#[0-9a-f]{6})"\)/g)].map(([, name = '', hex]) => [
      name.toLowerCase(),
      hex,
    ]),
  )
  const { ruptured: _, ...tints } = TINTS
  expect(drawn).toEqual(tints)
})
