import { DoubleSide, FloatType, NearestFilter, NoBlending, RedFormat, ShaderMaterial, WebGLRenderTarget } from 'three';
import { aimCamera, createEyeCamera } from '../display/eye.ts';
import type { RoomView } from '../display/room-view.ts';
import type { DepthCameraPose } from './depth-sensor.ts';
import { type Affine, depthClipFromView } from './depth-transform.ts';

/** Measures exact room depth: view-space distance, rendered into a float target at the texel centers of the depth buffer. */
export interface DepthCamera {
  /** Meters, row-major from the top; 0 where no surface is hit. Each call returns the same array. */
  measure(pose: DepthCameraPose): Float32Array;
  dispose(): void;
}

/**
 * Creates a depth camera.
 *
 * @param view Source of the room's geometry; stays owned by the caller.
 * @param map Depth buffer UV from view UV, as `depthUvFromViewUv` returns it.
 */
export function createDepthCamera(view: RoomView, widthPx: number, heightPx: number, map: Affine): DepthCamera {
  const target = new WebGLRenderTarget(widthPx, heightPx, {
    format: RedFormat,
    type: FloatType,
    minFilter: NearestFilter,
    magFilter: NearestFilter,
  });
  // A flip reverses the winding, so both sides are drawn.
  const material = new ShaderMaterial({
    side: DoubleSide,
    blending: NoBlending,
    vertexShader: `
varying float viewZM;
void main() {
  vec4 inView = modelViewMatrix * vec4(position, 1.0);
  viewZM = -inView.z;
  gl_Position = projectionMatrix * inView;
}`,
    fragmentShader: 'varying float viewZM; void main() { gl_FragColor = vec4(viewZM, 0.0, 0.0, 1.0); }',
  });
  const camera = createEyeCamera();
  const meters = new Float32Array(widthPx * heightPx);
  return {
    measure: ({ worldFromDepth, clipFromDepth }) => {
      const { renderer, scene } = view;
      aimCamera(camera, depthClipFromView(clipFromDepth, map), worldFromDepth);
      renderer.setRenderTarget(target);
      renderer.setClearColor(0x000000, 0);
      renderer.clear();
      scene.overrideMaterial = material;
      renderer.render(scene, camera);
      scene.overrideMaterial = null;
      renderer.readRenderTargetPixels(target, 0, 0, widthPx, heightPx, meters);
      renderer.setRenderTarget(null);
      return meters;
    },
    dispose: () => {
      target.dispose();
      material.dispose();
    },
  };
}
