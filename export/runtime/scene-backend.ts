import type { EnvironmentAsset, ModelAsset } from '../../nodes/kit/assets.ts';
import type { Diagnostic } from '../../nodes/kit/diagnostics.ts';
import type { SceneService } from '../../nodes/kit/runtime.ts';
import type { LightList, ObjectList, RoomDepthOutput } from '../../nodes/kit/scene-lists.ts';
import type { NumberView } from '../../nodes/kit/value-views.ts';

/**
 * What the player asks of three.js. Types only: the player never imports three, so that a page without objects carries none of
 * it; `scenes/create-scenes.ts` implements this and is handed in by pages whose program draws objects.
 *
 * GL state: passes set all state they depend on and assume nothing; the backend resets three's idea of the state before its
 * first draw after any pass. Framebuffers are the player's: three draws into them as XR targets (ADR 7).
 */
export type CreateSceneBackend = (host: SceneHost) => SceneBackend;

export interface SceneHost {
  readonly gl: WebGL2RenderingContext;
  readonly canvas: HTMLCanvasElement | OffscreenCanvas;
}

export interface SceneBackend {
  /** The service that one drawing operation sees as `ctx.scenes`. */
  serviceFor(binding: DrawBinding): SceneService;
  createShadowMaps(casters: readonly ObjectList[], lights: readonly LightList[]): ShadowMaps;
  /**
   * Rejects with an `Error` that says what is wrong with the file.
   *
   * @param readFile bytes of another file, by its path in the project, for models in several
   */
  loadModel(bytes: ArrayBuffer, path: string, readFile: (path: string) => Promise<ArrayBuffer>): Promise<LoadedModel>;
  /** A panorama, filtered for lighting. Rejects with an `Error` that says what is wrong with the file. */
  loadEnvironment(bytes: ArrayBuffer): Promise<LoadedEnvironment>;
  /**
   * Runs draws that compile all they need, and draw nothing. Resolves when the driver has done so; nobody waits for it.
   */
  prepare(draws: () => void): Promise<void>;
  /** Called when passes have drawn since three last did. */
  invalidateState(): void;
  /** GPU objects alive, for leak tests. */
  counts(): { readonly geometries: number; readonly textures: number; readonly programs: number };
  dispose(): void;
}

/** A model as the asset service holds it: freed when the last handle is released. */
export interface LoadedModel extends ModelAsset {
  /** What to know of it although it loaded well; told at the nodes that use it. */
  readonly findings: readonly ModelFinding[];
  dispose(): void;
}

export type ModelFinding = Pick<Diagnostic, 'code' | 'severity' | 'message' | 'fix'>;

export interface LoadedEnvironment extends EnvironmentAsset {
  dispose(): void;
}

/** Bound before the first draw and read in every draw. */
export interface DrawBinding {
  readonly shadowMaps: ShadowMaps | null;
  readonly occlusion: OcclusionBinding | null;
  /** Where limits are told that what is wired goes beyond. */
  readonly report?: (diagnostic: Omit<Diagnostic, 'nodeId'>) => void;
}

export interface ShadowMaps {
  /** Renders all maps of this frame. */
  update(): void;
  dispose(): void;
}

/** Params of `layer/depth-occlusion`, live. */
export interface OcclusionBinding {
  readonly roomDepth: RoomDepthOutput;
  readonly params: Readonly<Record<string, NumberView>>;
}
