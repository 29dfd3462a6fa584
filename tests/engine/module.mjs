// The module of the engine, in node or in a browser: module(bytes) -> {answer(path, body), closed()}.
export async function module(bytes) {
  let memory
  const view = () => new DataView(memory.buffer)
  const wasi_snapshot_preview1 = {
    clock_time_get(_clock, _precision, time) {
      view().setBigUint64(time, BigInt(Math.round(performance.now() * 1e6)), true)
      return 0
    },
    fd_close: () => 0,
    fd_seek: () => 70,
    fd_write: () => 8,
  }
  const { instance } = await WebAssembly.instantiate(bytes, { wasi_snapshot_preview1 })
  const engine = instance.exports
  memory = engine.memory
  engine._initialize()

  return {
    answer(path, body) {
      const texts = [path, body].map((text) => new TextEncoder().encode(text))
      const rooms = [engine.coapt_path(texts[0].length), engine.coapt_body(texts[1].length)]
      texts.forEach((text, i) => new Uint8Array(memory.buffer, rooms[i], text.length).set(text))
      const status = engine.coapt_answer()
      const [at, size] = [engine.coapt_answer_bytes(), engine.coapt_answer_size()]
      return { status, json: JSON.parse(new TextDecoder().decode(new Uint8Array(memory.buffer, at, size))) }
    },
    /// The bytes of the vertices closed last.
    closed: () => new Uint8Array(memory.buffer, engine.coapt_closed_mm(), engine.coapt_closed_vertices() * 24),
  }
}

/// FNV-1a, as closed_presets prints it.
export function hash(bytes) {
  let hash = 0xcbf29ce484222325n
  for (const byte of bytes) hash = BigInt.asUintN(64, (hash ^ BigInt(byte)) * 0x100000001b3n)
  return hash.toString(16).padStart(16, '0')
}
