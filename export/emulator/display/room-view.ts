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

/** Draws the room on its own canvas and composites the page's layer over it: the image that the user of the device sees. */
export interface RoomView {
  readonly canvas: HTMLCanvasElement;
  readonly renderer: WebGLRenderer;
  readonly scene: Scene;
  resize(widthPx: number, heightPx: number): void;
  /** Draws the room alone, for every eye, as the device's cameras see it. */
  drawRoom(eyes: readonly Eye[]): void;
  /** Composites a layer over the current image. `rgba` is premultiplied, rows from the bottom, of the canvas size. */
  drawLayer(rgba: Uint8Array, blend: BlendMode): void;
  /** Reads the current image, rows from the bottom. */
  readPixels(out: Uint8Array): void;
  dispose(): void;
}

/**
 * Creates a room view with its own canvas and renderer, which `dispose` releases.
 *
 * @param room Null for a device without a room. The view does not dispose it.
 */
export function createRoomView(room: Room | null, antialias: boolean): RoomView {
  // The drawing buffer is preserved because tests and camera images read it after presentation.
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
    // The plane covers the canvas regardless of the camera.
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
