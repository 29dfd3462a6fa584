// What every view says: for research only, and what the model leaves out.
import { version } from '../api/calls'
import { h } from '../dom'
import shellStyle from './shell.module.css'

export function footer(): HTMLElement {
  const build = h('span', {}, '')
  const list = h('ul', {})
  version().then(
    (answer) => {
      build.textContent = `coapt ${answer.version}`
      list.append(...answer.not_modelled.map((sentence) => h('li', {}, sentence)))
    },
    () => list.append(h('li', {}, 'The service did not respond.')),
  )
  return h(
    'footer',
    { class: shellStyle.notice },
    h('p', {}, h('strong', {}, 'Research use only, not a medical device; not for clinical decisions. '), build),
    h('details', {}, h('summary', {}, 'Model limitations'), list),
  )
}
