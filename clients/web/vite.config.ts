import type { HtmlTagDescriptor } from 'vite'
import { defineConfig } from 'vitest/config'

// As server/page.cpp says of the page that it serves; the engine (WebAssembly) and its thread in addition.
const STATIC_POLICY =
  "default-src 'none'; script-src 'self' 'wasm-unsafe-eval'; worker-src 'self'; style-src 'self'; " +
  "img-src 'self' blob: data:; connect-src 'self'; manifest-src 'self'; base-uri 'none'; form-action 'none'"

const STATIC_HEAD: HtmlTagDescriptor[] = [
  {
    tag: 'meta',
    attrs: { 'http-equiv': 'Content-Security-Policy', content: STATIC_POLICY },
    injectTo: 'head-prepend',
  },
  { tag: 'link', attrs: { rel: 'manifest', href: './manifest.webmanifest' }, injectTo: 'head' },
]

// The service serves what is built into build/web at /. `npm run dev` serves the sources and passes what they ask for on
// to a service on port 8080. Mode static builds the page without a service into build/static (make static), for any folder
// of any web server.
export default defineConfig(({ mode }) => ({
  ...(mode === 'static'
    ? { base: './', plugins: [{ name: 'static-head', transformIndexHtml: () => STATIC_HEAD }] }
    : {}),
  build: {
    outDir: mode === 'static' ? '../../build/static' : '../../build/web',
    emptyOutDir: true,
    target: 'es2022',
    assetsInlineLimit: 0, // the page's policy allows no data: fonts or scripts
    modulePreload: { polyfill: false },
    chunkSizeWarningLimit: 900,
  },
  worker: { format: 'es' },
  server: {
    fs: { allow: ['../..'] }, // schedules in examples/training, words
    proxy: { '/v1': 'http://127.0.0.1:8080', '/version': 'http://127.0.0.1:8080' },
  },
  test: { include: [mode === 'static' ? 'test/static/engine.test.mjs' : 'test/unit/**/*.test.ts'], css: true },
}))
