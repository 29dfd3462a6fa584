// A figure as a PNG that knows its size on paper.
const INCH_MM = 25.4
export const DENSITY_DPI = 300

export function pixelsOf(mm: number): number {
  return Math.round((mm / INCH_MM) * DENSITY_DPI)
}

/// Of a drawing whose width is `width_mm`.
export async function drawingAsPng(drawing: SVGSVGElement, width_mm: number): Promise<Blob> {
  const image = new Image()
  image.src = URL.createObjectURL(drawingAsSvg(drawing))
  await image.decode()
  const width = pixelsOf(width_mm)
  const paper = new OffscreenCanvas(width, Math.round((width * image.naturalHeight) / image.naturalWidth))
  paper.getContext('2d')?.drawImage(image, 0, 0, paper.width, paper.height)
  URL.revokeObjectURL(image.src)
  const bytes = new Uint8Array(await (await paper.convertToBlob({ type: 'image/png' })).arrayBuffer())
  return new Blob([withDensity(bytes)], { type: 'image/png' })
}

export function drawingAsSvg(drawing: SVGSVGElement): Blob {
  return new Blob([new XMLSerializer().serializeToString(drawing)], { type: 'image/svg+xml' })
}

const HEADER_END = 33 // signature of 8 bytes, IHDR of 25

/// The same picture with the chunk that tells its pixels a metre (PNG specification 11.3.4.3, pHYs).
export function withDensity(png: Uint8Array): Uint8Array<ArrayBuffer> {
  const chunk = new Uint8Array(21)
  const view = new DataView(chunk.buffer)
  const per_metre = Math.round((1000 / INCH_MM) * DENSITY_DPI)
  view.setUint32(0, 9)
  chunk.set(new TextEncoder().encode('pHYs'), 4)
  view.setUint32(8, per_metre)
  view.setUint32(12, per_metre)
  view.setUint8(16, 1) // the unit is the metre
  view.setUint32(17, crc32(chunk.subarray(4, 17)))
  const all = new Uint8Array(png.length + chunk.length)
  all.set(png.subarray(0, HEADER_END))
  all.set(chunk, HEADER_END)
  all.set(png.subarray(HEADER_END), HEADER_END + chunk.length)
  return all
}

/// As in the PNG specification, annex D.
function crc32(bytes: Uint8Array): number {
  let crc = 0xffffffff
  for (const byte of bytes) {
    crc ^= byte
    for (let bit = 0; bit < 8; ++bit) crc = (crc >>> 1) ^ (crc & 1 ? 0xedb88320 : 0)
  }
  return (crc ^ 0xffffffff) >>> 0
}
