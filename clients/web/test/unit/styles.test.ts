import { expect, test } from 'vitest'

const styles = import.meta.glob<string>('../../src/**/*.css', { eager: true, query: '?raw', import: 'default' })
const sources = import.meta.glob<string>('../../src/**/*.ts', { eager: true, query: '?raw', import: 'default' })

function classesOf(rules = ''): Set<string> {
  const bare = rules.replaceAll(/\/\*.*?\*\//gs, '')
  return new Set([...bare.matchAll(/\.([a-zA-Z][\w-]*)/g)].map(([, name = '']) => name))
}

test('a style that no view owns names elements alone: no class can match in two views', () => {
  const shared = Object.keys(styles).filter((path) => !path.endsWith('.module.css'))
  expect(shared).toEqual(['../../src/style/base.css'])
  expect(styles[shared[0] ?? '']).toContain(':root')
  expect([...classesOf(styles[shared[0] ?? ''])]).toEqual([])
})

test('every class that a view takes from a style sheet stands in it', () => {
  const missing: string[] = []
  for (const [path, text] of Object.entries(sources)) {
    const code = text.replaceAll(/^import .*$/gm, '')
    for (const [, alias = '', sheet = ''] of text.matchAll(/^import (\w+) from '(\S+\.module\.css)'/gm)) {
      const known = classesOf(styles[`../../${new URL(sheet, `http://x/${path.slice(6)}`).pathname.slice(1)}`])
      for (const [, used = ''] of code.matchAll(new RegExp(`(?<![.\\w])${alias}\\.(\\w+)`, 'g')))
        if (!known.has(used)) missing.push(`${path}: ${alias}.${used}`)
    }
  }
  expect(missing).toEqual([])
})

test('no element has a class that is not scoped to a view', () => {
  const bare = Object.entries(sources).filter(([, text]) => /\bclass: ['`](?!\$\{)/.test(text))
  expect(bare.map(([path]) => path)).toEqual([])
})
