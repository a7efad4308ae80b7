import type { XRReferenceSpace } from 'iwer';
import { P_DEVICE, P_SESSION, P_SPACE, P_WEBGL_LAYER, XRAnchor, XRReferenceSpaceType, XRSession, XRSessionEvent, type XRSpace } from 'iwer';
import { createSessionDepth, type SessionDepth } from '../depth/session-depth.ts';
import type { Eye } from '../display/eye.ts';
import type { DepthConfiguration } from '../features.ts';
import { EmulatedHitTestSource, EmulatedTransientHitTestSource, type HitTestWishes } from '../hit-test/hit-test-source.ts';
import { EmulatedCompositionLayer, P_LAYER } from '../layers/composition-layer.ts';
import { createLightProbe, type EmulatedLightProbe, probeState, type ReflectionFormat } from '../light/light-probe.ts';
import { createSessionLight, type SessionLight } from '../light/session-light.ts';
import { P_EMULATED } from '../private.ts';
import type { DepthFormat, DepthUsage } from '../profiles.ts';
import type { RoomServices, World } from '../world.ts';
import { boundsOf, EmulatedBoundedReferenceSpace } from './bounded-space.ts';
import { createSurfaces, type Surfaces } from './detected-surfaces.ts';
import { EmulatedReferenceSpace, levelPose } from './emulated-reference-space.ts';
import {
  changeRenderState,
  checkRenderState,
  type EmulatedRenderState,
  initialRenderState,
  type RenderStateWishes,
} from './render-state.ts';
import { createViewportScale, type ViewportScale } from './viewport-scale.ts';

export interface EmulatedSessionState {
  readonly world: World;
  readonly roomServices: RoomServices;
  readonly depth: SessionDepth | null;
  readonly light: SessionLight;
  readonly overlayRoot: HTMLElement | null;
  readonly surfaces: Surfaces;
  readonly hitTests: { readonly active: Set<EmulatedHitTestSource>; readonly wishes: WeakMap<EmulatedHitTestSource, HitTestWishes> };
  readonly probes: EmulatedLightProbe[];
  /** Functions that release resources in the page's contexts when the session ends. */
  readonly disposers: (() => void)[];
  /** Eyes of the current or last frame. */
  eyes: readonly Eye[];
  /** Time of the last frame; null before the first. */
  lastFrameS: number | null;
  /** Whether the screen shows the last frame. */
  isShown: boolean;
  /** Origin of `local` spaces: the viewer's pose when the session started or was re-centered. */
  localOrigin: Float32Array;
  /** One per eye. */
  readonly viewportScales: readonly ViewportScale[];
}

export interface SessionGrant {
  readonly mode: 'immersive-ar' | 'immersive-vr' | 'inline';
  readonly features: readonly string[];
  readonly depth: DepthConfiguration | null;
  readonly overlayRoot: HTMLElement | null;
}

/** iwer's session with Scrim's frame loop and the WebXR modules that iwer does not implement. */
export class EmulatedSession extends XRSession {
  readonly [P_EMULATED]: EmulatedSessionState;
  #stopFrames: () => void = () => {};
  #capturedRoom = false;

  constructor(world: World, grant: SessionGrant) {
    super(world.device, grant.mode, [...grant.features]);
    world.device[P_DEVICE].updateViews();
    this[P_EMULATED] = {
      world,
      // An inline session does not need the room.
      get roomServices() {
        return world.roomServices();
      },
      depth: grant.depth ? createSessionDepth(world.roomServices().view, grant.depth, world.settings.depth) : null,
      light: createSessionLight(() => world.roomServices().light(), world.settings.light),
      overlayRoot: grant.overlayRoot,
      surfaces: createSurfaces(() => world.roomServices().room, world.device[P_DEVICE].globalSpace, world.settings.roomScanned),
      hitTests: { active: new Set(), wishes: new WeakMap() },
      probes: [],
      disposers: [],
      eyes: [],
      lastFrameS: null,
      isShown: true,
      localOrigin: levelPose(world.device[P_DEVICE].viewerSpace[P_SPACE].offsetMatrix),
      viewportScales: [createViewportScale(), createViewportScale()],
    };
    // The base class has started iwer's frame loop, which computes depth and hits from the poses of the previous frame. Stop it.
    const state = this[P_SESSION];
    if (state.deviceFrameHandle !== undefined) globalThis.cancelAnimationFrame(state.deviceFrameHandle);
    delete state.deviceFrameHandle;
    state.onDeviceFrame = () => {};
    state.renderState = initialRenderState(grant.mode);
  }

  /** Starts the frame loop, which ends with the session. */
  startFrames(run: (session: EmulatedSession, timeS: number) => boolean): void {
    this.#stopFrames = this[P_EMULATED].world.frames.start((timeS) => run(this, timeS));
  }

  override async end(): Promise<void> {
    if (!this[P_SESSION].ended) this.#leave();
    return super.end();
  }

