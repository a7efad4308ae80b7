import {
  type Camera,
  NoToneMapping,
  PCFShadowMap,
  type Scene,
  SRGBColorSpace,
  type WebGLRenderer as ThreeRenderer,
  WebGLRenderer,
  WebGLRenderTarget,
} from 'three';
import type { DrawView } from '../../../nodes/kit/runtime.ts';
import type { SceneHost } from '../scene-backend.ts';
import { catchLeftovers } from './leftovers.ts';

/** three.js, tamed: it draws where it is told and clears, encodes and schedules nothing of its own. */
export interface SceneRenderer {
  readonly three: ThreeRenderer;
  /** Draws over what the view's framebuffer holds, and leaves that framebuffer bound. */
  draw(view: DrawView, scene: Scene, camera: Camera): void;
  /** Clears a target of three's own, or one face of a cube, to depth 1 and color 0, and draws into it; leaves no framebuffer bound. */
  drawDepth(target: WebGLRenderTarget, scene: Scene, camera: Camera, face?: number): void;
  /** Clears a target of three's own without depth, or one face of a cube, to white and as far away as can be, and draws into it; leaves no framebuffer bound. */
  drawTranslucentShadow(target: WebGLRenderTarget, scene: Scene, camera: Camera, face?: number): void;
  /** Draws over what a target of three's own holds, which has to be covered; leaves no framebuffer bound. */
  drawOver(target: WebGLRenderTarget, scene: Scene, camera: Camera): void;
  /** Clears the corner of a target of three's own, depth and stencil too, and draws into it; leaves no framebuffer bound. */
  drawCorner(target: WebGLRenderTarget, widthPx: number, heightPx: number, scene: Scene, camera: Camera): void;
  /** Lets three do other work on the GPU, at any time between draws; leaves no framebuffer bound. */
  work(task: (three: ThreeRenderer) => void): void;
  /** Runs draws that compile what they need and draw nothing; resolves when the driver has done so, without waiting for it. */
  prepare(draws: () => void): Promise<void>;
  /** Others have drawn since three last did. */
  invalidateState(): void;
  dispose(): void;
}

/** Part of three's WebXR path: in `WebGLRenderer.js`, but not in its published types. */
interface ExternalFramebuffers {
  setRenderTargetFramebuffer(target: WebGLRenderTarget, framebuffer: WebGLFramebuffer | null): void;
}

/**
 * The target through which three draws into framebuffers that the player owns (ADR 7). Two properties of three's WebXR path
 * carry it: `setRenderTargetFramebuffer` makes `setRenderTarget` bind a framebuffer from outside and take the viewport from the
 * target; `isXRRenderTarget` makes materials encode into the texture's color space, as they do for the canvas.
 * `tests/browser/scenes-three.test.ts` pins both.
 */
function createFramebufferTarget(): WebGLRenderTarget {
  const target = new WebGLRenderTarget(1, 1, { colorSpace: SRGBColorSpace, depthBuffer: true });
  return Object.assign(target, { isXRRenderTarget: true });
}

/** Alpha: the largest half float; three would multiply the color by it. */
const NOTHING_TRANSLUCENT = [1, 1, 1, 65504] as const;

export function createSceneRenderer(host: SceneHost): SceneRenderer {
  const { gl } = host;
  const leftovers = catchLeftovers(gl, () => new WebGLRenderer({ canvas: host.canvas, context: gl }));
  const three = leftovers.made;
  three.xr.enabled = false;
  three.autoClear = false;
  three.outputColorSpace = SRGBColorSpace;
  three.toneMapping = NoToneMapping;
  // Receivers sample shadow maps with three's PCF; the maps are rendered by `shadow-maps.ts`, never by three.
  three.shadowMap.enabled = true;
  three.shadowMap.type = PCFShadowMap;
  three.shadowMap.autoUpdate = false;
  three.shadowMap.needsUpdate = false;

  const target = createFramebufferTarget();
  const external = three as unknown as ExternalFramebuffers;
  let stale = true;
  /** While draws are run to be prepared. */
  let compiling: Promise<unknown>[] | null = null;

  function restoreState(): void {
    if (!stale) return;
    stale = false;
    three.resetState();
    // What that leaves out: its vertex array is reset only if it was one of three's own.
    gl.bindVertexArray(null);
    gl.disable(gl.RASTERIZER_DISCARD);
    gl.disable(gl.SAMPLE_COVERAGE);
  }

  return {
    three,
    draw: (view, scene, camera) => {
      restoreState();
      const { x, y, widthPx, heightPx } = view.viewport;
      external.setRenderTargetFramebuffer(target, view.framebuffer);
      target.viewport.set(x, y, widthPx, heightPx);
      // Wide points and lines may leave the viewport; the neighboring view is not theirs.
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
      // Nobody announces passes that were drawn before it.
      stale = true;
      restoreState();
      task(three);
      three.setRenderTarget(null);
    },
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
      target.dispose();
      three.dispose();
      leftovers.free();
    },
  };
}
