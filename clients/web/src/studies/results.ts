// What a study has found: findings, its figures drawn from its tables, its files.
import { getJson, request } from '../api/http'
import type { Job, JobFile, StudyResult } from '../api/types'
import { h } from '../dom'
import { filesOf } from '../jobs/calls'
import { downloadButton, reportLink } from '../jobs/downloads'
import { annulusFigure } from './annulus_figure'
import { anchorsTable, approximationFigure, scanFigure } from './approximation_figure'
import { parseCsv, type Row } from './csv'
import { findingsTable } from './findings'
import { papillaryFigure } from './papillary_figure'
import { ringFigure } from './ring_figure'
import jobsStyle from '../jobs/jobs.module.css'
import parts from '../style/parts.module.css'
import studiesStyle from './studies.module.css'

interface Drawing {
  file: string
  title: string
  draw(rows: Row[], tables: Map<string, Row[]>, signal: AbortSignal): HTMLElement
}

const DRAWINGS: Drawing[] = [
  {
    file: 'annulus.csv',
    title: 'Annular dilation and flattening (figure 4.5)',
    draw: (rows, _, signal) => annulusFigure(rows, signal),
  },
  {
    file: 'papillary.csv',
    title: 'Papillary displacement (figures 4.6 to 4.8)',
    draw: (rows, _, signal) => papillaryFigure(rows, signal),
  },
  { file: 'ring.csv', title: 'Undersized rings (figure 4.9)', draw: (rows, _, signal) => ringFigure(rows, signal) },
  {
    file: 'approximation.csv',
    title: 'Trigone versus saddle peak (figure 4.10)',
    draw: (rows, _, signal) => approximationFigure(rows, signal),
  },
  { file: 'anchors.csv', title: 'Anchors', draw: (rows) => anchorsTable(rows) },
  {
    file: 'anchor-scan.csv',
    title: 'Anchors around the annulus',
    draw: (rows, tables, signal) => scanFigure(rows, tables.get('anchors.csv') ?? [], signal),
  },
]

export async function studyResults(job: Job, signal: AbortSignal): Promise<HTMLElement> {
  const [result, files] = await Promise.all([
    getJson<StudyResult>(`/v1/jobs/${job.id}/result`, signal),
    filesOf(job.id),
  ])
  const wanted = DRAWINGS.filter(({ file }) => files.some(({ name }) => name === file))
  const tables = new Map(
    await Promise.all(
      wanted.map(async ({ file }): Promise<[string, Row[]]> => {
        const answer = await request('GET', `/v1/jobs/${job.id}/files/${file}`, undefined, signal)
        return [file, parseCsv(await answer.text())]
      }),
    ),
  )
  return h(
    'div',
    { class: jobsStyle.results },
    findingsTable(result),
    ...wanted.map(({ file, title, draw }) =>
      figureSection(title, files, file, draw(tables.get(file) ?? [], tables, signal)),
    ),
    fileList(job, files),
  )
}

function figureSection(title: string, files: JobFile[], name: string, drawn: HTMLElement): HTMLElement {
  const told = h('div', {})
  const file = files.find((one) => one.name === name)
  return h(
    'section',
    { class: `${parts.panel} ${studiesStyle.studyFigure}`, 'data-part': 'study-figure', 'aria-label': title },
    h('div', { class: parts.row }, h('h2', {}, title), file && downloadButton(name, file.path, name, told)),
    told,
    drawn,
  )
}

function fileList(job: Job, files: JobFile[]): HTMLElement {
  const told = h('div', {})
  return h(
    'section',
    { class: parts.panel, 'aria-label': 'Files of the study' },
    h('h2', {}, 'Files'),
    h(
      'div',
      { class: parts.row },
      reportLink('Report of the study', `/v1/jobs/${job.id}/report`, 'coapt-study.html', told),
      ...files
        .filter(({ name }) => name !== 'index.html')
        .map((file) => downloadButton(file.name, file.path, file.name, told)),
    ),
    told,
  )
}