  #leave(): void {
    const { world, depth, disposers } = this[P_EMULATED];
    this.#stopFrames();
    if (!this.#isInline()) {
      world.screenInput.reset();
      world.screen.hide();
    }
    depth?.dispose();
    for (const dispose of disposers.splice(0)) dispose();
  }

  // --- Inline sessions: nothing of the device is visible ---

  #isInline(): boolean {
    return this[P_SESSION].mode === 'inline';
  }

  override get visibilityState(): never {
    return (this.#isInline() ? 'visible' : super.visibilityState) as never;
  }

  override get interactionMode(): never {
    return (this.#isInline() ? 'screen-space' : super.interactionMode) as never;
  }

  // --- Frames ---

  override updateRenderState(wishes: object = {}): void {
    const state = this[P_SESSION];
    if (state.ended) throw new DOMException('The session has ended.', 'InvalidStateError');
    checkRenderState(wishes as RenderStateWishes, state.mode, this.enabledFeatures, (layer) => ownerOf(layer) === this);
    const former = (state.pendingRenderState ?? state.renderState) as EmulatedRenderState;
    state.pendingRenderState = changeRenderState(former, wishes as RenderStateWishes);
  }

  /** Stores the rate; the emulator's clock still schedules the frames. */
  override async updateTargetFrameRate(rate: number): Promise<void> {
    const state = this[P_SESSION];
    if (state.ended) throw new DOMException('The session has ended.', 'InvalidStateError');
    const { supportedFrameRates } = state;
    if (!supportedFrameRates?.includes(rate)) {
      throw new TypeError(`The frame rate ${rate} Hz is not supported. Use one of ${[...(supportedFrameRates ?? [])].join(', ')}.`);
    }
    if (rate === state.nominalFrameRate) return;
    await null;
    state.nominalFrameRate = rate;
    this.dispatchEvent(new XRSessionEvent('frameratechange', { session: this }));
  }

  /**
   * Dispatches an event. iwer dispatches `select` and `squeeze` when the action starts; here they are dispatched when it ends, just before
   * its end event (WebXR Device API §10.2).
   */
  override dispatchEvent(event: Event): boolean {
    const action = /^(select|squeeze)(end)?$/.exec(event.type);
    if (!action || !this[P_EMULATED].world.profile.controllers) return super.dispatchEvent(event);
    if (!action[2]) return true;
    const { frame, inputSource } = event as Event & { frame: unknown; inputSource: unknown };
    const EventClass = event.constructor as new (type: string, init: object) => Event;
    super.dispatchEvent(new EventClass(action[1] ?? '', { frame, inputSource }));
    return super.dispatchEvent(event);
  }

  // --- Spaces ---

  override async requestReferenceSpace(type: XRReferenceSpaceType): Promise<XRReferenceSpace> {
    const state = this[P_SESSION];
    const types: readonly string[] = Object.values(XRReferenceSpaceType);
    if (!types.includes(type)) throw new TypeError(`"${type}" is not a reference space. Use one of ${types.join(', ')}.`);
    if (state.ended || !state.referenceSpaceIsSupported(type)) {
      throw new DOMException(`The reference space "${type}" is not supported by this session.`, 'NotSupportedError');
    }
    const { globalSpace, viewerSpace } = state.device[P_DEVICE];
    const parent = type === XRReferenceSpaceType.Viewer ? viewerSpace : globalSpace;
    const origin = type === XRReferenceSpaceType.Local ? this[P_EMULATED].localOrigin : undefined;
    const space =
      type === XRReferenceSpaceType.BoundedFloor
        ? new EmulatedBoundedReferenceSpace(type, parent, boundsOf(this[P_EMULATED].roomServices.room))
        : new EmulatedReferenceSpace(type, parent, origin);
    state.referenceSpaces.push(space);
    return space;
  }

  // --- Anchors: WebXR Anchors §4 ---

  /** Creates an anchor at the current origin of `space`; resolves in the next frame. */
  async anchorAt(space: XRSpace): Promise<XRAnchor> {
    this.requireFeature('anchors');
    return this.confirmed(new XRAnchor(space, this));
  }

  /** Registers an anchor with the session. Resolves when the device tracks the anchor: in the next frame. */
  async confirmed(anchor: XRAnchor): Promise<XRAnchor> {
    const { persistentAnchors } = this[P_EMULATED].world;
    anchor.requestPersistentHandle = async () => persistentAnchors.keep(anchor);
    return new Promise((resolve, reject) => {
      this[P_SESSION].newAnchors.set(anchor, { resolve: (value) => resolve(value as XRAnchor), reject });
    });
  }

  override get persistentAnchors(): string[] {
    return [...this[P_EMULATED].world.persistentAnchors.handles];
  }

  override async restorePersistentAnchor(handle: string): Promise<XRAnchor> {
    this.requireFeature('anchors');
    return this.confirmed(this[P_EMULATED].world.persistentAnchors.restore(handle, this));
  }

  override async deletePersistentAnchor(handle: string): Promise<undefined> {
    this.requireFeature('anchors');
    this[P_EMULATED].world.persistentAnchors.delete(handle);
  }

  // --- Room capture: WebXR Plane Detection §4 ---

  /** Scans the room at once. A session can do so once. */
  async initiateRoomCapture(): Promise<void> {
    this.requireFeature('plane-detection');
    if (this.#capturedRoom) throw new DOMException('The session has captured the room already.', 'InvalidStateError');
    this.#capturedRoom = true;
    this[P_EMULATED].surfaces.scan();
  }

  // --- Depth: WebXR Depth Sensing §2.3 ---

  override get depthUsage(): DepthUsage {
    return this.#depthConfiguration().usage;
  }

  override get depthDataFormat(): never {
    return this.#depthConfiguration().format as DepthFormat as never;
  }

  get depthType(): null {
    this.#depthConfiguration();
    return null;
  }

  get depthActive(): boolean {
    return this.#depthConfiguration().active;
  }

  pauseDepthSensing(): void {
    this.#depthConfiguration().active = false;
  }

  resumeDepthSensing(): void {
    this.#depthConfiguration().active = true;
  }

  /** @throws DOMException NotSupportedError if the session has no depth sensing. */
  requireDepth(): SessionDepth {
    const { depth } = this[P_EMULATED];
    if (!depth) throw new DOMException('The session has no depth sensing.', 'NotSupportedError');
    return depth;
  }

  #depthConfiguration(): SessionDepth {
    const { depth } = this[P_EMULATED];
    if (!depth) throw new DOMException('The session has no depth sensing.', 'InvalidStateError');
    return depth;
  }

  // --- Light: WebXR Lighting Estimation §4.2 ---

  get preferredReflectionFormat(): ReflectionFormat {
    return 'rgba16f';
  }

  async requestLightProbe({ reflectionFormat = 'srgba8' }: { reflectionFormat?: ReflectionFormat } = {}): Promise<EmulatedLightProbe> {
    this.requireFeature('light-estimation');
    if (reflectionFormat !== 'srgba8' && reflectionFormat !== this.preferredReflectionFormat) {
      throw new DOMException(`The reflection format "${reflectionFormat}" is not supported.`, 'NotSupportedError');
    }
    const { world, probes } = this[P_EMULATED];
    const probe = createLightProbe(this, world.device[P_DEVICE].globalSpace, reflectionFormat);
    probes.push(probe);
    return probe;
  }

  /** Dispatches `reflectionchange` once per probe and again when the cube map changes. */
  announceReflections(): void {
    const { light, probes, roomServices, world } = this[P_EMULATED];
    const another = light.follow(world.lightState, roomServices.lightMoves);
    for (const probe of probes) {
      const state = probeState(probe);
      if (!state || !(another || state.changed)) continue;
      state.changed = false;
      probe.dispatchEvent(new Event('reflectionchange'));
    }
  }

  // --- Hits: WebXR Hit Test §5 ---

  override async requestHitTestSource(wishes: object): Promise<never> {
    this.requireFeature('hit-test');
    if (!(wishes as HitTestWishes).space) throw new TypeError('A hit test requires a space.');
    return this.#addHitTest(EmulatedHitTestSource, wishes as HitTestWishes) as never;
  }

  async requestHitTestSourceForTransientInput(wishes: HitTestWishes): Promise<EmulatedTransientHitTestSource> {
    this.requireFeature('hit-test');
    if (!wishes.profile) throw new TypeError('A hit test for transient input requires a profile.');
    return this.#addHitTest(EmulatedTransientHitTestSource, wishes);
  }

  #addHitTest<T extends EmulatedHitTestSource>(Source: new (active: Set<EmulatedHitTestSource>) => T, wishes: HitTestWishes): T {
    const { active, wishes: all } = this[P_EMULATED].hitTests;
    const source = new Source(active);
    all.set(source, wishes);
    return source;
  }

  // --- DOM overlay: WebXR DOM Overlays §3.2 ---

  get domOverlayState(): { readonly type: 'screen' } | null {
    return this[P_EMULATED].overlayRoot ? { type: 'screen' } : null;
  }

  /** @throws DOMException InvalidStateError if the session has ended, NotSupportedError if it does not have the feature. */
  requireFeature(feature: string): void {
    if (this[P_SESSION].ended) throw new DOMException('The session has ended.', 'InvalidStateError');
    if (!this.enabledFeatures.includes(feature)) {
      throw new DOMException(`The session was not granted "${feature}".`, 'NotSupportedError');
    }
  }
}

/** The session that a layer was created for. */
function ownerOf(layer: object): unknown {
  if (layer instanceof EmulatedCompositionLayer) return layer[P_LAYER].session;
  return P_WEBGL_LAYER in layer ? (layer[P_WEBGL_LAYER] as { session: unknown }).session : null;
}
