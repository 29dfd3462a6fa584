// How a thread of the package is started, in a browser and in node.
import { type Thread, threadOf } from '../src/engine/threads'

export async function startThread(): Promise<Thread> {
  const address = new URL('./thread.js', import.meta.url)
  if (typeof Worker === 'function') return threadOf(new Worker(address, { type: 'module' }))
  const { Worker: NodeWorker } = await import('node:worker_threads')
  const worker = new NodeWorker(address, { execArgv: [] }) // none of the program's own
  return {
    postMessage: (message) => worker.postMessage(message),
    terminate: () => void worker.terminate(),
    listen(heard, died) {
      worker.removeAllListeners('message').removeAllListeners('error')
      worker.on('message', heard).on('error', died)
    },
    hold: (busy) => (busy ? worker.ref() : worker.unref()),
  }
}
