import {
  type Camera,
  LinearSRGBColorSpace,
  NoToneMapping,
  PCFShadowMap,
  type Scene,
  SRGBColorSpace,
  type WebGLRenderer as ThreeRenderer,
  WebGLRenderer,
  WebGLRenderTarget,
} from 'three';
import type { LayerEncoding } from '../../../nodes/kit/definition.ts';
import type { DrawView } from '../../../nodes/kit/runtime.ts';
import type { SceneHost } from '../scene-backend.ts';
import { catchLeftovers } from './leftovers.ts';

/** Draws with the renderer of three.js, but without its own clearing, output encoding and scheduling. */
export interface SceneRenderer {
  readonly three: ThreeRenderer;
  /** Draws over the content of the view's framebuffer and leaves it bound. `encoding` is that of the layer; the default is display. */
  draw(view: DrawView, scene: Scene, camera: Camera, encoding?: LayerEncoding): void;
  /** Clears a render target of three.js, or one face of a cube, to depth 1 and color 0, and draws to it; leaves no framebuffer bound. */
  drawDepth(target: WebGLRenderTarget, scene: Scene, camera: Camera, face?: number): void;
  /**
   * Clears a render target of three.js without depth, or one face of a cube, to white and the largest distance, and draws to it; leaves no
   * framebuffer bound.
   */
  drawTranslucentShadow(target: WebGLRenderTarget, scene: Scene, camera: Camera, face?: number): void;
  /** Draws to a render target of three.js without clearing it, so the draw must cover all of it; leaves no framebuffer bound. */
  drawOver(target: WebGLRenderTarget, scene: Scene, camera: Camera): void;
  /** Clears a corner of a render target of three.js, including depth and stencil, and draws to it; leaves no framebuffer bound. */
  drawCorner(target: WebGLRenderTarget, widthPx: number, heightPx: number, scene: Scene, camera: Camera): void;
  /** Runs other GPU work of three.js between draws; leaves no framebuffer bound. */
  work(task: (three: ThreeRenderer) => void): void;
  /** Whether draws only compile their shaders. */
  isPreparing(): boolean;
  /** Runs draws that only compile their shaders. Resolves when the driver has finished, without blocking. */
  prepare(draws: () => void): Promise<void>;
  /** Makes the next draw reset the state cache of three.js. Called after other code has drawn. */
  invalidateState(): void;
  dispose(): void;
}

/** Part of three.js' WebXR code: in `WebGLRenderer.js`, but not in its published types. */
interface ExternalFramebuffers {
  setRenderTargetFramebuffer(target: WebGLRenderTarget, framebuffer: WebGLFramebuffer | null): void;
}

/**
 * The target through which three.js draws to framebuffers of the player (ADR 7), using two features of its WebXR code:
 * `setRenderTargetFramebuffer` makes `setRenderTarget` bind an external framebuffer with the target's viewport; `isXRRenderTarget` makes
 * materials encode to the texture's color space, as for the canvas. `tests/browser/scenes-three.test.ts` tests both.
 */
function createFramebufferTarget(encoding: LayerEncoding): WebGLRenderTarget {
  const colorSpace = encoding === 'scene' ? LinearSRGBColorSpace : SRGBColorSpace;
  const target = new WebGLRenderTarget(1, 1, { colorSpace, depthBuffer: true });
  return Object.assign(target, { isXRRenderTarget: true });
}

/**
 * Clear color of a translucent shadow map: all light passes, and the distance in alpha is the largest half float. It is cleared without
 * three.js, which would multiply the color by alpha.
 */
const NOTHING_TRANSLUCENT = [1, 1, 1, 65504] as const;

