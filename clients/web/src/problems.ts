// Problems of an input, each where it is.
import type { Problem } from './api/types'
import { h } from './dom'

/// Empty and not shown if there are none. Screen readers hear of new ones.
export function problemList(problems: Problem[]): HTMLElement {
  const list = h('ul', { class: 'problems' })
  for (const { path, message } of problems)
    list.append(h('li', {}, path && h('code', {}, path), path && ' ', message))
  return h('div', { role: 'alert', hidden: problems.length === 0 }, list) // a list's own role is to be one
}
