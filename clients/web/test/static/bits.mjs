// The engine's module (src/engine/module.ts) for tests outside of vite, and what they compare with the native programs.
import { readFileSync } from 'node:fs'
import { fileURLToPath } from 'node:url'
import { build } from 'vite'

/// A script; `coaptEngine` is what the module exports then.
export async function engineScript() {
  const entry = fileURLToPath(new URL('../../src/engine/module.ts', import.meta.url))
  const [{ output }] = await build({
    configFile: false,
    logLevel: 'silent',
    build: { lib: { entry, formats: ['iife'], name: 'coaptEngine' }, write: false },
  })
  return output[0].code
}

/// The engine of this file, in node.
export async function startInNode(file) {
  const { startEngine } = new Function(`${await engineScript()}; return coaptEngine`)()
  return startEngine(await WebAssembly.compile(readFileSync(file)))
}

/// FNV-1a, as closed_presets and live_pull print it.
export function hash(bytes) {
  let hash = 0xcbf29ce484222325n
  for (const byte of bytes) hash = BigInt.asUintN(64, (hash ^ BigInt(byte)) * 0x100000001b3n)
  return hash.toString(16).padStart(16, '0')
}
