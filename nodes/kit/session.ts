import type { Capability } from './definition.ts';

/**
 * A source of frames (docs/ARCHITECTURE.md, “Sessions”). This file contains only types; sessions are in `export/runtime/sessions` and
 * `export/emulator`. All objects of a frame are reused for the next: do not keep them.
 *
 * Spaces: world space is right-handed, y up, in meters, aligned with gravity, with the floor at y = 0 if the session provides it. View
 * space looks down -z. Matrices are column-major. The origin of view UV is at the bottom left, as in GL and ISF.
 */
export interface Session {
  readonly kind: 'webxr' | 'recorded' | 'camera' | 'orbit';
  readonly capabilities: ReadonlySet<Capability>;
  /**
   * Where the image of the real world comes from. `device`: the display shows the world behind transparent pixels. `image`: the runtime
   * draws the camera image of each view. `none`: nowhere.
   */
  readonly world: 'device' | 'image' | 'none';
  /** How the display mixes the image with the world. `additive` displays cannot darken: black is transparent on them. */
  readonly blend: 'opaque' | 'alpha' | 'additive';
  /** True if the page is not visible during the session, as in headsets without DOM overlay. */
  readonly hidesPage?: boolean;
  /** Starts to call `onFrame` for each frame and `onEvent` for each event, until `end`. */
  start(onFrame: (frame: SessionFrame) => void, onEvent: (event: SessionEvent) => void): void;
  /** Ends the session and disposes its resources; may be called twice. */
  end(): Promise<void>;
}

/**
 * Why state is reset. `restart`: time jumps. `repeat`: a recording begins again and time continues, in the same room; what the visitor
 * has made there stays.
 */
export type ResetCause = 'restart' | 'repeat';

/** An event of a session, between two frames. */
export type SessionEvent =
  | { readonly kind: 'ended'; readonly by: 'user' | 'system' | 'page' }
  | { readonly kind: 'visibility'; readonly visible: boolean }
  | { readonly kind: 'tracking'; readonly tracked: boolean }
  /** A granted feature has returned no data for a while, or returns data again. */
  | { readonly kind: 'sensing'; readonly capability: Capability; readonly working: boolean }
  /**
   * The device has detected no surface of the room for a while. `capture` starts a scan of the room, in which the device asks the visitor;
   * it resolves to false if the device or the visitor refuses, and can be called once. Null: surfaces have come, so that no scan is needed.
   */
  | { readonly kind: 'room-unknown'; readonly capture: (() => Promise<boolean>) | null }
  /** The recording jumped to another time, or repeats while time continues. Nodes return to their initial state. */
  | { readonly kind: 'reset'; readonly cause: ResetCause }
  /** World space moved against the room, as when the visitor re-centers. State stays; `SessionFrame.jumps` has been raised. */
  | { readonly kind: 'recentered' }
  | { readonly kind: 'problem'; readonly message: string };

/** One frame of a session. */
export interface SessionFrame {
  /**
   * Number of the frame. In a recording it is the number of the recorded frame, which continues through the loops; elsewhere it is a
   * counter. A frame that is drawn again keeps its number.
   */
  readonly index: number;
  /** Seconds since the session began. */
  readonly timeS: number;
  /** Seconds since the previous frame. */
  readonly deltaS: number;
  /** The number of views, one or two. Only the first `viewCount` entries of `views` are valid. */
  readonly viewCount: number;
  readonly views: readonly ViewFrame[];
  /** The framebuffer that the final image is drawn into; null is the canvas. */
  readonly framebuffer: WebGLFramebuffer | null;
  readonly framebufferWidthPx: number;
  readonly framebufferHeightPx: number;
  /**
   * An integer from 0 that changes whenever what the session measures changes: camera images, depth, light, surfaces. Absent: they may change in
   * every frame, as those of devices do.
   */
  readonly version?: number;
  readonly light: LightEstimate | null;
  /** The detected surfaces. Absent or null if the session does not detect surfaces. */
  readonly surfaces?: DetectedSurfaces | null;
  readonly input: SessionInput;
  /** A number that is raised when world space moves relative to the room, as at re-centering. Filters of poses restart then. */
  readonly jumps: number;
  /**
   * How world space moved with the last jump, if the device tells: from the former world space to the present one, rigid, column-major 4×4.
   * Null or absent: unknown.
   */
  readonly worldFromFormer?: Float32Array | null;
  /** The room as voxels when the recording began (`voxel-file.ts`); null or absent where none were recorded. */
  readonly roomFile?: Uint8Array | null;
  /**
   * The WebXR frame from which this frame was made, for the runtime's own hit tests and anchors; null or absent in other sessions. Nodes do
   * not read it.
   */
  readonly xr?: XrAccess | null;
}

