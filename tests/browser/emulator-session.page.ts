/// <reference types="webxr" />
import { installEmulator } from '../../export/emulator/install-emulator.ts';
import type { EmulatorOptions } from '../../export/emulator/options.ts';
import { createContext, enter, enterWith, first, lookAt, nameOfError, nameOfThrow, requestSession, type Stage } from './emulator-kit.ts';

const FLOOR = { label: 'floor', centerWorld: [0, -0.05, 0], sizeM: [8, 0.1, 8] } as const;
const TABLE = { label: 'table', centerWorld: [0, 0.4, -2], sizeM: [1, 0.8, 1] } as const;
const ROOM = { boxes: [FLOOR, TABLE] };

async function withDevice<T>(options: EmulatorOptions, act: () => Promise<T>): Promise<T> {
  const emulator = installEmulator({ clock: 'manual', room: ROOM, ...options });
  try {
    return await act();
  } finally {
    await emulator.uninstall();
  }
}

async function onStage<T>(options: EmulatorOptions, init: XRSessionInit, act: (stage: Stage) => Promise<T>): Promise<T> {
  const stage = await enter({ room: ROOM, ...options }, init);
  try {
    return await act(stage);
  } finally {
    await stage.leave();
  }
}

const CPU_DEPTH = { usagePreference: ['cpu-optimized'], dataFormatPreference: ['luminance-alpha'] } as const satisfies XRDepthStateInit;

/** Names of the errors of requests, null for those that were granted, and the features of the last. */
export function requests() {
  return withDevice({ device: 'phone', refuse: ['camera-access'] }, async () => {
    const refusal = (init: XRSessionInit, mode?: XRSessionMode) => nameOfError(async () => (await requestSession(init, mode)).end());
    const errors = {
      refusedRequired: await refusal({ requiredFeatures: ['camera-access'] }),
      unknownRequired: await refusal({ requiredFeatures: ['telepathy'] }),
      inline: await refusal({}, 'inline'),
      depthWithoutWishes: await refusal({ requiredFeatures: ['depth-sensing'] }),
      depthInAnotherFormat: await refusal({
        requiredFeatures: ['depth-sensing'],
        depthSensing: { usagePreference: ['cpu-optimized'], dataFormatPreference: ['float32'] },
      }),
      overlayWithoutRoot: await refusal({ requiredFeatures: ['dom-overlay'] }),
      plain: await refusal({}),
    };
    const session = await requestSession({
      optionalFeatures: ['camera-access', 'telepathy', 'depth-sensing', 'hit-test'],
      depthSensing: { usagePreference: [], dataFormatPreference: ['float32', 'luminance-alpha'] },
    });
    const second = await nameOfError(() => requestSession({}));
    const granted = { features: session.enabledFeatures, depth: [session.depthUsage, session.depthDataFormat] };
    await session.end();
    return { errors, second, granted, supported: await navigator.xr?.isSessionSupported('immersive-ar') };
  });
}

/** Names of the errors of what a page must not do. */
export function trespasses() {
  return onStage(
    {},
    { requiredFeatures: ['depth-sensing', 'camera-access', 'light-estimation', 'hit-test'], depthSensing: CPU_DEPTH },
    async (stage) => {
      const { session, binding, space, frame, gl, layer } = stage;
      const probe = await (session as unknown as { requestLightProbe(): Promise<object> }).requestLightProbe();
      const source = await session.requestHitTestSource?.({ space });
      const old = await frame((f, pose) => {
        const view = first(pose.views) as XRView & { camera: object };
        return { f, view, depth: f.getDepthInformation?.(view), camera: view.camera };
      });
      const late = old.f as XRFrame & { getLightEstimate(probe: object): void };
      const lateBinding = binding as unknown as { getCameraImage(camera: object): void };
      const stale = {
        pose: await nameOfError(() => late.getViewerPose(space)),
        depth: await nameOfError(() => late.getDepthInformation?.(old.view)),
        depthData: await nameOfError(() => old.depth?.data),
        depthValue: await nameOfError(() => old.depth?.getDepthInMeters(0.5, 0.5)),
        planes: await nameOfError(() => late.detectedPlanes),
        light: await nameOfError(() => late.getLightEstimate(probe)),
        hits: await nameOfError(() => source && late.getHitTestResults(source)),
        cameraImage: await nameOfError(() => lateBinding.getCameraImage(old.camera)),
        viewport: await nameOfError(() => layer.getViewport(old.view)),
      };
      const within = await frame((f, pose) => ({
        viewOfAnotherFrame: nameOfThrow(() => f.getDepthInformation?.(old.view)),
        outsideTheView: nameOfThrow(() => f.getDepthInformation?.(first(pose.views))?.getDepthInMeters(1.01, 0)),
        depthOfTheGpu: nameOfThrow(() => binding.getDepthInformation(first(pose.views))),
      }));
      await session.end();
      const ended = {
        renderState: await nameOfError(() => session.updateRenderState({ depthNear: 1 })),
        end: await nameOfError(() => session.end()),
        layer: await nameOfError(() => new XRWebGLLayer(session, gl)),
        space: await nameOfError(() => session.requestReferenceSpace('local')),
        hitTest: await nameOfError(() => session.requestHitTestSource?.({ space })),
      };
      return { stale, within, ended };
    },
  );
}

