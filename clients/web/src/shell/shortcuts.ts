// Keys of the whole page. Fields of text keep their own undo.
import type { Workspace } from '../workspace'

export function shortcuts(workspace: Workspace, openPalette: () => void): void {
  addEventListener('keydown', (event) => {
    if (!(event.ctrlKey || event.metaKey) || event.altKey) return
    const key = event.key.toLowerCase()
    if (key === 'k') openPalette()
    else if (key === 'z' && !isWriting(event.target)) void (event.shiftKey ? workspace.redo() : workspace.undo())
    else return
    event.preventDefault()
  })
}

function isWriting(target: EventTarget | null): boolean {
  if (target instanceof HTMLTextAreaElement) return true
  return target instanceof HTMLInputElement && /^(text|search|password|number)$/.test(target.type)
}
