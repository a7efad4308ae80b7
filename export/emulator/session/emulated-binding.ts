import { P_FRAME, P_SESSION } from 'iwer';
import { encodeDepth, encodeWindowDepth } from '../depth/depth-encoding.ts';
import { EmulatedWebGlDepthInformation } from '../depth/depth-information.ts';
import { createDepthTexture, type DepthTexture } from '../depth/depth-texture.ts';
import { borrowGl, type Gl, isWebGl2 } from '../display/app-gl.ts';
import { type EmulatedCompositionLayer, EmulatedProjectionLayer, P_LAYER } from '../layers/composition-layer.ts';
import {
  type CylinderLayerInit,
  createCylinderLayer,
  createProjectionLayer,
  createQuadLayer,
  type ProjectionLayerInit,
  type QuadLayerInit,
} from '../layers/create-layers.ts';
import { accessImages, EmulatedSubImage, partForEye } from '../layers/sub-image.ts';
import { type EmulatedLightProbe, probeState } from '../light/light-probe.ts';
import { createReflectionCube } from '../light/reflection-cube.ts';
import { P_EMULATED, P_EYE } from '../private.ts';
import { isXrCompatible } from '../xr-compatible.ts';
import { CameraImages } from './camera-images.ts';
import type { EmulatedFrame } from './emulated-frame.ts';
import type { EmulatedSession } from './emulated-session.ts';
import { type EmulatedCamera, EmulatedView } from './emulated-view.ts';
import type { EmulatedRenderState } from './render-state.ts';

/** `XRWebGLBinding`: layers, depth, camera images and reflections in the page's context. */
export class EmulatedBinding {
  readonly #session: EmulatedSession;
  readonly #gl: Gl;
  readonly #images: CameraImages;
  /** Cube maps that the page has received, to be deleted at the end of the session. The page owns them and may delete them earlier. */
  readonly #cubes: WebGLTexture[] = [];
  #depth: DepthTexture | null = null;

