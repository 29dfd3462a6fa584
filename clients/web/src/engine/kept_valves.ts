// Valves that this browser keeps (IndexedDB): there is no service that does.
export interface KeptValve {
  id: string
  text: string // coapt.valve/1
  name: string
  vertices: number
  triangles: number
  kept_ms: number // since 1970
}

/// Each rejects with a DOMException where the browser keeps nothing, or no more.
export interface ValveShelf {
  find(id: string): Promise<KeptValve | null>
  list(): Promise<KeptValve[]> // newest first
  add(valve: KeptValve): Promise<void>
  remove(id: string): Promise<void>
}

const DATABASE = 'coapt'
const STORE = 'valves'

export function browserValves(): ValveShelf {
  let opened: Promise<IDBDatabase> | null = null

  function open(): Promise<IDBDatabase> {
    const request = indexedDB.open(DATABASE, 1)
    request.onupgradeneeded = () => request.result.createObjectStore(STORE, { keyPath: 'id' })
    return done(request)
  }

  /// Does one thing with the store and waits until it is on the disk.
  async function use<T>(mode: IDBTransactionMode, does: (store: IDBObjectStore) => IDBRequest<T>): Promise<T> {
    opened ??= open()
    const transaction = (await opened).transaction(STORE, mode)
    const request = does(transaction.objectStore(STORE))
    return new Promise((resolve, reject) => {
      transaction.oncomplete = () => resolve(request.result)
      transaction.onabort = () => reject(transaction.error)
    })
  }

  return {
    find: async (id) => (await use<KeptValve | undefined>('readonly', (store) => store.get(id))) ?? null,
    async list() {
      const valves = await use<KeptValve[]>('readonly', (store) => store.getAll())
      return valves.sort((a, b) => b.kept_ms - a.kept_ms)
    },
    async add(valve) {
      await use('readwrite', (store) => store.put(valve))
    },
    async remove(id) {
      await use('readwrite', (store) => store.delete(id))
    },
  }
}

function done<T>(request: IDBRequest<T>): Promise<T> {
  return new Promise((resolve, reject) => {
    request.onsuccess = () => resolve(request.result)
    request.onerror = () => reject(request.error)
  })
}
