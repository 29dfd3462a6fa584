// The engine: a WebAssembly module that answers requests as the service does (clients/engine).
import { wasi } from './wasi'

export interface EngineAnswer {
  status: number // of HTTP
  body: Uint8Array<ArrayBuffer> // JSON, UTF-8
}

/// Takes 30 ms to some seconds. Throws WebAssembly.RuntimeError if the engine aborts; it is of no use then.
export type Engine = (path: string, body: string) => EngineAnswer

interface Exports {
  memory: WebAssembly.Memory
  _initialize(): void
  coapt_path(size: number): number
  coapt_body(size: number): number
  coapt_answer(): number
  coapt_answer_bytes(): number
  coapt_answer_size(): number
}

export async function startEngine(module: WebAssembly.Module): Promise<Engine> {
  let memory: WebAssembly.Memory | null = null
  const imports = wasi(
    () => memory as WebAssembly.Memory,
    (text) => console.warn(text),
  )
  const { exports } = await WebAssembly.instantiate(module, { wasi_snapshot_preview1: imports })
  const engine = exports as unknown as Exports
  memory = engine.memory
  engine._initialize()

  const encoder = new TextEncoder()
  return (path, body) => {
    const [path_bytes, body_bytes] = [encoder.encode(path), encoder.encode(body)]
    const [path_at, body_at] = [engine.coapt_path(path_bytes.length), engine.coapt_body(body_bytes.length)]
    new Uint8Array(engine.memory.buffer).set(path_bytes, path_at) // after both calls: each may move the buffer
    new Uint8Array(engine.memory.buffer).set(body_bytes, body_at)
    const status = engine.coapt_answer()
    const at = engine.coapt_answer_bytes()
    return { status, body: new Uint8Array(engine.memory.buffer, at, engine.coapt_answer_size()).slice() }
  }
}
