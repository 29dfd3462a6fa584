// Values that this browser keeps. What cannot be read is as if it were not there.
export function stored<T>(key: string, otherwise: T): T {
  try {
    return (JSON.parse(localStorage.getItem(key) ?? 'null') as T | null) ?? otherwise
  } catch {
    return otherwise
  }
}

export function store(key: string, value: unknown): void {
  localStorage.setItem(key, JSON.stringify(value))
}