export function trespassesWithoutFeatures() {
  return onStage({}, {}, async ({ session, frame, binding }) => {
    const lamp = session as unknown as { requestLightProbe(): Promise<object> };
    const probe = await nameOfError(() => lamp.requestLightProbe());
    return frame((f, pose) => ({
      probe,
      depth: nameOfThrow(() => f.getDepthInformation?.(first(pose.views))),
      gpuDepth: nameOfThrow(() => binding.getDepthInformation(first(pose.views))),
      usage: nameOfThrow(() => session.depthUsage),
      format: nameOfThrow(() => session.depthDataFormat),
      camera: (first(pose.views) as XRView & { camera: unknown }).camera,
      plainContext: nameOfThrow(() => new XRWebGLLayer(session, createContext({}))),
    }));
  });
}

export async function contextMadeCompatible() {
  return onStage({}, {}, async ({ session }) => {
    const gl = createContext({});
    await gl.makeXRCompatible();
    return nameOfError(() => new XRWebGLLayer(session, gl));
  });
}

/** Eyes, viewports and projections as a page finds them. */
export function views(options: EmulatorOptions) {
  return onStage(options, {}, async ({ session, layer, frame, emulator }) => {
    emulator.setPose(lookAt([0.5, 1.5, 1], [0.5, 1.5, 0]));
    return frame((_, pose) => ({
      size: [layer.framebufferWidth, layer.framebufferHeight],
      blend: session.environmentBlendMode,
      interaction: session.interactionMode,
      views: pose.views.map((view) => {
        const { x = 0, y = 0, width = 0, height = 0 } = layer.getViewport(view) ?? {};
        return {
          eye: view.eye,
          viewport: [x, y, width, height],
          projection: [...view.projectionMatrix],
          position: point(view.transform.position),
        };
      }),
    }));
  });
}

/** Poses after a loss of tracking, visibility events, and what time frames carry. */
export function troubles() {
  return onStage({}, {}, async ({ session, emulator, frame, space }) => {
    const told: string[] = [];
    session.addEventListener('visibilitychange', () => told.push(session.visibilityState));
    space.addEventListener('reset', () => told.push('reset'));
    const times = [await frame((_, __, timeMs) => timeMs), await frame((_, __, timeMs) => timeMs)];
    emulator.setTracked(false);
    const lost = await frame((_, pose) => pose);
    emulator.setTracked(true);
    const found = (await frame((_, pose) => pose)) !== null;
    let calledWhileHidden = 0;
    emulator.setVisibility('hidden');
    session.requestAnimationFrame(() => calledWhileHidden++);
    await emulator.stepFrame(2);
    const hidden = calledWhileHidden;
    emulator.setVisibility('visible');
    await emulator.stepFrame();
    emulator.recenter();
    await frame(() => {});
    const errors: string[] = [];
    const note = (event: ErrorEvent): void => {
      errors.push(event.message);
    };
    window.addEventListener('error', note, { once: true });
    session.requestAnimationFrame(() => {
      throw new Error('the page stumbled');
    });
    await emulator.stepFrame();
    const stumbled = await nameOfError(() => emulator.stepFrame());
    return { times, lost, found, hidden, shown: calledWhileHidden, told, errors, stumbled };
  });
}

/** Where spaces lie, for a head that has turned, bowed and moved. */
export async function spaces() {
  const emulator = installEmulator({ clock: 'manual', room: ROOM });
  emulator.setPose(lookAt([1, 1.5, 2], [0, 0.5, 2]));
  const stage = await enterWith(emulator, { optionalFeatures: ['unbounded'] });
  const { session, space, frame } = stage;
  const local = await session.requestReferenceSpace('local');
  const viewer = await session.requestReferenceSpace('viewer');
  const shifted = space.getOffsetReferenceSpace(
    new XRRigidTransform({ x: 1, y: 0, z: 2 }, { x: 0, y: Math.SQRT1_2, z: 0, w: Math.SQRT1_2 }),
  );
  const ask = () =>
    frame((f, pose) => ({
      floor: point(pose.transform.position),
      local: point(f.getViewerPose(local)?.transform.position),
      localUp: up(f.getPose(local, space)?.transform.matrix),
      localForward: forward(f.getPose(local, space)?.transform.matrix),
      viewer: point(f.getViewerPose(viewer)?.transform.position),
      shifted: point(f.getViewerPose(shifted)?.transform.position),
    }));
  const before = await ask();
  emulator.setPose(lookAt([2, 1.6, 0], [2, 1.6, -1]));
  const after = await ask();
  emulator.recenter();
  const recentred = await ask();
  await stage.leave();
  await emulator.uninstall();
  return { before, after, recentred };
}

