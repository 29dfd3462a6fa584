// The page without a service, after `vite build --mode static` has built its scripts: puts presets, engine, icon, manifest
// and the script that keeps all of it for use off-line beside them. `node static.mjs FOLDER COAPT ENGINE`
import { createHash } from 'node:crypto'
import { copyFileSync, readdirSync, readFileSync, writeFileSync } from 'node:fs'
import { join } from 'node:path'
import { fileURLToPath } from 'node:url'
import { writePresets } from './presets.mjs'

const SOURCES = fileURLToPath(new URL('static/', import.meta.url))
const [folder, coapt, engine] = process.argv.slice(2)

/// Paths of all files below the folder, sorted.
function files() {
  const entries = readdirSync(folder, { recursive: true, withFileTypes: true })
  const paths = entries
    .filter((entry) => entry.isFile())
    .map(({ parentPath, path, name }) => join(parentPath ?? path, name))
  return paths.map((path) => path.slice(join(folder, '/').length)).sort()
}

writePresets(folder, coapt)
for (const module of ['engine', 'planner'])
  copyFileSync(engine.replace('engine.wasm', `${module}.wasm`), join(folder, `coapt-${module}.wasm`))
copyFileSync(join(SOURCES, 'manifest.webmanifest'), join(folder, 'manifest.webmanifest'))

const listed = files()
const worker = readFileSync(join(SOURCES, 'sw.js'), 'utf8')
const hash = createHash('sha256').update(worker)
for (const file of listed) hash.update(`${file}\0`).update(readFileSync(join(folder, file)))
const asked = listed.map((file) => (file === 'index.html' ? './' : file)) // as a browser asks for them
writeFileSync(
  join(folder, 'sw.js'),
  `const FILES = ${JSON.stringify(asked)}\nconst HASH = '${hash.digest('hex').slice(0, 16)}'\n\n${worker}`,
)
