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
import { shareState } from './gl-state.ts';
import { catchLeftovers } from './leftovers.ts';

/** Draws with the renderer of three.js, but without its own clearing, output encoding and scheduling. */
export interface SceneRenderer {
  readonly three: ThreeRenderer;
  /** Draws over the content of the view's framebuffer and leaves it bound. `encoding` is that of the layer; the default is display. */
  draw(view: DrawView, scene: Scene, camera: Camera, encoding?: LayerEncoding): void;
  /** Clears a render target of three.js, or one face of a cube, to depth 1 and color 0, and draws to it; leaves it bound. */
  drawDepth(target: WebGLRenderTarget, scene: Scene, camera: Camera, face?: number): void;
  /**
   * Clears a render target of three.js without depth, or one face of a cube, to white and the largest distance, and draws to it; leaves it
   * bound.
   */
  drawTranslucentShadow(target: WebGLRenderTarget, scene: Scene, camera: Camera, face?: number): void;
  /** Draws to a render target of three.js without clearing it, so the draw must cover all of it; leaves it bound. */
  drawOver(target: WebGLRenderTarget, scene: Scene, camera: Camera): void;
  /** Clears a corner of a render target of three.js, including depth and stencil, and draws to it; leaves it bound. */
  drawCorner(target: WebGLRenderTarget, widthPx: number, heightPx: number, scene: Scene, camera: Camera): void;
  /** Runs other GPU work of three.js between draws, which sets its own targets. The task calls WebGL only through three.js. */
  work(task: (three: ThreeRenderer) => void): void;
  /** Whether draws only compile their shaders. */
  isPreparing(): boolean;
  /** Runs draws that only compile their shaders. Resolves when the driver has finished, without blocking. */
  prepare(draws: () => void): Promise<void>;
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

/** How a target is cleared before a draw: `depth` sets the color too, `all` also the stencil. */
type Clear = 'nothing' | 'depth' | 'all' | 'translucent';

export function createSceneRenderer(host: SceneHost): SceneRenderer {
  const { gl } = host;
  const state = shareState(gl);
  state.enter();
  const leftovers = catchLeftovers(gl, () => new WebGLRenderer({ canvas: host.canvas, context: gl }));
  const three = leftovers.made;
  three.resetState();
  // three.js does not know this state.
  gl.bindVertexArray(null);
  gl.disable(gl.RASTERIZER_DISCARD);
  gl.disable(gl.SAMPLE_COVERAGE);
  state.leave();
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
  /** The compilations that draws have started while `prepare` runs them; null otherwise. */
  let compiling: Promise<unknown>[] | null = null;

  const select = three.state.useProgram as (program: WebGLProgram | null) => void;

  /** Makes what three.js remembers of the state true again. */
  function enter(): void {
    if (state.enter()) select(null);
  }

  /** Clears the target of three.js in the given way and draws to it. */
  function drawTo(target: WebGLRenderTarget, face: number, clear: Clear, scene: Scene, camera: Camera): void {
    enter();
    try {
      three.setRenderTarget(target, face);
      if (compiling) compiling.push(three.compileAsync(scene, camera));
      else {
        if (clear === 'translucent') gl.clearBufferfv(gl.COLOR, 0, NOTHING_TRANSLUCENT);
        else if (clear !== 'nothing') {
          three.setClearColor(0x000000, 0);
          three.clear(true, true, clear === 'all');
        }
        three.render(scene, camera);
      }
      // The scissor test would limit what others clear and copy.
      three.state.setScissorTest(false);
    } finally {
      state.leave();
    }
  }

  return {
    three,
    draw: (view, scene, camera, encoding = 'display') => {
      const target = targets[encoding];
      const { x, y, widthPx, heightPx } = view.viewport;
      external.setRenderTargetFramebuffer(target, view.framebuffer);
      target.viewport.set(x, y, widthPx, heightPx);
      // Wide points and lines may leave the viewport and must not reach the neighboring view.
      target.scissor.set(x, y, widthPx, heightPx);
      target.scissorTest = true;
      drawTo(target, 0, 'nothing', scene, camera);
    },
    drawDepth: (target, scene, camera, face = 0) => drawTo(target, face, 'depth', scene, camera),
    drawTranslucentShadow: (target, scene, camera, face = 0) => drawTo(target, face, 'translucent', scene, camera),
    drawOver: (target, scene, camera) => drawTo(target, 0, 'nothing', scene, camera),
    drawCorner: (target, widthPx, heightPx, scene, camera) => {
      target.viewport.set(0, 0, widthPx, heightPx);
      target.scissor.set(0, 0, widthPx, heightPx);
      target.scissorTest = true;
      drawTo(target, 0, 'all', scene, camera);
    },
    work: (task) => {
      enter();
      try {
        // The task may set the target again that it finds, and the last one may be disposed of.
        three.setRenderTarget(null);
        task(three);
      } finally {
        state.leave();
      }
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
    dispose: () => {
      targets.display.dispose();
      targets.scene.dispose();
      three.dispose();
      leftovers.free();
      state.release();
    },
  };
}
