import { DoubleSide, FloatType, NearestFilter, NoBlending, RedFormat, ShaderMaterial, WebGLRenderTarget } from 'three';
import { aimCamera, createEyeCamera } from '../display/eye.ts';
import type { RoomView } from '../display/room-view.ts';
import type { DepthCameraPose } from './depth-sensor.ts';
import { type Affine, depthClipFromView } from './depth-transform.ts';

/** Measures the room exactly: meters along the camera's axis, drawn into a float target at the centers of the buffer's texels. */
export interface DepthCamera {
  /** Row-major from the top; 0 where the camera's ray meets nothing. The same array every time. */
  measure(pose: DepthCameraPose): Float32Array;
  dispose(): void;
}

export function createDepthCamera(view: RoomView, widthPx: number, heightPx: number, map: Affine): DepthCamera {
  const target = new WebGLRenderTarget(widthPx, heightPx, {
    format: RedFormat,
    type: FloatType,
    minFilter: NearestFilter,
    magFilter: NearestFilter,
  });
  // A flip turns front faces into back faces.
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
