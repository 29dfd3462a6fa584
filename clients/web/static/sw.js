// Answers for all files of the page from the browser's cache, so that it works off-line. static.mjs writes what this build
// consists of above these lines: FILES, and HASH, which differs if any of them does.
//
// A new build waits until no tab shows the old one: a page never loads files of two builds.
const OURS = `coapt ${registration.scope} `
const CACHE = OURS + HASH

addEventListener('install', (event) => {
  const fresh = FILES.map((file) => new Request(file, { cache: 'reload' }))
  event.waitUntil(caches.open(CACHE).then((cache) => cache.addAll(fresh)))
})

addEventListener('activate', (event) => {
  const removeOld = async () => {
    const old = (await caches.keys()).filter((name) => name.startsWith(OURS) && name !== CACHE)
    await Promise.all(old.map((name) => caches.delete(name)))
    await clients.claim()
  }
  event.waitUntil(removeOld())
})

/// On a page that nothing from elsewhere is in, threads may share memory: a search is made by all cores from the second visit on.
function isolated(response) {
  if (response.status === 0) return response
  const headers = new Headers(response.headers)
  headers.set('Cross-Origin-Opener-Policy', 'same-origin')
  headers.set('Cross-Origin-Embedder-Policy', 'require-corp')
  return new Response(response.body, { status: response.status, statusText: response.statusText, headers })
}

addEventListener('fetch', (event) => {
  const { request } = event
  if (request.method !== 'GET') return
  const answer = async () => {
    const cache = await caches.open(CACHE)
    const kept = await cache.match(request.mode === 'navigate' ? './' : request, { ignoreSearch: true })
    return isolated(kept ?? (await fetch(request)))
  }
  event.respondWith(answer())
})