/** What the runtime needs of WebXR. The objects are those of the browser: `XRSession`, `XRFrame`, `XRReferenceSpace`. */
export interface XrAccess {
  readonly session: object;
  /** The `XRFrame`, valid until its callback ends. */
  readonly frame: object;
  /** The `XRReferenceSpace` that is world space. */
  readonly referenceSpace: object;
  /** The features that the session has granted. */
  readonly capabilities: ReadonlySet<Capability>;
}

/** The real surfaces that the device has detected so far. They change while the device moves. */
export interface DetectedSurfaces {
  readonly planes: readonly DetectedPlane[];
  readonly meshes: readonly DetectedMesh[];
}

/** A detected surface. The object is the same as long as the device tracks the surface. */
export interface DetectedSurface {
  /** Id of the surface, unique within the session. */
  readonly id: string;
  /** A number that is increased when the surface's shape changes. Its pose can change in every frame without that. */
  readonly version: number;
  /** WebXR's semantic label (`floor`, `wall`, `table`, …), or empty. */
  readonly label: string;
  /** The pose of the surface: column-major 4×4, rigid. */
  readonly worldFromSurface: Float32Array;
}

/** A flat part of a real surface. Its y axis is the normal; its outline is in its x–z plane. */
export interface DetectedPlane extends DetectedSurface {
  readonly orientation: 'horizontal' | 'vertical' | 'other';
  /** Corners of the outline in order, alternating x and z, meters. */
  readonly outlineXZ: Float32Array;
}

/** The mesh of a scanned object or of a whole room. */
export interface DetectedMesh extends DetectedSurface {
  /** The vertices of the mesh: x, y, z of each, meters. */
  readonly positions: Float32Array;
  /** Indices of vertices, three per triangle; the winding is not specified. */
  readonly indices: Uint32Array;
}

/** The input of the visitor: pointers, taps and keys since the previous frame and the current state of the controllers. */
export interface SessionInput {
  /**
   * Fingers, mouse, controllers, hands and gaze that point somewhere in this frame; only the first `pointerCount` entries are valid.
   * Touches of the page's controls are not among them.
   */
  readonly pointers: readonly Pointer[];
  readonly pointerCount: number;
  /**
   * Taps, clicks and selections by controllers or hands, oldest first; only the first `tapCount` entries are valid. They are derived
   * from pointers: a tap is a pointer in the phase `end` whose `tapped` is true.
   */
  readonly taps: readonly Tap[];
  readonly tapCount: number;
  /** Controllers of a headset, or the halves of a gamepad. */
  readonly left: Controller;
  readonly right: Controller;
  /** Joints of the bare hands. Hands are tracked only if a node of the program needs `hands` and the session grants it. */
  readonly leftHand: Hand;
  readonly rightHand: Hand;
  /**
   * Keys pressed on the view since the previous frame, oldest first, with repeats of held keys; only the first `keyCount` entries are
   * valid. Listed while a node owns the keys (`nodes/kit/pointers.ts`); sessions of headsets and phones list none.
   */
  readonly keys: readonly KeyPress[];
  readonly keyCount: number;
  /** Which node the keys are for; null: the page's own, such as turning the view. Written by `ownKeys` and `freeKeys` alone. */
  keyOwner: object | null;
}

