// What pictures cost whatever draws them: draw calls and bytes given to the graphics card. Scripts for a page before its own.

/// Counts from then on in `globalThis.frames`; each picture begins with a clear.
export function countFrames() {
  const frames = { pictures: 0, calls: 0, bytes: 0 }
  globalThis.frames = frames
  const { prototype } = WebGL2RenderingContext
  const watch = (name, count) => {
    const plain = prototype[name]
    prototype[name] = function (...how) {
      count(how)
      return plain.apply(this, how)
    }
  }
  watch('clear', () => ++frames.pictures)
  for (const name of ['drawElements', 'drawArrays', 'drawElementsInstanced', 'drawArraysInstanced'])
    watch(name, () => ++frames.calls)
  watch('bufferData', ([, data]) => (frames.bytes += data?.byteLength ?? 0)) // a size alone moves nothing
  watch('bufferSubData', ([, , data, , length]) => {
    frames.bytes += length ? length * data.BYTES_PER_ELEMENT : data.byteLength
  })
}

/// "12 draw calls and 310 kB a picture", since `before`, an earlier value of it.
export function frameWords(frames, before = { pictures: 0, calls: 0, bytes: 0 }) {
  const pictures = frames.pictures - before.pictures
  const a = (name) => (frames[name] - before[name]) / pictures
  return `${a('calls').toFixed(0)} draw calls and ${(a('bytes') / 1000).toFixed(0)} kB uploaded a picture, of ${pictures}`
}
