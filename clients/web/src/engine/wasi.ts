// What the engine's module imports of WASI preview 1 (wasi_snapshot_preview1): a clock, and what it prints before it aborts.
// There are no files. https://github.com/WebAssembly/WASI/blob/main/legacy/preview1/docs.md
const DONE = 0
const NO_FILE = 8 // errno badf
const NOT_SEEKABLE = 70 // errno spipe

/// `memory` is asked for at each call, because it may have grown. `print` takes what is written to any file descriptor.
export function wasi(
  memory: () => WebAssembly.Memory,
  print: (text: string) => void,
  now_ns = (clock_ns: bigint) => clock_ns,
): WebAssembly.ModuleImports {
  const decoder = new TextDecoder()
  return {
    clock_time_get(_clock: number, _precision: bigint, time_ns: number): number {
      const clock_ms = performance.timeOrigin + performance.now() // of all threads
      new DataView(memory().buffer).setBigUint64(time_ns, now_ns(BigInt(Math.round(clock_ms * 1e6))), true)
      return DONE
    },
    /// `pieces`: `count` pairs of address and size.
    fd_write(_file: number, pieces: number, count: number, written: number): number {
      const view = new DataView(memory().buffer)
      let bytes = 0
      for (let i = 0; i < count; ++i) {
        const size = view.getUint32(pieces + 8 * i + 4, true)
        print(decoder.decode(new Uint8Array(view.buffer, view.getUint32(pieces + 8 * i, true), size)))
        bytes += size
      }
      view.setUint32(written, bytes, true)
      return DONE
    },
    fd_seek: () => NOT_SEEKABLE,
    fd_close: () => DONE,
    fd_fdstat_get: () => NO_FILE, // whether output goes to a terminal
    proc_exit: (code: number) => {
      throw new Error(`the engine ended with code ${code}`)
    },
  }
}
