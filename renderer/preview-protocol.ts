import type { Photograph } from '../export/captures/acquire/take-photograph.ts';
import type { AcquiredCamera } from '../export/captures/acquire/write-transforms.ts';
import type { Rephotograph, RephotographMethod } from '../export/captures/evaluate/rephotograph.ts';
import type { LinkedShader, Program } from '../export/program/program.ts';
import type { ParamValue } from '../nodes/kit/definition.ts';
import type { Diagnostic } from '../nodes/kit/diagnostics.ts';
import type { FrameTimes } from '../nodes/kit/frame-times.ts';
import type { Handle } from '../nodes/kit/handles.ts';
import type { PosterFraming, ViewTangents } from '../nodes/kit/poster-framing.ts';
import type { MemoryCost, OperationCost } from './preview-costs.ts';

/*
 * Messages between the editor and its preview page, sent over one MessagePort. The editor transfers the port to the preview’s origin
 * after the page loads. The preview has no host API; it plays what it receives.
 */

/** Data of the window message that transfers the port. The parent sends it once per load; all other messages use the port. */
export const CONNECT_MESSAGE = 'scrim-preview-connect';

export type ToPreview =
  /** Plays this program. The previous program plays until the new one has linked. */
  | { readonly kind: 'program'; readonly revision: number; readonly program: Program }
  /** Compiles only these shaders and reports the errors of the driver. Only the newest request is answered. Playback continues. */
  | { readonly kind: 'trials'; readonly revision: number; readonly shaders: readonly LinkedShader[] }
  /** Sets a uniform param without recompiling. */
  | { readonly kind: 'param'; readonly node: string; readonly param: string; readonly value: ParamValue }
  | { readonly kind: 'transport'; readonly action: 'play' | 'pause' | 'step' | 'reset' }
  /** Sets the play range of a recording. Null: the whole recording in a loop, while time continues. */
  | { readonly kind: 'range'; readonly range: PreviewRange | null }
  /** Goes to a time in seconds since the session began. Recordings only; stateful nodes restart. */
  | { readonly kind: 'seek'; readonly timeS: number }
  /** Sets the preview source. `request` is a counter; the status repeats it once the source is open or has failed. */
  | { readonly kind: 'session'; readonly source: PreviewSource; readonly request: number }
  /**
   * Overrides the direction of the brightest light of an emulated room: a unit vector toward the light in world space. Null restores
   * the light of the room.
   */
  | { readonly kind: 'room-light'; readonly directionWorld: readonly [number, number, number] | null }
  /**
   * Requests a JPEG of a frame in this size. `request` is a counter that the answer repeats. `nodes`: the selected nodes of the program,
   * whose objects are framed if `framing` is null.
   */
  | {
      readonly kind: 'poster';
      readonly request: number;
      readonly widthPx: number;
      readonly heightPx: number;
      readonly framing: PosterFraming | null;
      readonly nodes: readonly string[];
    }
  /**
   * Shows viewed layers instead of the screen output: `left` to the left of `split` (a fraction of the width of each view), `right`
   * to the right of it. Null, or a layer that is not viewed in the program, shows the screen output. `probed`: the layer whose depth
   * probes read.
   */
  | {
      readonly kind: 'viewer';
      readonly left: string | null;
      readonly right: string | null;
      readonly split: number;
      readonly probed: string | null;
    }
  /** Takes the panorama of `source/panorama-capture` in an emulated room, this many pixels wide. */
  | { readonly kind: 'take-panorama'; readonly widthPx: number }
  /** Sets the size in which the preview renders. Until then it is that of the panel. */
  | { readonly kind: 'render-size'; readonly size: RenderSize }
  /** Whether a pointer drags something in the editor. The preview then holds its frame rate at the cost of resolution. */
  | { readonly kind: 'dragging'; readonly on: boolean }
  /** Requests a PNG of the next frame with all views. */
  | { readonly kind: 'screenshot' }
  /**
   * Starts a frame render of a recording or an emulated room, frame by frame. The page answers `frame-rendered` when it is ready, and
   * does nothing else from then on.
   */
  | { readonly kind: 'render-begin'; readonly request: FrameRenderRequest }
  /**
   * Renders the frame at a time in seconds since the recording began; a room advances by one frame. If `keep` is false, the frame is
   * drawn only for the state of stateful nodes and not returned.
   */
  | { readonly kind: 'render-frame'; readonly timeS: number; readonly keep: boolean }
  | { readonly kind: 'render-end' }
  /**
   * Loads a program, to take photographs of a layer at time 0. The page answers `photographed` when it is ready, and does nothing else from
   * then on.
   */
  | { readonly kind: 'photographs-begin'; readonly request: PhotographsRequest }
  /** Takes a photograph. `worldFromCamera`: column-major 4×4. */
  | { readonly kind: 'photograph'; readonly camera: AcquiredCamera; readonly worldFromCamera: readonly number[] }
  /** Loads a capture, to draw its photographs from all others. The page answers `rephotographed`, and does nothing else from then on. */
  | { readonly kind: 'rephotograph-begin'; readonly request: RephotographRequest }
  /** Draws a photograph from all others by one method. */
  | { readonly kind: 'rephotograph'; readonly index: number; readonly method: RephotographMethod }
  /** Draws a model alone, framed, on a transparent background. `path`: its asset. `request` is a counter that the answer repeats. */
  | {
      readonly kind: 'draw-model';
      readonly request: number;
      readonly assetBaseUrl: string;
      readonly path: string;
      readonly widthPx: number;
      readonly heightPx: number;
    }
  /** Starts or stops the recording of a video. `captured` follows when it stops. */
  | { readonly kind: 'record'; readonly on: boolean }
  /** Starts or stops the recording of a session. `session-recorded` follows, also where it ends by itself or cannot begin. */
  | { readonly kind: 'record-session'; readonly on: boolean; readonly title: string }
  /**
   * Probes a point, given as fractions of the preview’s size from the top left. `layer`: the viewed layer to read depth from;
   * with `ofLayer`, of it alone, without the room, once a program that keeps the layer plays. `aroundPx`: pixels on each side to return as well.
   */
  | {
      readonly kind: 'probe';
      readonly x: number;
      readonly y: number;
      readonly layer: string | null;
      readonly ofLayer?: boolean;
      readonly aroundPx?: number;
    }
  /** The gizmo to show; null for none. Removing it during a drag ends the drag without a message. */
  | { readonly kind: 'gizmo'; readonly gizmo: PreviewGizmo | null }
  /** Whether clicks report the object that they hit. */
  | { readonly kind: 'picking'; readonly on: boolean }
  /** Physics apart from the time of the source. Reset: all bodies begin anew. */
  | { readonly kind: 'physics'; readonly action: 'play' | 'pause' | 'step' | 'reset' }
  /** Bodies of these nodes of the program, or of all if the list is empty, begin anew at rest. */
  | { readonly kind: 'physics-drop'; readonly nodes: readonly string[] }
  /** What is shown over the preview: shapes of bodies, voxels of the room. */
  | { readonly kind: 'physics-view'; readonly bodies: boolean; readonly voxels: boolean }
  /** Keys that the editor handles, as `keybindingOf` writes them. The preview forwards them unless it uses them itself. */
  | { readonly kind: 'keys'; readonly keybindings: readonly string[]; readonly mac: boolean }
  /** Whether to measure the cost of operations. */
  | { readonly kind: 'cost'; readonly on: boolean }
  /** Requests copies of viewed layers of the program (`node.port`), `heightPx` tall. */
  | { readonly kind: 'thumbnails'; readonly ports: readonly string[]; readonly heightPx: number };

