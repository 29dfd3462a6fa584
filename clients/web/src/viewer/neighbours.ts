// The aortic root and the appendage beside a valve, drawn as long as it is seen as the surgeon sees it.
import type { ValveShape } from '../api/types'
import type { Label } from './labels'
import { Lines } from './lines'
import { neighbours } from './marks'
import type { Stage } from './stage'

export class Neighbours {
  private readonly lines = new Lines({ width: 1.6, colour: '#8a6f6a' })
  private drawn = ''

  constructor(private readonly stage: Stage) {
    stage.add(this.lines.object)
  }

  /// Draws those whose names are in the picture; none of `null`. Returns the names.
  show(scene: ValveShape | null): Label[] {
    const all = scene && this.stage.isFromAbove ? neighbours(scene) : []
    const shown = all.filter(({ label }) => this.stage.shows(label.point_mm))
    const outlines = shown.flatMap(({ outline }) => outline)
    const asked = outlines.join()
    if (asked !== this.drawn) this.lines.set(outlines)
    this.drawn = asked
    return shown.map(({ label }) => label)
  }
}
