// The files that an import reads, by extension: the lists of io/exchange/file_roles.cpp, io/image/label_map.cpp and
// io/mesh/csv_table.cpp, with which a unit test compares these. Models of Abaqus (.inp) and DICOM are read by the command line alone.
export const MESHES = ['obj', 'ply', 'stl', 'glb', 'gltf', 'vtk', 'vtp', 'vtu']
export const LABEL_MAPS = ['nrrd', 'nhdr', 'nii', 'gz', 'bz2', 'mha', 'mhd'] // gz and bz2: of any of them
export const TABLES = ['csv', 'txt', 'tsv', 'dat', 'xyz', 'fcsv']
export const COMPANIONS = ['vtm', 'raw', 'zraw', 'bin'] // read with the files that name them, or that they name
const FORMATS = [...LABEL_MAPS, ...MESHES, ...TABLES, 'json', ...COMPANIONS]
const NOT_DATA = ['license', 'readme', 'copying', 'notice']

export const MOST_FILES = 100 // of a preview

/// What a file picker accepts.
export const ACCEPTED = FORMATS.map((format) => `.${format}`).join(',')

export function extensionOf(name: string): string {
  return name.split('.').pop()?.toLowerCase() ?? ''
}

export function isImportable(name: string): boolean {
  const lower = name.toLowerCase()
  return (
    !lower.startsWith('.') && FORMATS.includes(extensionOf(name)) && !NOT_DATA.some((word) => lower.startsWith(word))
  )
}
