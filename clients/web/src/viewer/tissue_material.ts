// Wet tissue, which lets depth be read from the atrium: a soft highlight, and the atrial side the darker the less light the
// annulus lets in. That is R²/(R² + d²) at depth d below a disc of radius R, on its axis (the form factor of a disc, Lambert
// 1760), here everywhere, with the disc that fits into the annulus. Where colours mean numbers, neither is drawn.
import { Color, DoubleSide, MeshPhongMaterial, Vector3 } from 'three'
import type { ValveShape } from '../api/types'
import { at, distance } from './geometry'

export const WET = { specular: new Color('#3d3a3a'), shininess: 50 }
const DRY = new Color('#000000')
const OCCLUSION = 0.9 // of the light comes through the annulus

/// Of meshes with an attribute `atrial`: 1 at the atrial side, 0 at the ventricular one.
export class TissueMaterial extends MeshPhongMaterial {
  readonly occlusion = {
    annulusMiddle: { value: new Vector3() },
    annulusNormal: { value: new Vector3(0, 0, 1) },
    annulusRadius: { value: 1 },
    occluded: { value: OCCLUSION },
  }

  constructor() {
    // A little behind lines that lie on it.
    const offset = { polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 1 }
    super({ vertexColors: true, side: DoubleSide, ...WET, ...offset })
    this.onBeforeCompile = (shader) => {
      Object.assign(shader.uniforms, this.occlusion)
      shader.vertexShader = `attribute float atrial;
uniform vec3 annulusMiddle, annulusNormal;
uniform float annulusRadius, occluded;
${shader.vertexShader}`.replace(
        '#include <color_vertex>',
        `#include <color_vertex>
float depth = max(0.0, dot(annulusMiddle - position, annulusNormal)) / annulusRadius;
vColor.rgb *= 1.0 - occluded * atrial * (1.0 - 1.0 / (1.0 + depth * depth));`,
      )
    }
  }

  /// Of another valve.
  set({ plane, annulus_mm }: ValveShape): void {
    const { annulusMiddle, annulusNormal, annulusRadius } = this.occlusion
    annulusMiddle.value.set(...plane.origin_mm)
    annulusNormal.value.set(...plane.normal)
    const away = Array.from({ length: annulus_mm.length / 3 }, (_, i) => distance(at(annulus_mm, i), plane.origin_mm))
    annulusRadius.value = Math.min(...away)
  }

  /// `isPlain`: colours tell leaflets apart, and mean no numbers.
  wet(isPlain: boolean): void {
    this.specular.copy(isPlain ? WET.specular : DRY)
    this.occlusion.occluded.value = isPlain ? OCCLUSION : 0
  }
}