export function createSceneRenderer(host: SceneHost): SceneRenderer {
  const { gl } = host;
  const leftovers = catchLeftovers(gl, () => new WebGLRenderer({ canvas: host.canvas, context: gl }));
  const three = leftovers.made;
  three.xr.enabled = false;
  three.autoClear = false;
  three.outputColorSpace = SRGBColorSpace;
  three.toneMapping = NoToneMapping;
  // Receivers sample shadow maps by three.js' PCF; `shadow-maps.ts` renders them, not three.js.
  three.shadowMap.enabled = true;
  three.shadowMap.type = PCFShadowMap;
  three.shadowMap.autoUpdate = false;
  three.shadowMap.needsUpdate = false;

  const targets = { display: createFramebufferTarget('display'), scene: createFramebufferTarget('scene') };
  const external = three as unknown as ExternalFramebuffers;
  let stale = true;
  /** The compilations that draws have started while `prepare` runs them; null otherwise. */
  let compiling: Promise<unknown>[] | null = null;

  function restoreState(): void {
    if (!stale) return;
    stale = false;
    three.resetState();
    // `resetState` resets the vertex array only if it was one of three.js.
    gl.bindVertexArray(null);
    gl.disable(gl.RASTERIZER_DISCARD);
    gl.disable(gl.SAMPLE_COVERAGE);
  }

  return {
    three,
    draw: (view, scene, camera, encoding = 'display') => {
      restoreState();
      const target = targets[encoding];
      const { x, y, widthPx, heightPx } = view.viewport;
      external.setRenderTargetFramebuffer(target, view.framebuffer);
      target.viewport.set(x, y, widthPx, heightPx);
      // Wide points and lines may leave the viewport and must not reach the neighboring view.
      target.scissor.set(x, y, widthPx, heightPx);
      target.scissorTest = true;
      three.setRenderTarget(target);
      if (compiling) compiling.push(three.compileAsync(scene, camera));
      else three.render(scene, camera);
      three.state.setScissorTest(false);
    },
    drawDepth: (depthTarget, scene, camera, face = 0) => {
      restoreState();
      three.setRenderTarget(depthTarget, face);
      if (compiling) {
        compiling.push(three.compileAsync(scene, camera));
      } else {
        three.setClearColor(0x000000, 0);
        three.clear(true, true, false);
        three.render(scene, camera);
      }
      three.setRenderTarget(null);
    },
    drawTranslucentShadow: (target, scene, camera, face = 0) => {
      restoreState();
      three.setRenderTarget(target, face);
      if (compiling) {
        compiling.push(three.compileAsync(scene, camera));
      } else {
        gl.clearBufferfv(gl.COLOR, 0, NOTHING_TRANSLUCENT);
        three.render(scene, camera);
      }
      three.setRenderTarget(null);
    },
    drawOver: (overTarget, scene, camera) => {
      restoreState();
      three.setRenderTarget(overTarget);
      if (compiling) compiling.push(three.compileAsync(scene, camera));
      else three.render(scene, camera);
      three.setRenderTarget(null);
    },
    drawCorner: (cornerTarget, widthPx, heightPx, scene, camera) => {
      restoreState();
      cornerTarget.viewport.set(0, 0, widthPx, heightPx);
      cornerTarget.scissor.set(0, 0, widthPx, heightPx);
      cornerTarget.scissorTest = true;
      three.setRenderTarget(cornerTarget);
      if (compiling) {
        compiling.push(three.compileAsync(scene, camera));
      } else {
        three.setClearColor(0x000000, 0);
        three.clear(true, true, true);
        three.render(scene, camera);
      }
      three.setRenderTarget(null);
      three.state.setScissorTest(false);
    },
    work: (task) => {
      // Passes that were drawn before the first draw are not reported.
      stale = true;
      restoreState();
      task(three);
      three.setRenderTarget(null);
    },
    isPreparing: () => compiling !== null,
    prepare: async (draws) => {
      const all: Promise<unknown>[] = [];
      compiling = all;
      try {
        draws();
      } finally {
        compiling = null;
      }
      await Promise.all(all);
    },
    invalidateState: () => {
      stale = true;
    },
    dispose: () => {
      targets.display.dispose();
      targets.scene.dispose();
      three.dispose();
      leftovers.free();
    },
  };
}
