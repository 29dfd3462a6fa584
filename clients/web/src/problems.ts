// Problems of an input in plain words, each where it is; a program's own words are folded away beside them.
import type { Problem } from './api/types'
import { h } from './dom'
import { words } from './format'
import parts from './style/parts.module.css'

/// Empty and not shown if there are none. Screen readers hear of new ones. `textAt`: what stands at a JSON pointer of a
/// file; `placeAt`: what is there called.
export function problemList(
  problems: Problem[],
  textAt: (pointer: string) => string = () => '',
  placeAt = placeInWords,
): HTMLElement {
  const list = h('ul', { class: parts.problems, 'data-part': 'problems' })
  for (const problem of problems) list.append(item(problem, textAt(problem.path), placeAt(problem.path)))
  return h('div', { role: 'alert', hidden: problems.length === 0 }, list) // a list's own role is to be one
}

function item({ code, path, message }: Problem, text: string, place: string): HTMLElement {
  const isParser = code === 'invalid_json'
  return h(
    'li',
    {},
    place && h('strong', {}, `${place} `),
    isParser ? 'This is not a JSON document.' : message,
    text && h('pre', {}, text),
    (path || isParser) &&
      h(
        'details',
        {},
        h('summary', {}, 'Details'),
        path && h('code', {}, path),
        path && ' ',
        isParser ? message : h('span', {}, words(code)),
      ),
  )
}

/// "/chordae/0/segments/2/rest_length_mm" -> "Chordae 1, segments 3, rest length:"; empty for the whole of a document.
export function placeInWords(pointer: string): string {
  const named: string[] = []
  for (const part of pointer.split('/').slice(1)) {
    if (/^\d+$/.test(part) && named.length > 0) named[named.length - 1] += ` ${Number(part) + 1}`
    else named.push(words(part.replace(/_(mm2?|deg|kpa|n|g|ms)$/, '')))
  }
  const inner = named.filter((name, i) => i > 0 || !/^(valve|plan|search|study|plans)$/.test(name)).join(', ')
  return inner === '' ? '' : `${inner.charAt(0).toUpperCase()}${inner.slice(1)}:`
}
