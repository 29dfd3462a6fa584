// What a thread of the package is told, and what it says.
export type ToThread = { module: WebAssembly.Module } | { path: string; body: string }
export type FromThread =
  | { status: number; body: Uint8Array<ArrayBuffer> }
  | { progress: [done: number, planned: number] }
  | { failed: string }
