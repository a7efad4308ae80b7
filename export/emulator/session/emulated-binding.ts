import { P_FRAME, P_SESSION } from 'iwer';
import { encodeDepth, encodeWindowDepth } from '../depth/depth-encoding.ts';
import { EmulatedWebGlDepthInformation } from '../depth/depth-information.ts';
import { createDepthTexture, type DepthTexture } from '../depth/depth-texture.ts';
import { borrowGl } from '../display/app-gl.ts';
import { type EmulatedLightProbe, probeState } from '../light/light-probe.ts';
import { createReflectionCube } from '../light/reflection-cube.ts';
import { P_EMULATED, P_EYE } from '../private.ts';
import { CameraImages } from './camera-images.ts';
import type { EmulatedSession } from './emulated-session.ts';
import { type EmulatedCamera, EmulatedView } from './emulated-view.ts';

/** XRWebGLBinding: what the device brings into a page's own context. */
export class EmulatedBinding {
  readonly #session: EmulatedSession;
  readonly #gl: WebGL2RenderingContext;
  readonly #images: CameraImages;
  /** Each is the page's, which may delete it sooner. */
  readonly #cubes: WebGLTexture[] = [];
  #depth: DepthTexture | null = null;

  constructor(session: EmulatedSession, context: WebGL2RenderingContext) {
    if (session[P_SESSION].ended) throw new DOMException('The session has ended.', 'InvalidStateError');
    if (context.isContextLost()) throw new DOMException('The WebGL context is lost.', 'InvalidStateError');
    this.#session = session;
    this.#gl = context;
    this.#images = new CameraImages(context);
    session[P_EMULATED].disposers.push(() => this.#dispose());
  }

  get nativeProjectionScaleFactor(): number {
    return 1;
  }

  /** WebXR Depth Sensing §3.3. */
  getDepthInformation(view: EmulatedView): EmulatedWebGlDepthInformation | null {
    const depth = this.#session.requireDepth();
    this.#checkView(view);
    if (depth.usage !== 'gpu-optimized') throw new DOMException('Depth was granted for the CPU.', 'InvalidStateError');
    const { world, eyes } = this.#session[P_EMULATED];
    const { index } = view[P_EYE];
    const shot = world.tracked ? depth.shot(index) : null;
    if (!shot) return null;
    const { metres } = shot;
    const windowNearM = depth.gpuValues === 'window' ? this.#session.renderState.depthNear : null;
    const encoded = windowNearM === null ? encodeDepth(metres, depth.format) : encodeWindowDepth(metres, depth.widthPx, windowNearM);
    const layers = eyes.length === 2 ? 2 : 1;
    const texture = borrowGl(this.#gl, () => {
      const format = windowNearM === null ? depth.format : 'float32';
      this.#depth ??= createDepthTexture(this.#gl, depth.widthPx, depth.heightPx, layers, format);
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

  /** WebXR Raw Camera Access §3.3. Row 0 of the texture is the bottom of the picture. */
  getCameraImage(camera: EmulatedCamera): WebGLTexture {
    const view = camera[P_EYE];
    this.#checkView(view);
    return borrowGl(this.#gl, () => this.#images.update(this.#session[P_EMULATED].surroundings.view.canvas, view));
  }

  /** WebXR Lighting Estimation §5.1: a new texture each time. */
  getReflectionCubeMap(probe: EmulatedLightProbe): WebGLTexture | null {
    if (this.#gl.isContextLost()) throw new DOMException('The WebGL context is lost.', 'InvalidStateError');
    if (this.#session[P_SESSION].ended) throw new DOMException('The session has ended.', 'InvalidStateError');
    const state = probeState(probe);
    if (state?.session !== this.#session) throw new DOMException('The light probe belongs to another session.', 'InvalidStateError');
    const faces = this.#session[P_EMULATED].light.reflection();
    if (!faces) return null;
    const cube = borrowGl(this.#gl, () => createReflectionCube(this.#gl, faces, state.format));
    this.#cubes.push(cube);
    return cube;
  }

  #checkView(view: EmulatedView): void {
    if (!(view instanceof EmulatedView) || view[P_EYE].frame.session !== this.#session || !view[P_EYE].frame[P_FRAME].active) {
      throw new DOMException('The view belongs to another session, or its frame is over.', 'InvalidStateError');
    }
  }

  #dispose(): void {
    this.#images.dispose();
    this.#depth?.dispose();
    for (const cube of this.#cubes.splice(0)) this.#gl.deleteTexture(cube);
  }
}
