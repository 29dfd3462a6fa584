// The tables that a study writes: a header line, commas, quotes where a cell has a comma (RFC 4180).

export type Row = Record<string, string>

export function parseCsv(text: string): Row[] {
  const [header = [], ...lines] = cellsOf(text)
  return lines.map((cells) => Object.fromEntries(header.map((name, i) => [name, cells[i] ?? ''])))
}

function cellsOf(text: string): string[][] {
  const lines: string[][] = []
  let cells: string[] = []
  const cell = /("(?:[^"]|"")*"|[^,\r\n]*)(,|\r?\n|$)/y
  while (cell.lastIndex < text.length) {
    const match = cell.exec(text)
    if (!match) break
    const [, content = '', end] = match
    cells.push(content.startsWith('"') ? content.slice(1, -1).replaceAll('""', '"') : content)
    if (end === ',') continue
    lines.push(cells)
    cells = []
  }
  return lines
}

/// Null where the cell is empty or no number.
export function numberIn(row: Row, column: string): number | null {
  const text = row[column]
  if (text === undefined || text === '') return null
  const value = Number(text)
  return Number.isFinite(value) ? value : null
}

/// The values of a column, each once, in their order.
export function distinct(rows: Row[], column: string): string[] {
  return [...new Set(rows.map((row) => row[column] ?? ''))]
}

export function mean(values: (number | null)[]): number | null {
  const known = values.filter((value): value is number => value !== null)
  return known.length > 0 ? known.reduce((sum, value) => sum + value, 0) / known.length : null
}

export function median(values: (number | null)[]): number | null {
  const known = values.filter((value): value is number => value !== null).sort((a, b) => a - b)
  if (known.length === 0) return null
  const half = known.length / 2
  return ((known[Math.ceil(half) - 1] as number) + (known[Math.floor(half)] as number)) / 2
}
