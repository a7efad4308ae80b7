import type { DerivedEnvironment, EnvironmentAsset, ModelAsset } from '../../nodes/kit/assets.ts';
import type { Diagnostic } from '../../nodes/kit/diagnostics.ts';
import type { OcclusionView } from '../../nodes/kit/early-occlusion.ts';
import type { PanoramaPixels } from '../../nodes/kit/panorama/pixels.ts';
import type { SceneService, UnderLayer } from '../../nodes/kit/runtime.ts';
import type { LightList, ObjectList } from '../../nodes/kit/scene-lists.ts';
import type { ViewFrame } from '../../nodes/kit/session.ts';
import type { DrawOperation, Program } from '../program/program.ts';
import type { FrameClock } from './clock.ts';
import type { LiveResources } from './resources/resources.ts';
import type { CreateNearestDepth } from './targets/nearest-depth.ts';

/**
 * Interface of the player to three.js. It has types only, so that pages without objects do not bundle three.js; `scenes/create-scenes.ts`
 * implements it, and pages with objects pass it to the player.
 *
 * GL state: passes set all state that they depend on; the backend restores the state that three.js remembers before it draws
 * (`scenes/gl-state.ts`).
 * The player owns the framebuffers; three.js draws to them as XR targets (ADR 7).
 */
export type CreateSceneBackend = (host: SceneHost) => SceneBackend;

export interface SceneHost {
  readonly gl: WebGL2RenderingContext;
  readonly canvas: HTMLCanvasElement | OffscreenCanvas;
  /** Waits while large panoramas are uploaded and filtered over several frames. Absent or null: they are at once, as in renders. */
  readonly delay?: FrameClock['delay'] | null;
}

export interface SceneBackend {
  /** The service `ctx.scenes` of one drawing operation. */
  serviceFor(binding: DrawBinding): SceneService;
  createShadowMaps(casters: readonly ObjectList[], lights: readonly LightList[]): ShadowMaps;
  /**
   * Loads a model. Rejects with an `Error` whose message is text for the user.
   *
   * @param readFile Reads another file by its path in the project, for models of several files.
   */
  loadModel(bytes: ArrayBuffer, path: string, readFile: (path: string) => Promise<ArrayBuffer>): Promise<LoadedModel>;
  /**
   * Loads a panorama and filters it for lighting. Rejects with an `Error` whose message is text for the user.
   *
   * @param lamps Lamps that were found in it before.
   */
  loadEnvironment(bytes: ArrayBuffer, lamps?: EnvironmentAsset['lamps']): Promise<LoadedEnvironment>;
  /** Creates a panorama from pixels: implements `AssetService.createEnvironment`. */
  createEnvironment(pixels: PanoramaPixels, lamps?: EnvironmentAsset['lamps']): LoadedEnvironment;
  /**
   * Creates what computes the nearest depth of multisampled targets. The backend has it, because only scenes draw such depth, and other
   * pages do not bundle it.
   */
  readonly createNearestDepth: CreateNearestDepth;
  /** Creates a reader of what is under a layer, for glass; null if the page has no glass. */
  readonly createUnder: CreateUnder | null;
  /** Runs draws that only compile their shaders. Resolves when the driver has finished, without blocking. */
  prepare(draws: () => void): Promise<void>;
  /** Number of GPU objects, for leak tests. */
  counts(): { readonly geometries: number; readonly textures: number; readonly programs: number };
  dispose(): void;
}

/** Returns the content under the layer of a draw, which glass in the layer shows. Called before every draw. */
export type ReadUnder = (view: ViewFrame, viewIndex: number, widthPx: number, heightPx: number) => UnderLayer;

export type CreateUnder = (program: Program, operation: DrawOperation, resources: LiveResources) => ReadUnder;

/** A loaded model, disposed when its last handle is released. */
export interface LoadedModel extends ModelAsset {
  /** Warnings about the model, reported at the nodes that use it. */
  readonly findings: readonly ModelFinding[];
  dispose(): void;
}

export type ModelFinding = Pick<Diagnostic, 'code' | 'severity' | 'message' | 'fix'>;

export interface LoadedEnvironment extends DerivedEnvironment {
  /** Diagnostics about the file, reported at the nodes that use it; absent if there are none. */
  readonly findings?: readonly ModelFinding[];
}

/** What the scenes of one drawing operation need from the player. It is set before the first draw and read in every draw. */
export interface DrawBinding {
  readonly shadowMaps: ShadowMaps | null;
  readonly occlusion: OcclusionView | null;
  /** Effects that materials compute at their end; null for none. */
  readonly effects?: MaterialEffects | null;
  /** Reports warnings about exceeded limits. */
  readonly report?: (diagnostic: Omit<Diagnostic, 'nodeId'>) => void;
}

/** Effects that the materials of a draw compute at their end (ADR 55). */
export interface MaterialEffects {
  /** Text for fragment shaders; see `DrawEffects`. */
  readonly text: string;
  /** Uniforms of the text. Their values change in place. */
  readonly uniforms: Readonly<Record<string, { value: unknown }>>;
  /** Textures of its samplers, with their own parameters. */
  readonly textures: Readonly<Record<string, WebGLTexture>>;
}

export interface ShadowMaps {
  /** Draws the shadow maps of all lights for this frame. */
  update(): void;
  dispose(): void;
}
