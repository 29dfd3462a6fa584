// What of a sight (stage.ts) a story may record.
export const ZOOM = { min: 0.1, max: 20 }
export const TOWARDS_MM = { min: -100, max: 100 } // of each coordinate
