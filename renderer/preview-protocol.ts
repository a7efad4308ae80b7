import type { LinkedShader, Program } from '../export/program/program.ts';
import type { Handle, ParamValue } from '../nodes/kit/definition.ts';
import type { Diagnostic } from '../nodes/kit/diagnostics.ts';
import type { FrameTimes } from '../nodes/kit/frame-times.ts';

/*
 * Messages between the editor and its preview page, over one MessagePort that the editor hands to the preview's origin once it
 * has loaded. The preview has no host API: all it can do is play what it is sent.
 */

/** What the preview page listens for on its window, from its parent and once per load; all else goes over the port sent with it. */
export const CONNECT_MESSAGE = 'scrim-preview-connect';

export type ToPreview =
  /** Play this program; the last good one runs on until the new one has linked. */
  | { readonly kind: 'program'; readonly revision: number; readonly program: Program }
  /** Compile these alone and say what the driver has against them: the newest is answered. What plays goes on. */
  | { readonly kind: 'trials'; readonly revision: number; readonly shaders: readonly LinkedShader[] }
  /** Set a uniform param without a compile. */
  | { readonly kind: 'param'; readonly node: string; readonly param: string; readonly value: ParamValue }
  | { readonly kind: 'transport'; readonly action: 'play' | 'pause' | 'step' | 'reset' }
  /** The part of a recording that is played; null: all of it, over and over, while time goes on. */
  | { readonly kind: 'range'; readonly range: PreviewRange | null }
  /** Goes to a moment, seconds since the session began. Only recordings can; what remembers begins anew. */
  | { readonly kind: 'seek'; readonly timeS: number }
  /** Take the picture from there. `request` counts: the status says which one is done with. */
  | { readonly kind: 'session'; readonly source: PreviewSource; readonly request: number }
  /** The strongest light of an emulated room comes from there, a unit vector towards it in world space; null: from where the room has it. */
  | { readonly kind: 'room-light'; readonly directionWorld: readonly [number, number, number] | null }
  /** A picture of what is shown, of that size, as JPEG: the answer comes with the next frame. `request` counts: the answer has it. */
  | { readonly kind: 'poster'; readonly request: number; readonly widthPx: number; readonly heightPx: number }
  /**
   * Show tapped layers instead of the screen: one left of `split`, in parts of each view's width, and one right of it. Null, and
   * layers that are not tapped: the screen.
   */
  | { readonly kind: 'viewer'; readonly left: string | null; readonly right: string | null; readonly split: number }
  /** The whole picture, all views, as PNG: the answer comes with the next frame. */
  | { readonly kind: 'screenshot' }
  /** Draw frames of a recording or an emulated room one by one from now on, as `filmed` says when it can begin; a page does nothing else then. */
  | { readonly kind: 'render-begin'; readonly request: FrameRenderRequest }
  /** The frame of a moment, seconds since the recording began; rooms go on by one frame. Unless kept, it is drawn for those who remember it. */
  | { readonly kind: 'render-frame'; readonly timeS: number; readonly keep: boolean }
  | { readonly kind: 'render-end' }
  /** Record the picture as a video until told to stop; the answer comes then. */
  | { readonly kind: 'record'; readonly on: boolean }
  /**
   * What is under a point of the picture, parts of its size from the top left? `layer`: whose depth, where it is tapped. `aroundPx`:
   * how many pixels on each side to tell of, too.
   */
  | { readonly kind: 'probe'; readonly x: number; readonly y: number; readonly layer: string | null; readonly aroundPx?: number }
  /** The gizmo to show in the preview; null: none. Removing it during a drag ends the drag without a message. */
  | { readonly kind: 'gizmo'; readonly gizmo: PreviewGizmo | null }
  /** Whether a click says what it hit. */
  | { readonly kind: 'picking'; readonly on: boolean }
  /** Which keys the editor has a use for, as `keybindingOf` writes them: they go to it where the preview has none of its own. */
  | { readonly kind: 'keys'; readonly keybindings: readonly string[]; readonly mac: boolean }
  /** Whether to tell what operations cost. */
  | { readonly kind: 'cost'; readonly on: boolean }
  /** Copies of layers tapped in the program (`node.port`), `heightPx` tall. */
  | { readonly kind: 'thumbnails'; readonly ports: readonly string[]; readonly heightPx: number };