/** Messages to hidden pages, each of which does one such work. */
export type HiddenWork = Extract<
  ToPreview,
  {
    kind:
      | 'render-begin'
      | 'render-frame'
      | 'render-end'
      | 'photographs-begin'
      | 'photograph'
      | 'rephotograph-begin'
      | 'rephotograph'
      | 'draw-model';
  }
>;

/**
 * Size in which the preview renders: the pixels of the shorter side, that of the panel, or `auto`: 1080 pixels, and that of the panel where
 * the CPU draws. The longer side follows from the shape of the preview.
 */
export type RenderSize = 'auto' | 'panel' | 720 | 1080 | 1440;

/** Source of the frames of a frame render. */
export type FrameRenderSource =
  | { readonly kind: 'recorded'; readonly url: string }
  /**
   * An emulated room seen by a phone. `captureUrl`, `tier` and `refuse` are those of the preview source. `worldFromHead`: column-major pose of
   * the head; null for the start pose.
   */
  | {
      readonly kind: 'room';
      readonly captureUrl: string | null;
      readonly tier: PreviewTier;
      readonly refuse: readonly string[];
      readonly frameRateHz: number;
      readonly lightDirectionWorld: readonly [number, number, number] | null;
      readonly worldFromHead: readonly number[] | null;
    };

