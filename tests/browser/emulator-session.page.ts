/// <reference types="webxr" />
import { installEmulator } from '../../export/emulator/install-emulator.ts';
import type { EmulatorOptions } from '../../export/emulator/options.ts';
import {
  createContext,
  enterWith,
  first,
  lookAt,
  nameOfError,
  nameOfThrow,
  onStage,
  point,
  requestSession,
  TABLE_ROOM,
} from './emulator-kit.ts';

async function withDevice<T>(options: EmulatorOptions, act: () => Promise<T>): Promise<T> {
  const emulator = installEmulator({ clock: 'manual', room: TABLE_ROOM, ...options });
  try {
    return await act();
  } finally {
    await emulator.uninstall();
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
      localOnThePage: await refusal({}, 'inline'),
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
      const messages = {
        pose: await messageOf(() => old.f.getPose(space, space)),
        viewerPose: await messageOf(() => old.f.getViewerPose(space)),
        hits: await messageOf(() => source && old.f.getHitTestResults(source)),
        anchor: await messageOf(() => old.f.createAnchor?.(new XRRigidTransform(), space)),
      };
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
      return { stale, messages, within, ended };
    },
  );
}

async function messageOf(act: () => unknown): Promise<string> {
  try {
    await act();
    return '';
  } catch (error) {
    return error instanceof Error ? error.message : String(error);
  }
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