export function hits() {
  return onStage({ device: 'headset' }, { requiredFeatures: ['hit-test', 'anchors'] }, async ({ session, emulator, space, frame }) => {
    const viewer = await session.requestReferenceSpace('viewer');
    const planes = await session.requestHitTestSource?.({ space: viewer });
    const solids = await session.requestHitTestSource?.({ space: viewer, entityTypes: ['mesh'] });
    const down = new XRRay({ x: 0, y: 3, z: 1 }, { x: 0, y: -1, z: 0 });
    const straightDown = await session.requestHitTestSource?.({ space, offsetRay: down });
    if (!planes || !solids || !straightDown) throw new Error('No hit test.');
    emulator.setPose(lookAt([0, 1.6, 0], [0, 0.8, -1.8]));
    const found = await frame(async (f) => {
      const poses = (source: XRHitTestSource) => f.getHitTestResults(source).map((hit) => hit.getPose(space)?.transform);
      const anchor = f.getHitTestResults(planes)[0]?.createAnchor?.();
      return {
        planes: poses(planes).map((t) => point(t?.position)),
        normals: poses(planes).map((t) => up(t?.matrix)),
        solids: poses(solids).map((t) => point(t?.position)),
        straightDown: poses(straightDown).map((t) => point(t?.position)),
        ray: [...down.matrix],
        anchor,
      };
    });
    await frame(() => {});
    const anchor = await (await found).anchor;
    const anchored = await frame((f) => anchor && point(f.getPose(anchor.anchorSpace, space)?.transform.position));
    planes.cancel();
    const { anchor: _, ...rest } = await found;
    return { ...rest, anchored, cancelledTwice: await nameOfError(() => planes.cancel()) };
  });
}

/** What a page hears of a finger on the screen, and where its ray meets the floor. */
export function touches() {
  return onStage({ device: 'phone' }, { requiredFeatures: ['hit-test'] }, async ({ session, emulator, space, frame }) => {
    const heard: string[] = [];
    for (const type of ['selectstart', 'select', 'selectend'] as const)
      session.addEventListener(type, ({ inputSource }) => heard.push(`${type} ${inputSource.targetRayMode}`));
    session.addEventListener('inputsourceschange', ({ added, removed }) => heard.push(`+${added.length} -${removed.length}`));
    const source = await session.requestHitTestSourceForTransientInput?.({ profile: 'generic-touchscreen' });
    if (!source) throw new Error('No hit test.');
    emulator.setPose(lookAt([0, 2, 0], [0, 0, 0.0001]));
    emulator.press(0.75, 0.5);
    const hit = await frame((f, pose) => {
      const [result] = f.getHitTestResultsForTransientInput(source);
      return {
        at: point(result?.results[0]?.getPose(space)?.transform.position),
        halfWidth: 1 / (first(pose.views).projectionMatrix[0] ?? 1),
      };
    });
    emulator.release();
    await frame(() => {});
    await frame(() => {});
    return { heard, hit };
  });
}

export function controllers() {
  return onStage({ device: 'headset' }, {}, async ({ session, emulator, frame }) => {
    const heard: string[] = [];
    for (const type of ['selectstart', 'select', 'selectend'] as const)
      session.addEventListener(type, ({ inputSource }) => heard.push(`${type} ${inputSource.handedness}`));
    await frame(() => {});
    emulator.device.controllers.right?.updateButtonValue('trigger', 1);
    await frame(() => {});
    const held = [...heard];
    emulator.device.controllers.right?.updateButtonValue('trigger', 0);
    await frame(() => {});
    return { held, heard, sources: session.inputSources.length };
  });
}

export async function overlay() {
  const root = document.createElement('div');
  const button = document.createElement('button');
  root.style.background = 'red';
  button.style.width = '100%';
  button.style.height = '100%';
  root.append(button);
  document.body.append(root);
  const result = await onStage(
    { device: 'phone' },
    { requiredFeatures: ['dom-overlay'], domOverlay: { root } },
    async ({ session, emulator, frame }) => {
      const heard: string[] = [];
      session.addEventListener('selectstart', () => heard.push('selectstart'));
      const tap = async () => {
        emulator.press(0.5, 0.5);
        await frame(() => {});
        emulator.release();
        await frame(() => {});
      };
      await frame(() => {});
      const during = { background: root.style.background, position: root.style.position, state: session.domOverlayState?.type };
      await tap();
      button.addEventListener('beforexrselect', (event) => event.preventDefault());
      await tap();
      return { during, heard };
    },
  );
  const after = { background: root.style.background, position: root.style.position };
  root.remove();
  return { ...result, after };
}