/** A press of a key, or a repeat while the key is held. */
export interface KeyPress {
  /** The name of the key, as in `KeyboardEvent.key`; letters in lower case. */
  readonly key: string;
  readonly shift: boolean;
  /** Control, or Command on a Mac. */
  readonly control: boolean;
}

/**
 * Something that points along a ray. A press takes at least two frames: one with the phase `start`, any number with `hold`, one with
 * `end` or `cancel`. Fingers and transient inputs are listed only while they press. The object is reused by later pointers: keep its
 * `id`, not the object. A node that handles a press claims the pointer (`nodes/kit/pointers.ts`).
 */
export interface Pointer {
  /**
   * Id of the pointer, from 1, unique within the session. A mouse, controller or hand keeps its id over several presses; each touch has its
   * own.
   */
  readonly id: number;
  readonly by: PointerKind;
  readonly phase: PointerPhase;
  /**
   * The ray along which the pointer points: column-major 4×4, rigid. Its origin is the eye or the hand; its -z axis points along the ray.
   */
  readonly worldFromRay: Float32Array;
  /** The pose of the hand where it holds something (WebXR's grip space). Null for screens, mouse and gaze, and while it is not tracked. */
  readonly worldFromGrip: Float32Array | null;
  /** How far a pinch or trigger is closed, in [0, 1]; 1 while a screen or mouse is pressed. */
  readonly pinch: number;
  /** Whether the press was a tap, click or selection, not a drag. Valid in the phase `end`. */
  readonly tapped: boolean;
  /** The browser's `XRInputSource`, for the runtime's own hit tests; null in other sessions. Nodes do not read it. */
  readonly xrSource: object | null;
  /** The object that has claimed the pointer, usually the context of a node; null while none has. Written by `claimPointer` alone. */
  owner: object | null;
  /**
   * The distance along the ray to what the owner has claimed, meters. Written by `claimPointer` alone; without meaning while `owner` is
   * null.
   */
  ownerDistanceM: number;
}

/**
 * `hover`: nothing is pressed. `start`: the press begins in this frame. `hold`: it continues. `end`: it ends. `cancel`: the system has
 * ended the press, so its effects are to be undone.
 */
export type PointerPhase = 'hover' | 'start' | 'hold' | 'end' | 'cancel';

export type PointerKind = 'screen' | 'mouse' | 'left' | 'right' | 'left-hand' | 'right-hand' | 'gaze';

/** A select action. */
export interface Tap {
  /** The ray of the tap: column-major 4×4, rigid. The origin is at the camera or the hand; the -z axis points along the ray. */
  readonly worldFromRay: Float32Array;
  readonly by: 'screen' | 'left' | 'right' | 'other';
}

/** The current state of a controller. */
export interface Controller {
  readonly connected: boolean;
  /** The position of the thumbstick: x to the right and y up, in [-1, 1]. */
  readonly stick: Float32Array;
  /** How far the trigger and the grip button are pressed, in [0, 1]. */
  readonly trigger: number;
  readonly squeeze: number;
  /** The lower button: A on the right, X on the left. */
  readonly primary: boolean;
  /** The upper button: B on the right, Y on the left. */
  readonly secondary: boolean;
  /** Whether the thumbstick is pressed down. */
  readonly stickPressed: boolean;
  /** The ray along which the controller points, as in `Tap`. Null for gamepads, and while the controller is not tracked. */
  readonly worldFromRay: Float32Array | null;
  /**
   * WebXR's grip space: the origin is in the palm that holds the controller, -z points along its handle. Null whenever `worldFromRay` is.
   */
  readonly worldFromGrip: Float32Array | null;
  /** True for a bare hand, which some browsers list as a controller whose trigger is the pinch. */
  readonly bare: boolean;
  /** The motor that vibrates the controller; null if it has none. */
  readonly haptics: Haptics | null;
}

/** The motor of a controller. */
export interface Haptics {
  /**
   * Vibrates once. A vibration replaces the one before it. Nothing happens where the browser refuses.
   *
   * @param strength In [0, 1].
   * @param durationS Seconds; browsers limit it to 5.
   */
  pulse(strength: number, durationS: number): void;
}

