import { FramebufferTexture, Mesh, NoBlending, PlaneGeometry, Scene, ShaderMaterial, type WebGLRenderer } from 'three';
import { createEyeCamera, type Eye } from './eye.ts';

/** The image of a room in which nothing moves. It is drawn again only when the eyes, the canvas or the room have changed. */
export interface KeptImage {
  /** Draws the room over the cleared canvas for the eyes: by `render`, or from the image that it gave last. */
  draw(eyes: readonly Eye[], render: () => void): void;
  /** Call it after the room has changed. */
  forget(): void;
  dispose(): void;
}

/** @param renderer Draws to its canvas, without a render target. */
export function createKeptImage(renderer: WebGLRenderer): KeptImage {
  const { domElement: canvas } = renderer;
  const material = new ShaderMaterial({
    uniforms: { room: { value: null } },
    vertexShader: 'varying vec2 roomUv; void main() { roomUv = uv; gl_Position = vec4(position.xy * 2.0, 0.0, 1.0); }',
    fragmentShader: 'uniform sampler2D room; varying vec2 roomUv; void main() { gl_FragColor = texture(room, roomUv); }',
    depthTest: false,
    depthWrite: false,
    blending: NoBlending,
  });
  const plane = new Mesh(new PlaneGeometry(1, 1), material);
  plane.frustumCulled = false;
  const scene = new Scene();
  scene.add(plane);
  const camera = createEyeCamera();
  /** What the last image was drawn from. */
  let last: readonly number[] = [];
  let kept: FramebufferTexture | null = null;
  const forget = (): void => {
    last = [];
    kept?.dispose();
    kept = null;
  };
  // The room is drawn from its textures and meshes again, which three.js restores.
  canvas.addEventListener('webglcontextlost', forget);
  return {
    draw: (eyes, render) => {
      const { width, height } = canvas;
      const now = [width, height, ...eyes.flatMap(numbersOf)];
      const same = now.length === last.length && now.every((value, i) => value === last[i]);
      if (same && kept) {
        renderer.setViewport(0, 0, width, height);
        material.uniforms.room = { value: kept };
        renderer.render(scene, camera);
        return;
      }
      if (!same) forget();
      last = now;
      render();
      // Of eyes that move, no image is needed twice.
      if (!same) return;
      kept = new FramebufferTexture(width, height);
      renderer.copyFramebufferToTexture(kept);
    },
    forget,
    dispose: () => {
      canvas.removeEventListener('webglcontextlost', forget);
      forget();
      plane.geometry.dispose();
      material.dispose();
    },
  };
}

function numbersOf({ clipFromView, worldFromView, viewport }: Eye): number[] {
  return [...clipFromView, ...worldFromView, viewport.x, viewport.y, viewport.widthPx, viewport.heightPx];
}
