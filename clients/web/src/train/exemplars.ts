// Which segments of a case stand for the three kinds.
import { type CaseB, MOBILITIES, type SegmentTruth } from './types'

/// Of each kind that there is the clearest one: the one that changed most, of normal ones that changed least.
export function exemplars({ segments }: Pick<CaseB, 'segments'>): SegmentTruth[] {
  return MOBILITIES.flatMap((mobility) => {
    const sign = mobility === 'normal' ? -1 : 1
    const [first, ...others] = segments.filter((truth) => truth.mobility === mobility)
    const clear = (truth: SegmentTruth): number => sign * Math.abs(truth.change_mm)
    return first ? [others.reduce((best, truth) => (clear(truth) > clear(best) ? truth : best), first)] : []
  })
}
