// What the workers of one search share: who makes which call of a loop, and what closures and openings gave, by keys of 16 bytes
// (clients/engine/planner.cpp). All of them run the whole search and find what others have made; a worker that finds nothing, because it
// was dropped to bound the memory, or because its maker left, makes it, so that no answer depends on who was there.
const LOOPS = 1 << 14 // later ones are not shared
const MEMBERS = 64
const ENTRIES = 4096 // of each half
const HALF_BYTES = 32 << 20 // 1,300 closures of 650 triangles; a full half replaces the other
const PATIENCE_MS = 200

// Words of 32 bits at the beginning of the memory.
const END = 0
const LOST = 1 // workers that may have left a call undone
const LOCK = 2
const HALF = 3 // that is filled
const FILLED = 4 // entries of both halves
const USED = 6 // bytes of both halves
const LEAVE = 8 // of each member
const TAKEN = LEAVE + MEMBERS // calls of each loop
const ENDED = TAKEN + LOOPS // calls of each loop
const ENTRY = ENDED + LOOPS // key, place and size of each
const ENTRY_WORDS = 6
const TIMES = 4 * (ENTRY + 2 * ENTRIES * ENTRY_WORDS) // bytes from here on: the clock in and behind each loop, ns
const CLOSURES = TIMES + 8 * 2 * (LOOPS + 1)

/// Threads that share memory are there: in Node.js, and in browsers on pages that are isolated (COOP and COEP).
export const canShare = typeof SharedArrayBuffer === 'function' && globalThis.crossOriginIsolated !== false

/// A worker's place, to be sent to it. The first is the one whose answer counts.
export interface TeamPlace {
  memory: SharedArrayBuffer
  workers: number
  number: number
}

/// As whoever asks sees it.
export class Team {
  private readonly memory: SharedArrayBuffer
  private readonly words: Int32Array

  constructor(private readonly workers: number) {
    this.memory = new SharedArrayBuffer(workers > 1 ? CLOSURES + 2 * HALF_BYTES : 4 * TAKEN)
    this.words = new Int32Array(this.memory)
  }

  place(number: number): TeamPlace {
    return { memory: this.memory, workers: this.workers, number }
  }

  /// Ends the search with what it has.
  end(): void {
    Atomics.store(this.words, END, 1)
  }

  /// The same of one worker, whose answer does not count; the others go on.
  leave(number: number): void {
    Atomics.store(this.words, LEAVE + number, 1)
  }

  /// A worker has died.
  lose(): void {
    Atomics.add(this.words, LOST, 1)
  }
}

/// As a worker sees it, for one run of the search.
export class Member {
  readonly workers: number
  private readonly words: Int32Array
  private readonly number: number
  private readonly closures: Uint8Array
  private readonly times: BigInt64Array
  private loop = -1
  private count = 0
  private inside = false
  private busy = false
  private found = new Uint8Array()

  constructor({ memory, workers, number }: TeamPlace) {
    this.workers = workers
    this.number = number
    this.words = new Int32Array(memory)
    this.closures = new Uint8Array(memory, workers > 1 ? CLOSURES : 0)
    this.times = new BigInt64Array(memory, workers > 1 ? TIMES : 0, workers > 1 ? 2 * (LOOPS + 1) : 0)
  }

  ended(): boolean {
    return Atomics.load(this.words, END) + Atomics.load(this.words, LEAVE + this.number) > 0
  }

  /// Whether the calls of a loop are handed out; those of loops within one are not.
  begin(count: number): boolean {
    if (this.workers === 1 || this.inside || this.ended() || this.loop + 1 >= LOOPS) return false
    ++this.loop
    this.count = count
    this.inside = true
    return true
  }

  /// The next call; after the last, when all have ended, -1.
  take(): number {
    if (this.busy) this.add(ENDED)
    this.busy = false
    if (this.ended()) return -1
    const next = this.add(TAKEN)
    if (next < this.count) {
      this.busy = true
      return next
    }
    const place = ENDED + this.loop
    for (let ended = this.words[place] ?? 0; ended < this.count; ended = Atomics.load(this.words, place)) {
      if (this.ended() || Atomics.load(this.words, LOST) > 0) break
      Atomics.wait(this.words, place, ended, PATIENCE_MS)
    }
    return -1
  }

  finish(): void {
    this.inside = false
  }

  /// The same for all workers at the same place of the search, so that a limit of time ends it there; ns.
  now(clock_ns: bigint): bigint {
    const place = 2 * (this.loop + 1) + (this.inside ? 0 : 1)
    if (this.workers === 1 || this.loop + 1 >= LOOPS) return clock_ns
    return Atomics.compareExchange(this.times, place, 0n, clock_ns) || clock_ns
  }

  /// Size of what is kept under a key, which take_found() gives; -1: nothing.
  find(key: Int32Array): number {
    return this.locked(() => {
      const at = this.entry(key)
      if (at < 0) return -1
      const [place = 0, size = 0] = this.words.subarray(at + 4, at + 6)
      this.found = this.closures.slice(place, place + size)
      return size
    })
  }

  takeFound(): Uint8Array {
    return this.found
  }

  keep(key: Int32Array, bytes: Uint8Array): void {
    this.locked(() => {
      if (bytes.length > HALF_BYTES || this.entry(key) >= 0) return
      const words = this.words
      let half = words[HALF] as number
      if ((words[USED + half] as number) + bytes.length > HALF_BYTES || words[FILLED + half] === ENTRIES) {
        half = words[HALF] = 1 - half
        words[USED + half] = words[FILLED + half] = 0
      }
      const place = half * HALF_BYTES + (words[USED + half] as number)
      this.closures.set(bytes, place)
      const at = ENTRY + ENTRY_WORDS * (half * ENTRIES + (words[FILLED + half] as number))
      words.set(key, at)
      words[at + 4] = place
      words[at + 5] = bytes.length
      words[USED + half] = (words[USED + half] as number) + bytes.length
      words[FILLED + half] = (words[FILLED + half] as number) + 1
    })
  }

  private entry(key: Int32Array): number {
    for (const half of [0, 1]) {
      const first = ENTRY + ENTRY_WORDS * half * ENTRIES
      const end = first + ENTRY_WORDS * (this.words[FILLED + half] as number)
      for (let at = first; at < end; at += ENTRY_WORDS)
        if (this.words[at] === key[0] && key.every((word, i) => this.words[at + i] === word)) return at
    }
    return -1
  }

  private add(what: number): number {
    const before = Atomics.add(this.words, what + this.loop, 1)
    if (what === ENDED) Atomics.notify(this.words, what + this.loop)
    return before
  }

  private locked<T>(does: () => T): T {
    while (Atomics.compareExchange(this.words, LOCK, 0, 1) !== 0) Atomics.wait(this.words, LOCK, 1, PATIENCE_MS)
    try {
      return does()
    } finally {
      Atomics.store(this.words, LOCK, 0)
      Atomics.notify(this.words, LOCK, 1)
    }
  }
}
