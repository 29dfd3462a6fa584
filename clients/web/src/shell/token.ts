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
    const give = (): void => dialog.close(input.value.trim().replace(/^.*#token=/, ''))
    const dialog = h(
      'dialog',
      { 'aria-label': 'Token' },
      h('h2', {}, 'This service requires a token'),
      field('Token', input),
      h(
        'p',
        { class: parts.hint },
        'When it started, coapt-server printed a link that contains the token. Open that link, or paste the link or the token ' +
          'here. The token is stored until this tab is closed.',
      ),
      button('Continue', give, { class: parts.primary }),
    )
    input.addEventListener('keydown', (event) => event.key === 'Enter' && give())
    dialog.addEventListener('close', () => {
      dialog.remove()
      resolve(dialog.returnValue || null)
    })
    document.body.append(dialog)
    dialog.showModal()
  })
}
