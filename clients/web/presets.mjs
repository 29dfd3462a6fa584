// The presets as files, for what has no service: FOLDER/presets/NAME.json, and their names in index.json.
import { execFileSync } from 'node:child_process'
import { mkdirSync, writeFileSync } from 'node:fs'
import { join } from 'node:path'

export function writePresets(folder, coapt) {
  const presets = join(folder, 'presets')
  mkdirSync(presets, { recursive: true })
  const answer = execFileSync(coapt, ['presets', '--json'], { encoding: 'utf8' })
  const names = JSON.parse(answer).presets.map(({ name }) => name)
  for (const name of names) execFileSync(coapt, ['valve', 'make', name, '-o', join(presets, `${name}.json`)])
  writeFileSync(join(presets, 'index.json'), JSON.stringify(names))
}
