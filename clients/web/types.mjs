// Types of the service's documents from its contract: writes src/api/openapi.ts, which tsc and editors read.
// Of the contract only the schemas are taken: the page spells its paths itself.
import { execFileSync } from 'node:child_process'
import { existsSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import openapiTS, { astToString } from 'openapi-typescript'

const TARGET = new URL('src/api/openapi.ts', import.meta.url)
const CONTRACT = new URL('../../server/openapi.cmake', import.meta.url)

/// server/openapi.json with the schemas of io/schema in it.
function contract() {
  const folder = mkdtempSync(join(tmpdir(), 'coapt-types-'))
  try {
    const file = join(folder, 'openapi.json')
    execFileSync('cmake', ['-D', `OUTPUT=${file}`, '-P', CONTRACT.pathname])
    return JSON.parse(readFileSync(file, 'utf8'))
  } finally {
    rmSync(folder, { recursive: true })
  }
}

const { openapi, info, components } = contract()
const schemas = { openapi, info, paths: {}, components: { schemas: components.schemas } }
// A field with a default may be left out of a request; three numbers are a tuple.
const types = astToString(await openapiTS(schemas, { defaultNonNullable: false, arrayLength: true }))
const text = `// Generated from server/openapi.json by make types.\n\n${types}`

// Untouched if it is the same, so that the page is not built anew.
if (!existsSync(TARGET) || readFileSync(TARGET, 'utf8') !== text) writeFileSync(TARGET, text)
