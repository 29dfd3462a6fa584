// What is said above every view: that the service is away, that the address names nothing.
import { onService } from '../api/health'
import { button, h } from '../dom'
import shellStyle from './shell.module.css'

export interface Notices {
  element: HTMLElement
  fault(words: string[]): void
}

/// `again` is called when the service answers after it did not.
export function notices(again: () => void): Notices {
  const away = h(
    'p',
    { class: shellStyle.away, hidden: true },
    'The service does not respond. Values in grey are the last ones received; the page retries automatically.',
  )
  const words = h('span', {})
  const fault = h(
    'p',
    { class: shellStyle.fault, hidden: true },
    words,
    button('Close', () => (fault.hidden = true)),
  )
  onService((isAway) => {
    away.hidden = !isAway
    document.documentElement.toggleAttribute('data-away', isAway)
    if (!isAway) again()
  })
  return {
    element: h('div', { role: 'alert', 'data-part': 'notices' }, away, fault),
    fault(said) {
      fault.hidden = said.length === 0
      words.textContent = said.join(' ')
    },
  }
}
