// The engine: a WebAssembly module that answers requests as the service does, and moves a valve (clients/engine).
import { Member, type TeamPlace } from './team'
import { wasi } from './wasi'

export interface EngineAnswer {
  status: number // of HTTP
  body: Uint8Array<ArrayBuffer> // JSON, UTF-8
}

/// Each call may throw WebAssembly.RuntimeError if the engine aborts; it is of no use then.
export interface Engine {
  /// Takes 30 ms to some seconds; a search, which may be that of a team, minutes.
  answer(path: string, body: string, place?: TeamPlace): EngineAnswer
  closed(): Uint8Array<ArrayBuffer> // of the valve closed last: x, y, z of each vertex, doubles, mm
  live: LiveEngine
}

/// One valve that moves; what makes no sense is left alone (clients/engine/live.h). Millimetres, newtons.
export interface LiveEngine {
  start(body: string): EngineAnswer
  change(body: string): EngineAnswer
  pressure(mmhg: number): void
  grab(hook: number, vertex: number): void
  grabCable(hook: number, cable: number, share: number): void
  move(hook: number, x: number, y: number, z: number): void
  release(hook: number): void
  advance(steps: number): void
  isAtRest(): boolean
  picture(): Float32Array<ArrayBuffer> // as picture.ts reads it
  vertices(): Uint8Array<ArrayBuffer> // of the moving valve, as closed()
}

interface Exports {
  memory: WebAssembly.Memory
  _initialize(): void
  coapt_path(size: number): number
  coapt_body(size: number): number
  coapt_answer(): number
  coapt_answer_bytes(): number
  coapt_answer_size(): number
  coapt_closed_mm(): number
  coapt_closed_vertices(): number
  coapt_live_start(): number
  coapt_live_change(): number
  coapt_live_pressure(mmhg: number): void
  coapt_live_grab(hook: number, vertex: number): void
  coapt_live_grab_cable(hook: number, cable: number, share: number): void
  coapt_live_move(hook: number, x: number, y: number, z: number): void
  coapt_live_release(hook: number): void
  coapt_live_advance(steps: number): void
  coapt_live_at_rest(): number
  coapt_live_picture(): number
  coapt_live_picture_at(): number
  coapt_live_vertices_mm(): number
  coapt_live_vertices(): number
}

const POINT_BYTES = 24
const KEY_WORDS = 4

/// `progress`: is told of searches, while they run, how far they are: JSON, UTF-8.
export async function startEngine(
  module: WebAssembly.Module,
  progress: (now: Uint8Array<ArrayBuffer>) => void = () => {},
): Promise<Engine> {
  let memory: WebAssembly.Memory | null = null
  let member: Member | null = null
  const imports = wasi(
    () => memory as WebAssembly.Memory,
    (text) => console.warn(text),
    (clock_ns) => member?.now(clock_ns) ?? clock_ns,
  )
  const { exports } = await WebAssembly.instantiate(module, {
    wasi_snapshot_preview1: imports,
    coapt: {
      progress: (at: number, size: number) => progress(copied(at, size)),
      ended: () => Number(member?.ended() ?? false),
      workers: () => member?.workers ?? 1,
      loop_begin: (count: number) => Number(member?.begin(count) ?? false),
      loop_take: () => (member as Member).take(),
      loop_end: () => (member as Member).finish(),
      find: (key: number) => (member as Member).find(keyAt(key)),
      take_found: (into: number) => bytesAt(into).set((member as Member).takeFound()),
      keep: (key: number, at: number, size: number) =>
        (member as Member).keep(keyAt(key), new Uint8Array(engine.memory.buffer, at, size)),
    },
  })
  const engine = exports as unknown as Exports
  memory = engine.memory
  engine._initialize()

  const encoder = new TextEncoder()
  /// `room` may move the memory's buffer.
  const put = (text: string, room: (size: number) => number): void => {
    const bytes = encoder.encode(text)
    const at = room(bytes.length)
    new Uint8Array(engine.memory.buffer).set(bytes, at)
  }
  const copied = (at: number, size: number) =>
    new Uint8Array(engine.memory.buffer, at, size).slice() as Uint8Array<ArrayBuffer>
  const answered = (status: number): EngineAnswer => {
    const at = engine.coapt_answer_bytes()
    return { status, body: copied(at, engine.coapt_answer_size()) }
  }
  const bytesAt = (at: number) => new Uint8Array(engine.memory.buffer, at)
  const keyAt = (at: number) => new Int32Array(engine.memory.buffer, at, KEY_WORDS)
  return {
    answer(path, body, place) {
      member = place ? new Member(place) : null
      put(path, engine.coapt_path)
      put(body, engine.coapt_body)
      return answered(engine.coapt_answer())
    },
    closed: () => copied(engine.coapt_closed_mm(), POINT_BYTES * engine.coapt_closed_vertices()),
    live: {
      start(body) {
        put(body, engine.coapt_body)
        return answered(engine.coapt_live_start())
      },
      change(body) {
        put(body, engine.coapt_body)
        return answered(engine.coapt_live_change())
      },
      pressure: engine.coapt_live_pressure,
      grab: engine.coapt_live_grab,
      grabCable: engine.coapt_live_grab_cable,
      move: engine.coapt_live_move,
      release: engine.coapt_live_release,
      advance: engine.coapt_live_advance,
      isAtRest: () => engine.coapt_live_at_rest() !== 0,
      picture() {
        const size = engine.coapt_live_picture()
        return new Float32Array(
          engine.memory.buffer,
          engine.coapt_live_picture_at(),
          size,
        ).slice() as Float32Array<ArrayBuffer>
      },
      vertices: () => copied(engine.coapt_live_vertices_mm(), POINT_BYTES * engine.coapt_live_vertices()),
    },
  }
}
