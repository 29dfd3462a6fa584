// Whether the service answers. While it does not, it is asked again until it does.
const AGAIN_MS = 1500

let away = false
const listeners: ((isAway: boolean) => void)[] = []

export function onService(listener: (isAway: boolean) => void): void {
  listeners.push(listener)
}

/// Fetches; what is said about the service follows from whether there was an answer at all.
export async function fetchKnowing(path: string, init: RequestInit): Promise<Response> {
  try {
    const response = await fetch(path, init)
    say(false)
    return response
  } catch (error) {
    if (!init.signal?.aborted) noAnswer()
    throw error
  }
}

/// A connection that was lost in the middle of an answer.
export function noAnswer(): void {
  if (away) return
  say(true)
  void askAgain()
}

async function askAgain(): Promise<void> {
  while (away) {
    await new Promise((resolve) => setTimeout(resolve, AGAIN_MS))
    await fetch('/version').then(
      () => say(false),
      () => {},
    )
  }
}

function say(isAway: boolean): void {
  if (away === isAway) return
  away = isAway
  for (const listener of listeners) listener(isAway)
}
