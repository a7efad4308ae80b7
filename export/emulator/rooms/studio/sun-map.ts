import {
  DepthTexture,
  DoubleSide,
  LessEqualCompare,
  LinearFilter,
  Matrix4,
  type Scene,
  ShaderMaterial,
  UnsignedIntType,
  Vector3,
  type WebGLRenderer,
  WebGLRenderTarget,
} from 'three';
import { aimCamera, createEyeCamera } from '../../display/eye.ts';

/** Depth of the room as the sun sees it through the window, drawn once. */
export interface SunMap {
  readonly texture: DepthTexture;
  /** To device coordinates of the map. */
  readonly mapFromWorld: Matrix4;
  draw(renderer: WebGLRenderer, scene: Scene): void;
  dispose(): void;
}

export function createSunMap(sizePx: number, towardsSun: readonly [number, number, number], reachM: number): SunMap {
  const texture = new DepthTexture(sizePx, sizePx, UnsignedIntType);
  texture.compareFunction = LessEqualCompare;
  texture.minFilter = LinearFilter;
  texture.magFilter = LinearFilter;
  const target = new WebGLRenderTarget(sizePx, sizePx, { depthTexture: texture });
  const material = new ShaderMaterial({
    side: DoubleSide,
    colorWrite: false,
    vertexShader: 'void main() { gl_Position = projectionMatrix * viewMatrix * vec4(position, 1.0); }',
    fragmentShader: 'void main() { gl_FragColor = vec4(1.0); }',
  });
  const center = new Vector3(0, 1.1, 0);
  const eye = center.clone().addScaledVector(new Vector3(...towardsSun), reachM * 2);
  const worldFromSun = new Matrix4().lookAt(eye, center, new Vector3(0, 1, 0)).setPosition(eye);
  const clipFromSun = new Matrix4().makeOrthographic(-reachM, reachM, reachM, -reachM, 0.1, reachM * 4);
  const camera = createEyeCamera();
  aimCamera(camera, clipFromSun.elements, worldFromSun.elements);
  return {
    texture,
    mapFromWorld: clipFromSun.clone().multiply(worldFromSun.clone().invert()),
    draw: (renderer, scene) => {
      renderer.setRenderTarget(target);
      renderer.clear();
      scene.overrideMaterial = material;
      renderer.render(scene, camera);
      scene.overrideMaterial = null;
      renderer.setRenderTarget(null);
    },
    dispose: () => {
      target.dispose();
      texture.dispose();
      material.dispose();
    },
  };
}
