// Where a valve is seen from: a view with a name, or a sight that was recorded.
import type { ValveShape } from '../api/types'
import { heldIn, wholeValve } from './marks'
import type { Sight, Stage, ViewName } from './stage'

export type Camera = ViewName | Sight

/// `nodes`: of the state that is drawn; a sight is that of the unloaded valve, so that it is the same in every state.
export function lookAt(stage: Stage, camera: Camera, scene: ValveShape, nodes?: ArrayLike<number>): void {
  if (typeof camera === 'string') stage.look(camera, heldIn(camera, scene, nodes))
  else stage.see(camera, wholeValve(scene))
}
