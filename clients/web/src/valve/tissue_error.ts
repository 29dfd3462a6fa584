// How far the leak may be off by what is not known of the tissue. It takes dozens of closures, so it is asked for once the
// closure has been shown for a moment.
import { valueInformation } from '../api/calls'
import type { Information, Plan, Scene } from '../api/types'

const REST_MS = 600
const CLOSURES = 24 // a second of one core: a service lets these go first

const known = new WeakMap<Scene, Information>() // in every view

/// What has come for this scene, in any view.
export function knownTissue(scene: Scene): Information | null {
  return known.get(scene) ?? null
}

export class TissueError {
  private scene: Scene | null = null // that was asked for last
  private timer = 0
  private abort = new AbortController()

  constructor(private readonly onFound: () => void) {}

  /// Of `scene`, if it has come; else it is asked for, of the valve `reference` with `plan`.
  of(scene: Scene, reference: string | undefined, plan: Plan | null): Information | null {
    if (this.scene !== scene) {
      this.clear()
      this.scene = scene
      if (reference !== undefined && !known.has(scene))
        this.timer = window.setTimeout(() => void this.ask(scene, reference, plan), REST_MS)
    }
    return knownTissue(scene)
  }

  private clear(): void {
    clearTimeout(this.timer)
    this.abort.abort()
    this.abort = new AbortController()
  }

  /// A valve that is too large for it keeps its numerical error.
  private async ask(scene: Scene, reference: string, plan: Plan | null): Promise<void> {
    const { signal } = this.abort
    const draws = plan ? CLOSURES / 2 : CLOSURES // with a plan the valve before it is closed, too
    const found = await valueInformation(reference, plan, draws, signal).catch(() => null)
    if (signal.aborted || !found) return
    known.set(scene, found)
    this.onFound()
  }
}