export interface PhotographsRequest extends Pick<FrameRenderRequest, 'program' | 'values' | 'assetBaseUrl'> {
  /** A layer with depth that the program keeps for viewing. */
  readonly layer: string;
}

export interface RephotographRequest {
  readonly assetBaseUrl: string;
  /** The folder of the capture in the project, ending in `/`. */
  readonly folder: string;
  readonly methods: readonly RephotographMethod[];
  /** Number of photographs per pixel of the lumigraph. */
  readonly blended: number;
}

/** How much of the room a program gets: with the camera's image, without it, or nothing of the room. */
export type PreviewTier = 'ar-camera' | 'ar' | 'vr';

export interface FrameRenderRequest {
  readonly program: Program;
  /** Params that changed after the program was compiled. */
  readonly values: readonly {
    readonly node: string;
    readonly param: string;
    readonly value: ParamValue;
  }[];
  readonly source: FrameRenderSource;
  readonly assetBaseUrl: string;
  readonly widthPx: number;
  readonly heightPx: number;
  /** Options of the video; null if each frame is returned as pixels. */
  readonly video: { readonly frameRateHz: number } | null;
}

/**
 * A play range in seconds since the session began. The last frame begins at `lastS` and ends at `endS`. Without `loop`, the preview
 * pauses there.
 */
export interface PreviewRange {
  readonly fromS: number;
  readonly lastS: number;
  readonly endS: number;
  readonly loop: boolean;
}

/** A gizmo for the objects that a node places. It follows them in each frame. */
export interface PreviewGizmo {
  /** Node id in the program. */
  readonly node: string;
  /** A drag adds a Transform after the node, so the gizmo starts with no transform; absent if the params are those of the node. */
  readonly adds?: true;
  readonly mode: GizmoMode;
  /** Axes of the object or of the session. */
  readonly space: 'local' | 'world';
  /** Whether a drag snaps: to 0.1 m, 15° and steps of 0.1 in scale. Holding Ctrl inverts this. */
  readonly snap: boolean;
  /** Params of the node, by the handle that they set. */
  readonly handles: Readonly<Partial<Record<Handle, string>>>;
  /** The axes that the gizmo shows, as in `xz`. */
  readonly axes: string;
  /** Nodes of the program that a clicked object passed through. They select one branch if the objects of the node pass through several. */
  readonly chain: readonly string[];
}

export type GizmoMode = 'move' | 'rotate' | 'scale';

