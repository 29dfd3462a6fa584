// The package for npm, in FOLDER: scripts and types from npm/, the module that searches, presets, licences.
// `node npm.mjs FOLDER COAPT PLANNER`
import { execFileSync } from 'node:child_process'
import { copyFileSync, mkdirSync, readFileSync, writeFileSync } from 'node:fs'
import { join, resolve } from 'node:path'
import { fileURLToPath } from 'node:url'
import { build } from 'vite'
import { writePresets } from './presets.mjs'

const WEB = fileURLToPath(new URL('./', import.meta.url))
const SOURCES = join(WEB, 'npm')
// Whose code is in the module, beside NLopt's.
const COMPILED_IN = [
  'libeigen3-dev',
  'nlohmann-json3-dev',
  'libc++-19-dev-wasm32',
  'libclang-rt-19-dev-wasm32',
  'wasi-libc',
]
const [folder, coapt, planner] = process.argv.slice(2).map((path) => resolve(path))

await build({
  root: WEB,
  configFile: false,
  logLevel: 'warn',
  publicDir: false,
  build: {
    outDir: folder,
    emptyOutDir: true,
    target: 'es2022',
    minify: false,
    lib: { entry: { index: join(SOURCES, 'index.ts'), thread: join(SOURCES, 'thread.ts') }, formats: ['es'] },
    rollupOptions: { external: [/^node:/], output: { entryFileNames: '[name].js', chunkFileNames: '[name].js' } },
  },
  // The address of thread.js is made where the package runs.
  plugins: [
    {
      name: 'keep-addresses',
      enforce: 'pre',
      transform: (code) => code.replaceAll('import.meta.url', 'import.meta["url"]'),
    },
  ],
})
execFileSync('npx', ['--no-install', 'tsc', '-p', SOURCES, '--outDir', join(folder, 'types')], {
  cwd: WEB,
  stdio: 'inherit',
})

writePresets(folder, coapt)
copyFileSync(planner, join(folder, 'coapt-planner.wasm'))
copyFileSync(join(SOURCES, 'README.md'), join(folder, 'README.md'))
copyFileSync(join(WEB, '../../LICENSE'), join(folder, 'LICENSE'))
const licences = join(folder, 'licenses')
mkdirSync(licences)
for (const name of COMPILED_IN) copyFileSync(`/usr/share/doc/${name}/copyright`, join(licences, `${name}.txt`))
copyFileSync(join(WEB, '../../build/wasm-libraries/source/nlopt/COPYING'), join(licences, 'nlopt.txt'))

const [, version] = /^coapt (\S+)/.exec(execFileSync(coapt, ['--version'], { encoding: 'utf8' }))
const { name, ...described } = JSON.parse(readFileSync(join(SOURCES, 'package.json'), 'utf8'))
writeFileSync(join(folder, 'package.json'), `${JSON.stringify({ name, version, ...described }, null, 2)}\n`)
