// A plain web server, for the tests of the page without a service.
import { spawn } from 'node:child_process'

/// http://127.0.0.1:PORT of `python3 -m http.server`, which serves `folder`.
export async function startFiles(folder) {
  const child = spawn('python3', ['-u', '-m', 'http.server', '0', '--bind', '127.0.0.1', '--directory', folder], {
    stdio: ['ignore', 'pipe', 'ignore'],
  })
  const port = await new Promise((resolve, reject) => {
    child.once('exit', () => reject(new Error('the web server ended')))
    let said = ''
    child.stdout.on('data', (part) => {
      said += part
      const found = /port (\d+) /.exec(said) // whole: it may come in pieces
      if (found) resolve(found[1])
    })
  })
  const stop = () =>
    new Promise((resolve) => {
      if (child.exitCode !== null || child.signalCode !== null) return resolve()
      child.once('exit', resolve)
      child.kill('SIGTERM')
    })
  return { url: `http://127.0.0.1:${port}`, stop }
}