/** URLs are on the origin of the preview. */
export type PreviewSource =
  | { readonly kind: 'recorded'; readonly url: string; readonly assetBaseUrl: string }
  /** An emulated device. `captureUrl` is the URL of a captured room; null for the emulator’s built-in room. */
  | {
      readonly kind: 'room';
      readonly captureUrl: string | null;
      readonly views: 1 | 2;
      readonly assetBaseUrl: string;
      /** `glasses` have an additive display: black is transparent. */
      readonly device: 'phone' | 'headset' | 'glasses';
      /**
       * `ar-camera` gives camera frames to the page; `ar` shows the camera feed without giving it to the page; `vr` shows nothing of
       * the room.
       */
      readonly tier: PreviewTier;
      /** WebXR features that the device does not have. */
      readonly refuse: readonly string[];
    }
  /** The camera of this computer. The browser asks for permission. */
  | { readonly kind: 'camera'; readonly assetBaseUrl: string }
  /** A still image in place of the camera. `key` is unique per image. */
  | { readonly kind: 'still'; readonly picture: Blob; readonly key: string; readonly assetBaseUrl: string }
  /** An orbit session: only the objects, viewed by orbiting. */
  | { readonly kind: 'orbit'; readonly assetBaseUrl: string };

export type FromPreview =
  | { readonly kind: 'ready' }
  /** The program of this revision is now on screen. */
  | { readonly kind: 'playing'; readonly revision: number }
  /**
   * The answer to `render-begin` and `render-frame`. `frame`: premultiplied RGBA, rows from the top; null if the request asked for no
   * pixels.
   */
  | { readonly kind: 'frame-rendered'; readonly frame: Uint8Array<ArrayBuffer> | null }
  | { readonly kind: 'render-finished'; readonly file: Blob | null }
  | { readonly kind: 'render-failed'; readonly diagnostic: Diagnostic }
  /** The answer to `photographs-begin`, with null, and to `photograph`. Failures are answered by `render-failed`. */
  | { readonly kind: 'photographed'; readonly photograph: Photograph | null }
  /** The answer to `rephotograph-begin`, with null, and to `rephotograph`. Failures are answered by `render-failed`. */
  | { readonly kind: 'rephotographed'; readonly shot: DrawnRephotograph | null }
  /**
   * The answer to `draw-model`. `image`: null if the model cannot be loaded. `gpuBytes`: its textures with mipmaps and its geometry; null if it
   * cannot be read.
   */
  | { readonly kind: 'model-drawn'; readonly request: number; readonly image: ImageBitmap | null; readonly gpuBytes: number | null }
  /**
   * A session began. Frame times are null if it is not a recording and cannot seek. `shape`: width of the images of a recording or
   * camera divided by their height; null for other sessions.
   */
  | { readonly kind: 'frames'; readonly frames: FrameTimes | null; readonly shape: number | null }
  /** All problems of the running program, or of the program of `revision` if it could not be played. */
  | { readonly kind: 'diagnostics'; readonly revision: number; readonly diagnostics: readonly Diagnostic[] }
  /**
   * Errors of the graphics driver for the program of `revision`; empty if all shaders compiled. The editor maps them to source lines.
   */
  | { readonly kind: 'shader-errors'; readonly revision: number; readonly errors: readonly PreviewShaderError[] }
  /** Errors of the graphics driver in the `trials` of `revision`; empty if all shaders compiled. */
  | { readonly kind: 'trial-errors'; readonly revision: number; readonly errors: readonly PreviewShaderError[] }
  /** Sent at most ten times a second. */
  | { readonly kind: 'status'; readonly status: PreviewStatus }
  | { readonly kind: 'thumbnail'; readonly port: string; readonly image: ImageBitmap }
  | { readonly kind: 'probed'; readonly probe: PreviewProbe }
  /**
   * New values of the node’s params during a drag of the gizmo. `drag` counts the drags of the page from 1, so that the editor can
   * ignore late messages of a canceled drag. `ended`: last message of the drag. `cancelled`: the editor restores the values before
   * the drag.
   */
  | {
      readonly kind: 'gizmo';
      readonly drag: number;
      readonly state: 'moved' | 'ended' | 'cancelled';
      readonly values: Readonly<Record<string, number | readonly number[]>>;
    }
  /** A click hit an object. `chain`: the nodes of the program that the object passed through, from its creator to the node that drew it. */
  | { readonly kind: 'picked'; readonly chain: readonly string[]; readonly phantom: boolean }
  /** A key of the `keys` message was pressed while the preview had the focus. */
  | { readonly kind: 'key'; readonly keybinding: string }
  /** Files are dragged over the page. Sent repeatedly. */
  | { readonly kind: 'file-drag' }
  /** Files were dropped at a point of the page: fractions of it from its top left. */
  | { readonly kind: 'dropped'; readonly files: readonly File[]; readonly hasFolder: boolean; readonly x: number; readonly y: number }
  /** A screenshot or a video. Null if nothing is shown or the browser cannot record. */
  | { readonly kind: 'captured'; readonly what: 'screenshot' | 'video'; readonly file: Blob | null }
  /** The recording of a session has ended, and its images are being made. */
  | { readonly kind: 'session-filming' }
  /** The answer to `record-session`. `text`: a sentence for the user, why nothing was recorded. */
  | { readonly kind: 'session-recorded'; readonly recorded: RecordedFiles | null; readonly text: string }
  /** The answer to `take-panorama`. `text` is a sentence for the user. */
  | { readonly kind: 'panorama'; readonly state: 'taken' | 'failed'; readonly text: string }
  /** Sent twice a second while measuring is on. */
  | { readonly kind: 'costs'; readonly costs: readonly OperationCost[]; readonly memory: readonly MemoryCost[] }
  /** The answer to `poster`. `bytes`: the JPEG; null if nothing is shown. */
  | { readonly kind: 'poster'; readonly request: number; readonly bytes: Uint8Array<ArrayBuffer> | null };