/** Planes and meshes in two frames: the same objects, changed once. */
export function surfaces() {
  return onStage(
    { device: 'headset', room: 'studio' },
    { requiredFeatures: ['plane-detection', 'mesh-detection'] },
    async ({ frame, space }) => {
      const look = () =>
        frame((f) => {
          const planes = [...(f.detectedPlanes ?? [])];
          const meshes = [
            ...((f as XRFrame & { detectedMeshes?: Set<{ vertices: Float32Array; indices: Uint32Array }> }).detectedMeshes ?? []),
          ];
          return {
            planes: planes.map((plane) => ({
              plane,
              label: (plane as XRPlane & { semanticLabel: string }).semanticLabel,
              orientation: plane.orientation,
              changed: plane.lastChangedTime,
              heights: plane.polygon.map(({ x, z }) => heightOf(f.getPose(plane.planeSpace, space)?.transform.matrix, x, z)),
            })),
            meshes: meshes.map(({ vertices, indices }) => [vertices.length / 3, indices.length / 3, Math.max(...indices.slice(-300))]),
          };
        });
      const [a, b] = [await look(), await look()];
      return {
        same: a.planes.every(({ plane, changed }, i) => plane === b.planes[i]?.plane && changed === b.planes[i]?.changed),
        planes: a.planes.map(({ label, orientation, heights }) => ({ label, orientation, heights })),
        meshes: a.meshes,
      };
    },
  );
}

function heightOf(m: ArrayLike<number> | undefined, x: number, z: number): number {
  return round((m?.[1] ?? 0) * x + (m?.[9] ?? 0) * z + (m?.[13] ?? 0));
}

/** What is left of five sessions: elements, globals, objects in the page's context. */
export async function leavings() {
  const before = traces();
  const gl = createContext();
  const living = countObjects(gl);
  const emulator = installEmulator({ clock: 'manual', room: 'studio', extra: ['camera-access', 'light-estimation'], device: 'headset' });
  const counts: object[] = [];
  for (let i = 0; i < 5; i++) {
    const stage = await enterWith(
      emulator,
      { requiredFeatures: ['depth-sensing', 'camera-access'], depthSensing: { ...CPU_DEPTH, usagePreference: ['gpu-optimized'] } },
      gl,
    );
    await stage.frame((_, pose) => {
      for (const view of pose.views) {
        stage.binding.getDepthInformation(view);
        (stage.binding as unknown as { getCameraImage(camera: unknown): void }).getCameraImage(
          (view as XRView & { camera: unknown }).camera,
        );
      }
    });
    await stage.leave();
    counts.push({ ...emulator.counts(), page: living() });
  }
  const during = traces();
  await emulator.uninstall();
  return { counts, before, during, after: traces() };
}

function traces() {
  return {
    elements: document.body.querySelectorAll('*').length,
    xr: Object.prototype.toString.call(navigator.xr),
    ownXr: Object.hasOwn(navigator, 'xr'),
    ownAgent: Object.hasOwn(navigator, 'userAgent'),
    camera: 'XRCamera' in globalThis,
    probe: 'XRLightProbe' in globalThis,
    getContext: /native code/.test(String(HTMLCanvasElement.prototype.getContext)),
  };
}

/** Objects made less objects deleted, by watching the context's own methods. */
function countObjects(gl: WebGL2RenderingContext): () => number {
  let living = 0;
  for (const kind of ['Texture', 'Framebuffer', 'Renderbuffer', 'Buffer', 'Program', 'Shader', 'VertexArray'] as const) {
    const methods = gl as unknown as Record<string, (object?: unknown) => unknown>;
    const create = methods[`create${kind}`]?.bind(gl);
    const remove = methods[`delete${kind}`]?.bind(gl);
    methods[`create${kind}`] = (type) => {
      living++;
      return create?.(type);
    };
    methods[`delete${kind}`] = (object) => {
      if (object) living--;
      return remove?.(object);
    };
  }
  return () => living;
}

function point(p: DOMPointReadOnly | undefined): number[] {
  return p ? [round(p.x), round(p.y), round(p.z)] : [];
}

function up(m: ArrayLike<number> | undefined): number[] {
  return [4, 5, 6].map((i) => round(m?.[i] ?? 0));
}

function forward(m: ArrayLike<number> | undefined): number[] {
  return [8, 9, 10].map((i) => round(-(m?.[i] ?? 0)));
}

function round(x: number): number {
  return Math.round(x * 1e4) / 1e4 + 0;
}