  constructor(session: EmulatedSession, context: Gl) {
    if (session[P_SESSION].ended) throw new DOMException('The session has ended.', 'InvalidStateError');
    if (context.isContextLost()) throw new DOMException('The WebGL context is lost.', 'InvalidStateError');
    this.#session = session;
    this.#gl = context;
    if (session[P_SESSION].mode === 'inline') {
      throw new DOMException('Bindings require an immersive session.', 'InvalidStateError');
    }
    if (!isXrCompatible(context)) throw new DOMException('The context is not XR compatible.', 'InvalidStateError');
    this.#images = new CameraImages(context);
    session[P_EMULATED].disposers.push(() => this.#dispose());
  }

  get nativeProjectionScaleFactor(): number {
    return 1;
  }

  get usesDepthValues(): boolean {
    return false;
  }

  // --- Layers: WebXR Layers §5 ---

  createProjectionLayer(init: ProjectionLayerInit = {}): EmulatedProjectionLayer {
    return createProjectionLayer(this.#session, this.#gl, init);
  }

  createQuadLayer(init: QuadLayerInit): ReturnType<typeof createQuadLayer> {
    return createQuadLayer(this.#session, this.#gl, init);
  }

  createCylinderLayer(init: CylinderLayerInit): ReturnType<typeof createCylinderLayer> {
    return createCylinderLayer(this.#session, this.#gl, init);
  }

  createEquirectLayer(): never {
    throw new DOMException('The emulated device supports only projection, quad and cylinder layers.', 'NotSupportedError');
  }

  createCubeLayer(): never {
    return this.createEquirectLayer();
  }

  getSubImage(layer: EmulatedCompositionLayer, frame: EmulatedFrame, eye: 'none' | 'left' | 'right' = 'none'): EmulatedSubImage {
    if (layer instanceof EmulatedProjectionLayer) throw new TypeError('The layer is a projection layer. Call getViewSubImage.');
    this.#checkLayer(layer);
    if (frame?.session !== this.#session || !frame[P_FRAME].active || !frame[P_FRAME].animationFrame) {
      throw new DOMException('The frame belongs to another session or has ended.', 'InvalidStateError');
    }
    if (layer.layout === 'stereo' && eye === 'none') throw new TypeError('The layer is stereo. Pass the eye "left" or "right".');
    const images = accessImages(layer, frame);
    const { viewport, index } = partForEye(layer.layout, images, eye);
    return new EmulatedSubImage(images, viewport, index);
  }

  getViewSubImage(layer: EmulatedProjectionLayer, view: EmulatedView): EmulatedSubImage {
    if (!(layer instanceof EmulatedProjectionLayer)) throw new TypeError('The layer is not a projection layer. Call getSubImage.');
    this.#checkLayer(layer);
    this.#checkView(view);
    const { frame, eye } = view[P_EYE];
    const images = accessImages(layer, frame);
    const { viewport, index } = partForEye(layer.layout, images, eye.name);
    return new EmulatedSubImage(images, view.viewportIn(viewport), index);
  }

  #checkLayer(layer: EmulatedCompositionLayer): void {
    const { session, destroyed } = layer[P_LAYER];
    if (session !== this.#session) throw new TypeError('The layer belongs to another session.');
    if (destroyed) throw new DOMException('The layer was destroyed.', 'InvalidStateError');
    const { layers } = session[P_SESSION].renderState as EmulatedRenderState;
    if (!layers.includes(layer)) throw new TypeError('The layer is not in the session’s layers. Add it with updateRenderState first.');
  }

  /** `getDepthInformation` of WebXR Depth Sensing §3.3: depth of a view as a texture. */
  getDepthInformation(view: EmulatedView): EmulatedWebGlDepthInformation | null {
    const depth = this.#session.requireDepth();
    this.#checkView(view);
    if (depth.usage !== 'gpu-optimized')
      throw new DOMException('The session uses CPU depth. Call getDepthInformation of XRFrame.', 'InvalidStateError');
    const { world, eyes } = this.#session[P_EMULATED];
    const { index } = view[P_EYE];
    const shot = world.tracked ? depth.shot(index) : null;
    if (!shot) return null;
    const { meters } = shot;
    const windowNearM = depth.gpuValues === 'window' ? this.#session.renderState.depthNear : null;
    const encoded = windowNearM === null ? encodeDepth(meters, depth.format) : encodeWindowDepth(meters, depth.widthPx, windowNearM);
    const layers = eyes.length === 2 ? 2 : 1;
    const gl = requireWebGl2(this.#gl);
    const texture = borrowGl(gl, () => {
      const format = windowNearM === null ? depth.format : 'float32';
      this.#depth ??= createDepthTexture(gl, depth.widthPx, depth.heightPx, layers, format);
      this.#depth.upload(encoded, index);
      return this.#depth.texture;
    });
    return new EmulatedWebGlDepthInformation(
      view,
      depth,
      shot,
      encoded.rawValueToMeters,
      texture,
      layers === 2 ? index : null,
      windowNearM,
    );
  }

  /** `getCameraImage` of WebXR Raw Camera Access §3.3. Row 0 of the texture is the bottom of the image. */
  getCameraImage(camera: EmulatedCamera): WebGLTexture {
    const view = camera[P_EYE];
    this.#checkView(view);
    return borrowGl(this.#gl, () => this.#images.update(this.#session[P_EMULATED].roomServices.view, view));
  }

  /** `getReflectionCubeMap` of WebXR Lighting Estimation §5.1. Each call creates a texture. */
  getReflectionCubeMap(probe: EmulatedLightProbe): WebGLTexture | null {
    if (this.#gl.isContextLost()) throw new DOMException('The WebGL context is lost.', 'InvalidStateError');
    if (this.#session[P_SESSION].ended) throw new DOMException('The session has ended.', 'InvalidStateError');
    const state = probeState(probe);
    if (state?.session !== this.#session) throw new DOMException('The light probe belongs to another session.', 'InvalidStateError');
    const faces = this.#session[P_EMULATED].light.reflection();
    if (!faces) return null;
    const gl = requireWebGl2(this.#gl);
    const cube = borrowGl(gl, () => createReflectionCube(gl, faces, state.format));
    this.#cubes.push(cube);
    return cube;
  }

  #checkView(view: EmulatedView): void {
    if (!(view instanceof EmulatedView) || view[P_EYE].frame.session !== this.#session || !view[P_EYE].frame[P_FRAME].active) {
      throw new DOMException('The view belongs to another session or its frame has ended.', 'InvalidStateError');
    }
  }

  #dispose(): void {
    this.#images.dispose();
    this.#depth?.dispose();
    for (const cube of this.#cubes.splice(0)) this.#gl.deleteTexture(cube);
  }
}

/** Throws for WebGL 1, which has no formats for depth textures and float cube maps. */
function requireWebGl2(gl: Gl): WebGL2RenderingContext {
  if (isWebGl2(gl)) return gl;
  throw new DOMException('Depth textures and reflection cube maps of the emulated device require WebGL 2.', 'NotSupportedError');
}