/** A bare hand. `nodes/kit/hand-joints.ts` has the names of the joints, `nodes/kit/hands.ts` what is computed from them. */
export interface Hand {
  /** True if all joints have a pose in this frame. While false, the arrays keep the last poses. */
  readonly tracked: boolean;
  /**
   * The pose of each joint: column-major 4×4, rigid, in the order of `HAND_JOINTS`. -z points along the bone to the fingertip, y out of the
   * back of the hand.
   */
  readonly worldFromJoints: Float32Array;
  /** Distance from each joint to the skin, meters. */
  readonly radiiM: Float32Array;
}

/** One view of a frame: an eye, or the screen. */
export interface ViewFrame {
  readonly eye: 'none' | 'left' | 'right';
  /** Projection of the view, column-major 4×4. */
  readonly clipFromView: Float32Array;
  readonly worldFromView: Float32Array;
  readonly viewFromWorld: Float32Array;
  readonly nearM: number;
  readonly farM: number;
  /** The part of the framebuffer that the view covers. */
  readonly viewport: Viewport;
  readonly cameraImage: CameraImage | null;
  readonly depth: RoomDepth | null;
}

/** A rectangle of a framebuffer, pixels, origin bottom left. */
export interface Viewport {
  readonly x: number;
  readonly y: number;
  readonly widthPx: number;
  readonly heightPx: number;
}

/** The camera image of a view: display-referred sRGB, RGBA8, opaque, valid during the frame. */
export interface CameraImage {
  readonly texture: WebGLTexture;
  readonly widthPx: number;
  readonly heightPx: number;
  /** Column-major 3×3, homogeneous: texture UV from view UV. */
  readonly uvFromViewUv: Float32Array;
}

/** Room depth of a view: meters along the view axis in the red channel (R32F or R16F, nearest), 0 where unknown. */
export interface RoomDepth {
  readonly texture: WebGLTexture;
  readonly widthPx: number;
  readonly heightPx: number;
  /** Column-major 3×3, homogeneous: texture UV from view UV; any rotation, flip or crop. */
  readonly uvFromViewUv: Float32Array;
  /** Pose of the view that the depth is aligned with; column-major 4×4. */
  readonly worldFromDepth: Float32Array;
  /** How readers interpolate. True: between the known ones of the four nearest samples. Otherwise they read the nearest sample. */
  readonly interpolate?: boolean;
  /** The same samples as in `texture` on the CPU, rows in the order of the texture; null or absent if they are only on the GPU. */
  readonly meters?: Float32Array | null;
}

/** Room depth on the CPU, with the view that it was taken for. */
export interface DepthImage {
  /** Depth along the view's axis, meters, 0 where unknown; rows as in the texture. */
  readonly meters: Float32Array;
  readonly widthPx: number;
  readonly heightPx: number;
  /** Column-major 3×3, homogeneous: texture UV from view UV. */
  readonly uvFromViewUv: Float32Array;
  readonly clipFromView: Float32Array;
  readonly worldFromView: Float32Array;
  /** Index of the frame in which the depth was measured. */
  readonly frame: number;
}

/** The estimated light of the room. Spherical harmonics are in the order of WebXR Lighting Estimation §3.2. */
export interface LightEstimate {
  /** 9 coefficients × RGB, linear-sRGB radiance. */
  readonly sphericalHarmonics: Float32Array;
  /** Unit vector in world space, from the scene towards the light. */
  readonly primaryDirectionWorld: Float32Array;
  /** Color and intensity of the primary light: linear sRGB, not normalized. */
  readonly primaryIntensity: Float32Array;
  /** The reflections of the room as a cube map. Absent or null if the session provides none. */
  readonly reflection?: ReflectionCube | null;
}

/** A cube map of radiance. Samples are linear-sRGB; there are no mipmaps. */
export interface ReflectionCube {
  readonly texture: WebGLTexture;
  /** Increased when the texture, its content or its orientation changes. */
  readonly version: number;
  /** The rotation from directions of world space to directions of the cube map, column-major 3×3. Absent: the identity. */
  readonly cubeFromWorld?: Float32Array;
}
