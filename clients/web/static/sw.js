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

addEventListener('fetch', (event) => {
  const { request } = event
  if (request.method !== 'GET') return
  const answer = async () => {
    const cache = await caches.open(CACHE)
    const kept = await cache.match(request.mode === 'navigate' ? './' : request, { ignoreSearch: true })
    return kept ?? fetch(request)
  }
  event.respondWith(answer())
})
