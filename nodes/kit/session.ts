import type { Capability } from './definition.ts';

/**
 * What a session tells the runtime each frame (docs/ARCHITECTURE.md, “Sessions”). Types only: sessions live in `export/runtime/sessions` and
 * `export/emulator`. Objects are reused from frame to frame: read them during the frame, keep none.
 *
 * Spaces: world is right-handed, y up, meters, gravity-aligned, floor at y = 0 where the session knows it. View space looks
 * down -z. Matrices are column-major. View UV has its origin at the bottom left, as GL and ISF have it.
 */
export interface Session {
  readonly kind: 'webxr' | 'recorded' | 'camera' | 'orbit';
  readonly capabilities: ReadonlySet<Capability>;
  /** `device`: the display shows the world behind transparent pixels. `image`: the runtime draws each view's camera image. */
  readonly world: 'device' | 'image' | 'none';
  /** `additive` displays cannot darken: black is transparent. */
  readonly blend: 'opaque' | 'alpha' | 'additive';
  /** Nothing of the page is seen while it runs, as in headsets, which have no DOM overlay. */
  readonly hidesPage?: boolean;
  /** Begins delivering frames to `onFrame`, and events to `onEvent`, until `end`. */
  start(onFrame: (frame: SessionFrame) => void, onEvent: (event: SessionEvent) => void): void;
  /** Ends the session and frees what it made; safe to call twice. */
  end(): Promise<void>;
}

export type SessionEvent =
  | { readonly kind: 'ended'; readonly by: 'user' | 'system' | 'page' }
  | { readonly kind: 'visibility'; readonly visible: boolean }
  | { readonly kind: 'tracking'; readonly tracked: boolean }
  /** A capability that was granted has brought nothing for a while, or brings it again. */
  | { readonly kind: 'sensing'; readonly capability: Capability; readonly working: boolean }
  /** World space was re-centered or the recording started over: state that depends on poses is void. */
  | { readonly kind: 'reset' }
  | { readonly kind: 'problem'; readonly message: string };

export interface SessionFrame {
  /** Of a recording: its own frame, later rounds counted on; else counted up. A frame that is drawn again while time stands keeps it. */
  readonly index: number;
  readonly timeS: number;
  readonly deltaS: number;
  /** One or two; only the first `viewCount` entries of `views` are valid. */
  readonly viewCount: number;
  readonly views: readonly ViewFrame[];
  /** The final target; null is the canvas. */
  readonly framebuffer: WebGLFramebuffer | null;
  readonly framebufferWidthPx: number;
  readonly framebufferHeightPx: number;
  readonly light: LightEstimate | null;
  /** Absent or null where the session detects none. */
  readonly surfaces?: DetectedSurfaces | null;
  readonly input: SessionInput;
}

/** Real surfaces as the device has found them so far; they grow, join and go while it looks around. */
export interface DetectedSurfaces {
  readonly planes: readonly DetectedPlane[];
  readonly meshes: readonly DetectedMesh[];
}

/** What all detected surfaces have. The object is the same as long as the device takes the surface for the same. */
export interface DetectedSurface {
  /** Unique within the session. */
  readonly id: string;
  /** Raised when its shape changes; its pose may change in every frame. */
  readonly version: number;
  /** WebXR's semantic label (`floor`, `wall`, `table`, …), or empty. */
  readonly label: string;
  /** Column-major 4×4, rigid. */
  readonly worldFromSurface: Float32Array;
}

/** A flat part of a real surface: its y axis is the normal, its outline lies in its own x–z plane. */
export interface DetectedPlane extends DetectedSurface {
  readonly orientation: 'horizontal' | 'vertical' | 'other';
  /** Corners in order, x and z in turn, meters. */
  readonly outlineXZ: Float32Array;
}

/** A scanned real thing, or a whole room. */
export interface DetectedMesh extends DetectedSurface {
  /** x, y, z in turn, meters. */
  readonly positions: Float32Array;
  /** Three for each triangle; which side is its front is not said. */
  readonly indices: Uint32Array;
}

/** What the visitor did since the previous frame, and holds now. */
export interface SessionInput {
  /** Taps, clicks and selections by controllers or hands, oldest first; only the first `tapCount` entries are valid. */
  readonly taps: readonly Tap[];
  readonly tapCount: number;
  /** Controllers of a headset, or the halves of a gamepad. */
  readonly left: Controller;
  readonly right: Controller;
}

export interface Tap {
  /** Column-major 4×4, rigid: its origin is the eye or the hand, its -z axis points along the ray. */
  readonly worldFromRay: Float32Array;
  readonly by: 'screen' | 'left' | 'right' | 'other';
}

export interface Controller {
  readonly connected: boolean;
  /** In [-1, 1], to the right and up. */
  readonly stick: Float32Array;
  /** In [0, 1]. */
  readonly trigger: number;
  readonly squeeze: number;
  /** The lower and the upper of two buttons: A and B on the right, X and Y on the left. */
  readonly primary: boolean;
  readonly secondary: boolean;
  /** As of a tap; null for gamepads, and while it is not tracked. */
  readonly worldFromRay: Float32Array | null;
}

export interface ViewFrame {
  readonly eye: 'none' | 'left' | 'right';
  /** Column-major 4×4. */
  readonly clipFromView: Float32Array;
  readonly worldFromView: Float32Array;
  readonly viewFromWorld: Float32Array;
  readonly nearM: number;
  readonly farM: number;
  /** In the framebuffer, pixels, origin bottom left. */
  readonly viewport: Viewport;
  readonly cameraImage: CameraImage | null;
  readonly depth: RoomDepth | null;
}

export interface Viewport {
  readonly x: number;
  readonly y: number;
  readonly widthPx: number;
  readonly heightPx: number;
}

/** Display-referred sRGB in RGBA8, opaque, valid during the frame. */
export interface CameraImage {
  readonly texture: WebGLTexture;
  readonly widthPx: number;
  readonly heightPx: number;
  /** Column-major 3×3, homogeneous: texture UV from view UV. */
  readonly uvFromViewUv: Float32Array;
}

/** Meters along the view's axis in the red channel (R32F or R16F, nearest), 0 where unknown. */
export interface RoomDepth {
  readonly texture: WebGLTexture;
  readonly widthPx: number;
  readonly heightPx: number;
  /** Column-major 3×3, homogeneous: texture UV from view UV; any rotation, flip or crop. */
  readonly uvFromViewUv: Float32Array;
  /** Pose of the view that it is aligned with. */
  readonly worldFromDepth: Float32Array;
  /** Readers blend the four samples around, as far as these are known; else they take the nearest, known or not. */
  readonly interpolate?: boolean;
}

/** Light around the viewer. Spherical harmonics as WebXR Lighting Estimation §3.2 orders them. */
export interface LightEstimate {
  /** 9 coefficients × RGB, linear-sRGB radiance. */
  readonly sphericalHarmonics: Float32Array;
  /** Unit vector in world space, from the scene towards the light. */
  readonly primaryDirectionWorld: Float32Array;
  /** Linear-sRGB, not normalized. */
  readonly primaryIntensity: Float32Array;
  /** What shiny surfaces mirror; absent or null where the session knows none. */
  readonly reflection?: ReflectionCube | null;
}

/** Radiance from all sides, as GL reads a cube map by directions; linear where it is sampled, no mip levels. */
export interface ReflectionCube {
  readonly texture: WebGLTexture;
  /** Raised when the texture is another one, shows something else or lies otherwise. */
  readonly version: number;
  /** Column-major 3×3: directions of its axes from those of world space. Absent: they are the same. */
  readonly cubeFromWorld?: Float32Array;
}