export interface DrawnRephotograph extends Rephotograph {
  readonly widthPx: number;
  readonly heightPx: number;
}

/** A recorded session. */
export interface RecordedFiles {
  /** Text of `session.json`. */
  readonly session: string;
  /** Its images, in the order of `content`. */
  readonly files: readonly { readonly path: string; readonly bytes: number }[];
  /** The bytes of all images, one after another. */
  readonly content: Uint8Array<ArrayBuffer>;
}

export interface PreviewProbe {
  /** The point of the request. */
  readonly x: number;
  readonly y: number;
  /** Display-referred sRGB with alpha as shown, each component in [0, 255]. */
  readonly color: readonly [number, number, number, number];
  /**
   * Colors of the square around the point, row by row from the top left; transparent outside the preview. Absent unless requested.
   */
  readonly around?: Uint8ClampedArray<ArrayBuffer>;
  /** The nearest depth at the point; null if nothing there has depth. */
  readonly depth: {
    readonly of: 'layer' | 'room';
    readonly meters: number;
    readonly positionWorld: readonly [number, number, number];
  } | null;
}

export interface PreviewShaderError {
  /** Key in `shaders` of the program. */
  readonly shaderId: string;
  readonly stage: 'vertex' | 'fragment' | 'link';
  readonly log: string;
}

export interface PreviewStatus {
  readonly state: 'loading' | 'playing' | 'paused' | 'lost';
  /** Counter of the newest `session` message whose session is open or has failed with a diagnostic. Null before the first. */
  readonly request: number | null;
  /** For a recording the index of its frame, which continues to count when it loops; else the number of frames drawn. */
  readonly frame: number;
  /** The preview shows an earlier frame while `frame` is being decoded. */
  readonly late: boolean;
  readonly timeS: number;
  /** Mean CPU time of the last frames. */
  readonly frameMs: number;
  /** Frames drawn per second while time passes; 0 before it was measured, and while paused. */
  readonly framesPerS: number;
  readonly widthPx: number;
  readonly heightPx: number;
  /** Pose of the first view, column-major; null before the first frame. */
  readonly worldFromView: readonly number[] | null;
  /** Edges of the first view; null before the first frame. */
  readonly tangents: ViewTangents | null;
}
