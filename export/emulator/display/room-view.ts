import {
  CustomBlending,
  DataTexture,
  Mesh,
  NoBlending,
  OneFactor,
  OneMinusSrcAlphaFactor,
  PlaneGeometry,
  RGBAFormat,
  Scene,
  ShaderMaterial,
  UnsignedByteType,
  WebGLRenderer,
} from 'three';
import type { Room } from '../rooms/room.ts';
import type { BlendMode } from './composite.ts';
import { aimCamera, createEyeCamera, type Eye } from './eye.ts';

/** The room drawn on a canvas of its own, and what a page drew laid over it: the picture that the user of the device has. */
export interface RoomView {
  readonly canvas: HTMLCanvasElement;
  readonly renderer: WebGLRenderer;
  readonly scene: Scene;
  resize(widthPx: number, heightPx: number): void;
  /** The room alone, for every eye: what the device's cameras see. */
  drawRoom(eyes: readonly Eye[]): void;
  /** A layer over what is drawn. `rgba` is premultiplied, rows from the bottom, as large as the canvas. */
  drawLayer(rgba: Uint8Array, blend: BlendMode): void;
  /** What is drawn, rows from the bottom. */
  readPixels(out: Uint8Array): void;
  dispose(): void;
}

export function createRoomView(room: Room | null, antialias: boolean): RoomView {
  // Kept after presenting, because tests and camera images read it at their own time.
  const renderer = new WebGLRenderer({ antialias, alpha: false, preserveDrawingBuffer: true });
  renderer.setPixelRatio(1);
  renderer.autoClear = false;
  const gl = renderer.getContext();
  const scene = new Scene();
  scene.matrixWorldAutoUpdate = false;
  if (room) {
    scene.add(room.solids);
    scene.updateMatrixWorld(true);
    room.prepare?.(renderer, scene);
  }
  const camera = createEyeCamera();
  const overlay = createOverlay();

  return {
    canvas: renderer.domElement,
    renderer,
    scene,
    resize: (widthPx, heightPx) => renderer.setSize(widthPx, heightPx, false),
    drawRoom: (eyes) => {
      renderer.setRenderTarget(null);
      renderer.setScissorTest(false);
      renderer.setClearColor(0x000000, 1);
      renderer.clear();
      for (const { clipFromView, worldFromView, viewport } of eyes) {
        renderer.setViewport(viewport.x, viewport.y, viewport.widthPx, viewport.heightPx);
        aimCamera(camera, clipFromView, worldFromView);
        renderer.render(scene, camera);
      }
    },
    drawLayer: (rgba, blend) => {
      renderer.setRenderTarget(null);
      renderer.setViewport(0, 0, renderer.domElement.width, renderer.domElement.height);
      overlay.draw(renderer, rgba, blend);
    },
    readPixels: (out) => {
      renderer.setRenderTarget(null);
      gl.readPixels(0, 0, renderer.domElement.width, renderer.domElement.height, gl.RGBA, gl.UNSIGNED_BYTE, out);
    },
    dispose: () => {
      if (room) scene.remove(room.solids);
      overlay.dispose();
      renderer.dispose();
      renderer.forceContextLoss();
    },
  };
}

interface Overlay {
  draw(renderer: WebGLRenderer, rgba: Uint8Array, blend: BlendMode): void;
  dispose(): void;
}

function createOverlay(): Overlay {
  const material = new ShaderMaterial({
    uniforms: { layer: { value: null } },
    // The plane spans the canvas whatever the camera is.
    vertexShader: 'varying vec2 layerUv; void main() { layerUv = uv; gl_Position = vec4(position.xy * 2.0, 0.0, 1.0); }',
    fragmentShader: 'uniform sampler2D layer; varying vec2 layerUv; void main() { gl_FragColor = texture(layer, layerUv); }',
    depthTest: false,
    depthWrite: false,
    blendSrc: OneFactor,
  });
  const scene = new Scene();
  const plane = new Mesh(new PlaneGeometry(1, 1), material);
  plane.frustumCulled = false;
  scene.add(plane);
  const camera = createEyeCamera();
  let texture: DataTexture | null = null;
  return {
    draw: (renderer, rgba, blend) => {
      const { width, height } = renderer.domElement;
      if (!texture || texture.image.width !== width || texture.image.height !== height) {
        texture?.dispose();
        texture = new DataTexture(rgba, width, height, RGBAFormat, UnsignedByteType);
      }
      texture.image.data = rgba;
      texture.needsUpdate = true;
      material.uniforms.layer = { value: texture };
      material.blending = blend === 'opaque' ? NoBlending : CustomBlending;
      material.blendDst = blend === 'additive' ? OneFactor : OneMinusSrcAlphaFactor;
      renderer.render(scene, camera);
    },
    dispose: () => {
      texture?.dispose();
      plane.geometry.dispose();
      material.dispose();
    },
  };
}
