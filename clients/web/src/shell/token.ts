// Asks for the service's token, when it wants one.
import { button, field, h } from '../dom'
import parts from '../style/parts.module.css'

let open: Promise<string | null> | null = null

/// One dialog for all requests that wait for it. Null: the person closed it.
export function askForToken(): Promise<string | null> {
  open ??= ask().finally(() => (open = null))
  return open
}

function ask(): Promise<string | null> {
  return new Promise((resolve) => {
    const input = h('input', { type: 'password', autocomplete: 'current-password', required: true })
    const dialog = h(
      'dialog',
      { 'aria-label': 'Token' },
      h('h2', {}, 'This service requires a token'),
      field('Token', input),
      h('p', { class: parts.hint }, 'It is kept until this tab is closed.'),
      button('Continue', () => dialog.close(input.value.trim()), { class: parts.primary }),
    )
    input.addEventListener('keydown', (event) => event.key === 'Enter' && dialog.close(input.value.trim()))
    dialog.addEventListener('close', () => {
      dialog.remove()
      resolve(dialog.returnValue || null)
    })
    document.body.append(dialog)
    dialog.showModal()
  })
}
