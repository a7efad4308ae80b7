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
import type { Triple } from './solid.ts';

/** Shadow map of the sun. */
export interface SunMap {
  readonly texture: DepthTexture;
  /** World space to clip space of the map. The object stays the same if the sun moves. */
  readonly mapFromWorld: Matrix4;
  /** Sets the unit vector towards the sun. Call `draw` afterwards. */
  aim(towardsSun: Triple): void;
  draw(renderer: WebGLRenderer, scene: Scene): void;
  dispose(): void;
}

export function createSunMap(sizePx: number, reachM: number): SunMap {
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
  const up = new Vector3();
  const clipFromSun = new Matrix4().makeOrthographic(-reachM, reachM, reachM, -reachM, 0.1, reachM * 4);
  const mapFromWorld = new Matrix4();
  const camera = createEyeCamera();
  return {
    texture,
    mapFromWorld,
    aim: (towardsSun) => {
      const eye = new Vector3(...towardsSun).multiplyScalar(reachM * 2).add(center);
      // For a vertical direction, +y cannot be the up vector.
      up.set(0, Math.abs(towardsSun[1]) > 0.99 ? 0 : 1, Math.abs(towardsSun[1]) > 0.99 ? -1 : 0);
      const worldFromSun = new Matrix4().lookAt(eye, center, up).setPosition(eye);
      mapFromWorld.copy(worldFromSun).invert().premultiply(clipFromSun);
      aimCamera(camera, clipFromSun.elements, worldFromSun.elements);
    },
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