/** Where the frames of a film come from. */
export type FrameRenderSource =
  | { readonly kind: 'recorded'; readonly url: string }
  /** As a phone sees it. `captureUrl`, `tier`: as of the preview's. `worldFromHead`: where it is; null: where the walk begins. */
  | {
      readonly kind: 'room';
      readonly captureUrl: string | null;
      readonly tier: PreviewTier;
      readonly frameRateHz: number;
      readonly lightDirectionWorld: readonly [number, number, number] | null;
      readonly worldFromHead: readonly number[] | null;
    };

/** How much of the room a program gets: with the camera's image, without it, or nothing of the room. */
export type PreviewTier = 'ar-camera' | 'ar' | 'vr';

export interface FrameRenderRequest {
  readonly program: Program;
  /** Params that were set after the program was compiled. */
  readonly values: readonly {
    readonly node: string;
    readonly param: string;
    readonly value: ParamValue;
  }[];
  readonly source: FrameRenderSource;
  readonly assetBaseUrl: string;
  readonly widthPx: number;
  readonly heightPx: number;
  /** Null: each frame is answered with its picture. */
  readonly video: { readonly frameRateHz: number } | null;
}

/** Seconds since the session began. `lastS`, `endS`: where the last frame begins and ends. Without `loop` the preview pauses there. */
export interface PreviewRange {
  readonly fromS: number;
  readonly lastS: number;
  readonly endS: number;
  readonly loop: boolean;
}

/** Arrows, rings or boxes around what a node places, as it stands in each frame. */
export interface PreviewGizmo {
  /** Of the program. */
  readonly node: string;
  readonly mode: GizmoMode;
  /** Along the axes of the world or of what is taken hold of. */
  readonly space: 'local' | 'world';
  /** To tenths of a meter, 15° and tenths of a factor. Ctrl does the opposite while it is held. */
  readonly snap: boolean;
  /** Which of the node's params says what. */
  readonly handles: Readonly<Partial<Record<Handle, string>>>;
  /** Nodes that the objects go through, where they go several ways. */
  readonly way: readonly string[];
}

export type GizmoMode = 'move' | 'rotate' | 'scale';

/** Addresses are on the preview's own origin. */
export type PreviewSource =
  | { readonly kind: 'recorded'; readonly url: string; readonly assetBaseUrl: string }
  /** An emulated device. `captureUrl` null: the room that the emulator makes itself. */
  | {
      readonly kind: 'room';
      readonly captureUrl: string | null;
      readonly views: 1 | 2;
      readonly assetBaseUrl: string;
      /** `glasses` add light to the world and show no black. */
      readonly device: 'phone' | 'headset' | 'glasses';
      /** `ar`: as on devices that show the camera's picture and give it to nobody. `vr`: with nothing of the room. */
      readonly tier: PreviewTier;
    }
  /** The computer's own camera, which is asked for. */
  | { readonly kind: 'camera'; readonly assetBaseUrl: string }
  /** A picture in the camera's place. `key` is another for each. */
  | { readonly kind: 'still'; readonly picture: Blob; readonly key: string; readonly assetBaseUrl: string }
  /** Nothing but the objects, to be looked at from all sides. */
  | { readonly kind: 'orbit'; readonly assetBaseUrl: string };

