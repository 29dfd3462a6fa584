// What is used of node, whose own types are no dependency of the page.
declare module 'node:worker_threads' {
  export const parentPort: unknown
  export class Worker {
    constructor(address: URL, options: { execArgv: string[] })
    postMessage(message: unknown): void
    terminate(): Promise<number>
    on(event: 'message', heard: (said: never) => void): this
    on(event: 'error', died: (why: Error) => void): this
    removeAllListeners(event: string): this
    ref(): void
    unref(): void
  }
}
declare module 'node:fs/promises' {
  export function readFile(path: URL): Promise<Uint8Array<ArrayBuffer>>
}
