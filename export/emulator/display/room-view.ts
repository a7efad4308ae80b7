import {
  CustomBlending,
  DataTexture,
  FramebufferTexture,
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
  /** For its size and place in the page; `image` has the current image. */
  readonly canvas: HTMLCanvasElement;
  readonly renderer: WebGLRenderer;
  readonly scene: Scene;
  resize(widthPx: number, heightPx: number): void;
  /**
   * Makes the room alone the current image, for every eye, as the device's cameras see it. It is drawn when the image is used, because of
   * most frames that a test steps nobody sees the room.
   */
  aimRoom(eyes: readonly Eye[]): void;
  /** The canvas with the current image. */
  image(): HTMLCanvasElement;
  /** Composites a layer over the current image; `gain` is that of additive displays. `rgba` is premultiplied, rows from the bottom, of the canvas size. */
  drawLayer(rgba: Uint8Array, blend: BlendMode, gain: number): void;
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
  let aimed: readonly Eye[] | null = null;
  const drawRoom = (): void => {
    if (!aimed) return;
    renderer.setRenderTarget(null);
    renderer.setScissorTest(false);
    renderer.setClearColor(0x000000, 1);
    renderer.clear();
    for (const { clipFromView, worldFromView, viewport } of aimed) {
      renderer.setViewport(viewport.x, viewport.y, viewport.widthPx, viewport.heightPx);
      aimCamera(camera, clipFromView, worldFromView);
      renderer.render(scene, camera);
    }
    aimed = null;
  };

  return {
    canvas: renderer.domElement,
    renderer,
    scene,
    resize: (widthPx, heightPx) => renderer.setSize(widthPx, heightPx, false),
    aimRoom: (eyes) => {
      aimed = eyes;
    },
    image: () => {
      drawRoom();
      return renderer.domElement;
    },
    drawLayer: (rgba, blend, gain) => {
      drawRoom();
      renderer.setRenderTarget(null);
      renderer.setViewport(0, 0, renderer.domElement.width, renderer.domElement.height);
      overlay.draw(renderer, rgba, blend, gain);
    },
    readPixels: (out) => {
      drawRoom();
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

/**
 * Fragment shader that draws a layer over the room. With a gain, seen = room + gain × layer in linear light, which `compositePixels`
 * computes on the CPU.
 */
const OVERLAY_FRAGMENT = /* glsl */ `
uniform sampler2D layer;
uniform sampler2D room;
uniform float gain;
varying vec2 layerUv;

vec3 linear( const in vec3 c ) {
  return mix( pow( ( c + 0.055 ) / 1.055, vec3( 2.4 ) ), c / 12.92, vec3( lessThanEqual( c, vec3( 0.04045 ) ) ) );
}

vec3 encoded( const in vec3 c ) {
  return mix( 1.055 * pow( c, vec3( 1.0 / 2.4 ) ) - 0.055, c * 12.92, vec3( lessThanEqual( c, vec3( 0.0031308 ) ) ) );
}

void main() {
  gl_FragColor = texture( layer, layerUv );
  if ( gain == 0.0 ) return;
  vec3 below = texture( room, layerUv ).rgb;
  vec3 seen = encoded( min( linear( below ) + gain * linear( gl_FragColor.rgb ), 1.0 ) );
  gl_FragColor = vec4( mix( seen, below, vec3( equal( gl_FragColor.rgb, vec3( 0.0 ) ) ) ), 1.0 );
}
`;

interface Overlay {
  draw(renderer: WebGLRenderer, rgba: Uint8Array, blend: BlendMode, gain: number): void;
  dispose(): void;
}

function createOverlay(): Overlay {
  const material = new ShaderMaterial({
    uniforms: { layer: { value: null }, room: { value: null }, gain: { value: 0 } },
    // The plane covers the canvas regardless of the camera.
    vertexShader: 'varying vec2 layerUv; void main() { layerUv = uv; gl_Position = vec4(position.xy * 2.0, 0.0, 1.0); }',
    fragmentShader: OVERLAY_FRAGMENT,
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
  let behind: FramebufferTexture | null = null;
  return {
    draw: (renderer, rgba, blend, gain) => {
      const { width, height } = renderer.domElement;
      if (!texture || texture.image.width !== width || texture.image.height !== height) {
        texture?.dispose();
        texture = new DataTexture(rgba, width, height, RGBAFormat, UnsignedByteType);
      }
      texture.image.data = rgba;
      texture.needsUpdate = true;
      material.uniforms.layer = { value: texture };
      // Light is added in the shader, because blending adds encoded values.
      if (blend === 'additive') {
        if (behind?.image.width !== width || behind.image.height !== height) {
          behind?.dispose();
          behind = new FramebufferTexture(width, height);
        }
        renderer.copyFramebufferToTexture(behind);
      }
      material.uniforms.room = { value: behind };
      material.uniforms.gain = { value: blend === 'additive' ? gain : 0 };
      material.blending = blend === 'alpha-blend' ? CustomBlending : NoBlending;
      material.blendDst = OneMinusSrcAlphaFactor;
      renderer.render(scene, camera);
    },
    dispose: () => {
      texture?.dispose();
      behind?.dispose();
      plane.geometry.dispose();
      material.dispose();
    },
  };
}