export type FromPreview =
  | { readonly kind: 'ready' }
  /** The program of this revision is now the one on screen. */
  | { readonly kind: 'playing'; readonly revision: number }
  /** Premultiplied RGBA, rows from the top; null where nothing was asked for but to go on. */
  | { readonly kind: 'frame-rendered'; readonly frame: Uint8Array<ArrayBuffer> | null }
  | { readonly kind: 'render-finished'; readonly file: Blob | null }
  | { readonly kind: 'render-failed'; readonly diagnostic: Diagnostic }
  /** A session began; null where it is no recording, and no moment can be gone to. */
  | { readonly kind: 'frames'; readonly frames: FrameTimes | null }
  /** Everything wrong with the running program, or with the one of `revision` that could not be taken over. */
  | { readonly kind: 'diagnostics'; readonly revision: number; readonly diagnostics: readonly Diagnostic[] }
  /** What the graphics driver said of the program of `revision`; empty when it took all shaders. The editor maps it to lines. */
  | { readonly kind: 'shader-errors'; readonly revision: number; readonly errors: readonly PreviewShaderError[] }
  /** What the graphics driver said of the shaders to try of `revision`; empty when it took all. */
  | { readonly kind: 'trial-errors'; readonly revision: number; readonly errors: readonly PreviewShaderError[] }
  /** At most ten times a second. */
  | { readonly kind: 'status'; readonly status: PreviewStatus }
  | { readonly kind: 'thumbnail'; readonly port: string; readonly image: ImageBitmap }
  | { readonly kind: 'probed'; readonly probe: PreviewProbe }
  /**
   * A gizmo is being dragged: the new values of the node's params. `drag` counts the drags of a page from 1, so that the editor can
   * ignore the rest of one that it canceled. `ended`: the last message of a drag. `cancelled`: the values before the drag return.
   */
  | {
      readonly kind: 'gizmo';
      readonly drag: number;
      readonly state: 'moved' | 'ended' | 'cancelled';
      readonly values: Readonly<Record<string, number | readonly number[]>>;
    }
  /** A click hit an object, which went through these nodes of the program, from the one that made it to the one that drew it. */
  | { readonly kind: 'picked'; readonly way: readonly string[]; readonly phantom: boolean }
  /** A key that the editor asked for was pressed while the preview had the focus. */
  | { readonly kind: 'key'; readonly keybinding: string }
  /** A screenshot or a video. Null where nothing is shown, or the browser cannot record. */
  | { readonly kind: 'captured'; readonly what: 'screenshot' | 'video'; readonly file: Blob | null }
  /** Twice a second while asked for. */
  | { readonly kind: 'costs'; readonly costs: readonly OperationCost[] }
  /** Null where nothing is shown. */
  | { readonly kind: 'poster'; readonly request: number; readonly bytes: Uint8Array<ArrayBuffer> | null };

/** Of one operation of the program, in one frame, all views together. */
export interface OperationCost {
  readonly id: string;
  readonly draws: number;
  /** Null where the browser does not tell (`EXT_disjoint_timer_query_webgl2`), or has not yet. */
  readonly gpuMs: number | null;
}

export interface PreviewProbe {
  /** As the question named it. */
  readonly x: number;
  readonly y: number;
  /** Display-referred sRGB with alpha, as shown, each in [0, 255]. */
  readonly color: readonly [number, number, number, number];
  /** As `color`, of a square around it, row by row from the top left, where that was asked for; transparent beyond the picture. */
  readonly around?: Uint8ClampedArray<ArrayBuffer>;
  /** Nearest of what has depth there; null where nothing has. */
  readonly depth: {
    readonly of: 'layer' | 'room';
    readonly meters: number;
    readonly positionWorld: readonly [number, number, number];
  } | null;
}

export interface PreviewShaderError {
  /** As in the program's `shaders`. */
  readonly shaderId: string;
  readonly stage: 'vertex' | 'fragment' | 'link';
  readonly log: string;
}

export interface PreviewStatus {
  readonly state: 'loading' | 'playing' | 'paused' | 'lost';
  /** Of the newest `session` message that is done with: its session is open, or cannot be, as a diagnostic says. Null before the first. */
  readonly request: number | null;
  /** Of a recording its own frame, later rounds counted on; else how many there were. */
  readonly frame: number;
  /** The picture is an earlier frame's: that of `frame` is being decoded. */
  readonly late: boolean;
  readonly timeS: number;
  /** Mean time of the last frames on the CPU. */
  readonly frameMs: number;
  readonly widthPx: number;
  readonly heightPx: number;
  /** Of the first view, column-major; null before the first frame. */
  readonly worldFromView: readonly number[] | null;
}
