import { defineConfig } from 'vitest/config'

// The service serves what is built into build/web at /. `npm run dev` serves the sources and passes what they ask for on
// to a service on port 8080.
export default defineConfig({
  build: {
    outDir: '../../build/web',
    emptyOutDir: true,
    target: 'es2022',
    assetsInlineLimit: 0, // the page's policy allows no data: fonts or scripts
    modulePreload: { polyfill: false },
    chunkSizeWarningLimit: 900,
  },
  server: { proxy: { '/v1': 'http://127.0.0.1:8080', '/version': 'http://127.0.0.1:8080' } },
  test: { include: ['test/unit/**/*.test.ts'], css: true },
})
