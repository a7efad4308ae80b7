/// <reference types="webxr" />
import type { DepthUsage } from '../../export/emulator/profiles.ts';
import { createContext, enterWith, first, lookAt, nameOfError, nameOfThrow, round } from './emulator-kit.ts';
import { type Facts, isSame, withDevice, within } from './webxr-clauses-kit.ts';

/** Parts of the modules that @types/webxr does not know. */
type Probe = EventTarget & { readonly probeSpace: XRSpace };
type LitSession = XRSession & {
  requestLightProbe(init?: { reflectionFormat: string }): Promise<Probe>;
  readonly preferredReflectionFormat: string;
};
type Estimate = {
  readonly sphericalHarmonicsCoefficients: Float32Array;
  readonly primaryLightDirection: DOMPointReadOnly;
  readonly primaryLightIntensity: DOMPointReadOnly;
};
type LitFrame = XRFrame & { getLightEstimate(probe: Probe): Estimate | null };
type LitBinding = XRWebGLBinding & { getReflectionCubeMap(probe: Probe): WebGLTexture | null };
type SeeingView = XRView & { readonly camera: { readonly width: number; readonly height: number } | null };
type SeeingBinding = XRWebGLBinding & { getCameraImage(camera: object | null): WebGLTexture | null };

function wishes(usages: DepthUsage[], formats: XRDepthDataFormat[], more: Partial<XRDepthStateInit> = {}): XRSessionInit {
  return { requiredFeatures: ['depth-sensing'], depthSensing: { usagePreference: usages, dataFormatPreference: formats, ...more } };
}

const CPU = wishes(['cpu-optimized'], ['luminance-alpha']);

/** What of it a device was granted, or the name of its refusal. */
async function granted(init: XRSessionInit): Promise<unknown> {
  try {
    const session = await navigator.xr?.requestSession('immersive-ar', init);
    if (!session) return 'no session';
    const found = session.enabledFeatures?.includes('depth-sensing') ? [session.depthUsage, session.depthDataFormat] : 'without depth';
    await session.end();
    return found;
  } catch (error) {
    return error instanceof DOMException ? error.name : String(error);
  }
}

export function depthConfiguration(): Promise<Facts> {
  const optional = (init: XRSessionInit): XRSessionInit => ({
    optionalFeatures: ['depth-sensing'],
    ...(init.depthSensing && { depthSensing: init.depthSensing }),
  });
  return withDevice({ device: 'headset' }, async (emulator) => {
    const impossible = wishes(['cpu-optimized'], ['no-such-format' as XRDepthDataFormat]);
    const facts = {
      requiredWithoutWishes: await granted({ requiredFeatures: ['depth-sensing'] }),
      optionalWithoutWishes: await granted({ optionalFeatures: ['depth-sensing'] }),
      requiredImpossible: await granted(impossible),
      optionalImpossible: await granted(optional(impossible)),
      single: await granted(wishes(['cpu-optimized'], ['float32'])),
      several: await granted(
        wishes(['cpu-optimized', 'gpu-optimized'], ['no-such-format' as XRDepthDataFormat, 'float32', 'unsigned-short']),
      ),
      none: await granted(wishes([], [])),
      always: await granted(wishes([], ['luminance-alpha'])),
      typeIgnored: await granted(wishes([], [], { depthTypeRequest: ['smooth'] })),
    };
    const stage = await enterWith(emulator, {});
    const { session } = stage;
    const absent = [
      nameOfThrow(() => session.depthUsage),
      nameOfThrow(() => session.depthDataFormat),
      nameOfThrow(() => session.depthType),
      nameOfThrow(() => session.depthActive),
      nameOfThrow(() => session.pauseDepthSensing?.()),
    ];
    await stage.leave();
    return { ...facts, absent };
  });
}

export function cpuDepth(): Promise<Facts> {
  return within({ depth: { sizePx: [30, 20] } }, CPU, async (stage) => {
    const { session, emulator, binding } = stage;
    emulator.setPose(lookAt([0, 1.5, 0], [0, 0, -0.8]));
    const depthOf = (frame: XRFrame, view: XRView) => frame.getDepthInformation?.(view) ?? null;
    const old = await stage.frame((frame, pose) => {
      const view = first(pose.views);
      return { frame, view, depth: depthOf(frame, view) };
    });
    const facts = await stage.frame((frame, pose) => {
      const view = first(pose.views);
      const depth = depthOf(frame, view);
      if (!depth) throw new Error('No depth.');
      const raw = new Uint16Array(depth.data);
      const at = (column: number, row: number) => (raw[row * depth.width + column] ?? 0) * depth.rawValueToMeters;
      return {
        size: [depth.width, depth.height, depth.data.byteLength],
        sameObjects: isSame(() => depth.data) && isSame(() => depth.normDepthBufferFromNormView),
        // Looking down, the table before the feet is farther than the floor at them.
        looksUpwards: depth.getDepthInMeters(0.5, 0.02) > depth.getDepthInMeters(0.5, 0.98),
        indexed: [depth.getDepthInMeters(0.26, 0.51) - at(7, 10), depth.getDepthInMeters(0.999, 0.001) - at(29, 0)],
        clamped: depth.getDepthInMeters(1, 1) - at(29, 19),
        outside: [
          nameOfThrow(() => depth.getDepthInMeters(1.001, 0)),
          nameOfThrow(() => depth.getDepthInMeters(0, -0.001)),
          nameOfThrow(() => depth.getDepthInMeters(Number.NaN, 0)),
        ],
        foreignView: nameOfThrow(() => depthOf(frame, old.view)),
        onGpu: nameOfThrow(() => binding.getDepthInformation(view)),
        // Where it was measured from: the view, for this is the default of matchDepthView.
        matched: String([...(depth.transform?.matrix ?? [])]) === String([...view.transform.matrix]),
        matchedLens: String([...(depth.projectionMatrix ?? [])]) === String([...view.projectionMatrix]),
      };
    });
    const late = {
      frame: nameOfThrow(() => depthOf(old.frame, old.view)),
      data: nameOfThrow(() => old.depth?.data),
      value: nameOfThrow(() => old.depth?.getDepthInMeters(0.5, 0.5)),
    };
    session.pauseDepthSensing?.();
    const paused = await stage.frame((frame, pose) => [session.depthActive, depthOf(frame, first(pose.views))]);
    session.resumeDepthSensing?.();
    const resumed = await stage.frame((frame, pose) => [session.depthActive, depthOf(frame, first(pose.views)) !== null]);
    emulator.setDepth('stopped');
    const stopped = await stage.frame((frame, pose) => depthOf(frame, first(pose.views)));
    return {
      ...facts,
      late: Object.values(late),
      paused,
      resumed,
      stopped,
      attributes: [session.depthUsage, session.depthDataFormat, session.depthType],
    };
  });
}

export async function gpuDepth(): Promise<Facts> {
  const one = await within({}, wishes(['gpu-optimized'], ['luminance-alpha']), (stage) =>
    stage.frame((_, pose) => {
      const depth = stage.binding.getDepthInformation(first(pose.views));
      return [depth?.textureType, depth?.imageIndex, stage.gl.isTexture(depth?.texture ?? null)];
    }),
  );
  return within({ device: 'headset' }, wishes(['gpu-optimized'], ['unsigned-short']), async (stage) => {
    const { binding, session } = stage;
    const old = await stage.frame((_, pose) => {
      const view = first(pose.views);
      return { view, depth: binding.getDepthInformation(view) };
    });
    const facts = await stage.frame((frame, pose) => {
      const depths = pose.views.map((view) => binding.getDepthInformation(view));
      return {
        two: depths.map((depth) => [depth?.textureType, depth?.imageIndex]),
        shared: depths[0]?.texture === depths[1]?.texture,
        onCpu: nameOfThrow(() => frame.getDepthInformation?.(first(pose.views))),
      };
    });
    return {
      one,
      ...facts,
      late: [nameOfThrow(() => binding.getDepthInformation(old.view)), nameOfThrow(() => old.depth?.texture)],
      usage: session.depthUsage,
    };
  });
}

/** A buffer with a camera of its own, two frames late; both as the page is told. */
export function ownDepthCamera(): Promise<Facts> {
  const depth = { sizePx: [40, 30], sensor: { positionM: [0.05, 0, 0], fovYRad: 1.4 }, lagFrames: 2 } as const;
  return within({ depth }, wishes(['cpu-optimized'], ['luminance-alpha'], { matchDepthView: false }), async (stage) => {
    const told: { from: number[]; lens: number; middle: number }[] = [];
    for (const z of [0, 0.5, 1, 1.5]) {
      stage.emulator.setPose(lookAt([0, 0.4, z], [0, 0.4, -9]));
      told.push(
        await stage.frame((frame, pose) => {
          const info = frame.getDepthInformation?.(first(pose.views));
          const { x = 0, y = 0, z: back = 0 } = info?.transform?.position ?? {};
          return {
            from: [round(x), round(y), round(back)],
            lens: info?.projectionMatrix?.[5] ?? 0,
            middle: round(info?.getDepthInMeters(0.5, 0.5) ?? 0),
          };
        }),
      );
    }
    return { told };
  });
}

export function light(): Promise<Facts> {
  return withDevice({}, async (emulator) => {
    const plain = await enterWith(emulator, {});
    const without = await nameOfError(() => (plain.session as LitSession).requestLightProbe());
    await plain.leave();

    const former = await enterWith(emulator, { requiredFeatures: ['light-estimation'] });
    const foreign = await (former.session as LitSession).requestLightProbe();
    await former.leave();
    const ended = await nameOfError(() => (former.session as LitSession).requestLightProbe());
    const cubeOfEnded = nameOfThrow(() => (former.binding as LitBinding).getReflectionCubeMap(foreign));

    const stage = await enterWith(emulator, { requiredFeatures: ['light-estimation'] });
    const session = stage.session as LitSession;
    const binding = stage.binding as LitBinding;
    const probe = await session.requestLightProbe();
    const bright = await session.requestLightProbe({ reflectionFormat: session.preferredReflectionFormat });
    const otherFormat = await nameOfError(() => session.requestLightProbe({ reflectionFormat: 'rgb9e5' }));
    const heard: string[] = [];
    probe.addEventListener('reflectionchange', (event) => heard.push(event.constructor.name));
    const ask = () =>
      stage.frame((frame) => {
        const estimate = (frame as LitFrame).getLightEstimate(probe);
        const { x = 0, y = 0, z = 0, w = 1 } = estimate?.primaryLightDirection ?? {};
        const { x: r = 0, y: g = 0, z: b = 0, w: a = 0 } = estimate?.primaryLightIntensity ?? {};
        return (
          estimate && {
            coefficients: estimate.sphericalHarmonicsCoefficients.length,
            ambient: estimate.sphericalHarmonicsCoefficients[0],
            direction: [x, y, z, w],
            intensity: [r, g, b, a],
          }
        );
      });
    const estimate = await ask();
    const frames = await stage.frame((frame) => ({
      old: frame as LitFrame,
      foreign: nameOfThrow(() => (frame as LitFrame).getLightEstimate(foreign)),
    }));
    const formats = [cubeFormat(stage.gl, binding.getReflectionCubeMap(probe)), cubeFormat(stage.gl, binding.getReflectionCubeMap(bright))];
    const anew = !isSame(() => binding.getReflectionCubeMap(probe));
    const heardFirst = heard.length;
    emulator.setLight({ directionWorld: null, intensity: null });
    const undirected = await ask();
    emulator.setLight({ reflection: Array.from({ length: 6 }, () => [1, 0, 0] as const) });
    await ask();
    const heardThen = heard.length;
    emulator.setLight({ reflection: null });
    await ask();
    const noCube = binding.getReflectionCubeMap(probe);
    emulator.setLight('stopped');
    const none = await ask();
    const lost = createContext();
    const lostBinding = new XRWebGLBinding(session, lost) as LitBinding;
    lost.getExtension('WEBGL_lose_context')?.loseContext();
    const facts = {
      without,
      ended,
      cubeOfEnded,
      otherFormat,
      space: probe.probeSpace instanceof XRSpace,
      handler: 'onreflectionchange' in probe,
      estimate,
      late: nameOfThrow(() => frames.old.getLightEstimate(probe)),
      foreign: frames.foreign,
      formats,
      anew,
      heard: [heardFirst, heardThen, heard[0]],
      undirected,
      noCube,
      none,
      cubeOfForeign: nameOfThrow(() => binding.getReflectionCubeMap(foreign)),
      cubeOfLost: nameOfThrow(() => lostBinding.getReflectionCubeMap(probe)),
    };
    await stage.leave();
    return facts;
  });
}

/** How GL stores a face, told by a framebuffer that it is attached to. */
function cubeFormat(gl: WebGL2RenderingContext, texture: WebGLTexture | null): string {
  const framebuffer = gl.createFramebuffer();
  gl.bindFramebuffer(gl.FRAMEBUFFER, framebuffer);
  gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_CUBE_MAP_POSITIVE_X, texture, 0);
  const ask = (name: number) => gl.getFramebufferAttachmentParameter(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, name) as number;
  const encoding = ask(gl.FRAMEBUFFER_ATTACHMENT_COLOR_ENCODING) === gl.SRGB ? 'srgb' : 'linear';
  const bits = ask(gl.FRAMEBUFFER_ATTACHMENT_RED_SIZE);
  gl.deleteFramebuffer(framebuffer);
  return `${encoding} ${bits}`;
}

export async function camera(): Promise<Facts> {
  const without = await within({}, {}, (stage) => stage.frame((_, pose) => (first(pose.views) as SeeingView).camera));
  return within({ sizePx: [80, 60] }, { requiredFeatures: ['camera-access'] }, async (stage) => {
    const binding = stage.binding as SeeingBinding;
    const old = await stage.frame((_, pose) => {
      const [view, unasked] = [first(pose.views) as SeeingView, first(pose.views) as SeeingView];
      return { view, unasked, camera: view.camera };
    });
    const facts = await stage.frame((_, pose) => {
      const view = first(pose.views) as SeeingView;
      const texture = binding.getCameraImage(view.camera);
      return {
        size: [view.camera?.width, view.camera?.height],
        same: isSame(() => view.camera),
        texture: stage.gl.isTexture(texture),
        cached: binding.getCameraImage(view.camera) === texture,
        alpha: alphaOf(stage.gl, texture),
      };
    });
    return { without, ...facts, late: [nameOfThrow(() => old.view.camera), nameOfThrow(() => binding.getCameraImage(old.camera))] };
  });
}

function alphaOf(gl: WebGL2RenderingContext, texture: WebGLTexture | null): number {
  const framebuffer = gl.createFramebuffer();
  gl.bindFramebuffer(gl.FRAMEBUFFER, framebuffer);
  gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D, texture, 0);
  const pixel = new Uint8Array(4);
  gl.readPixels(5, 5, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, pixel);
  gl.deleteFramebuffer(framebuffer);
  return pixel[3] ?? 0;
}

export async function planes(): Promise<Facts> {
  const without = await within({}, {}, (stage) => stage.frame((frame) => frame.detectedPlanes?.size));
  return within({}, { requiredFeatures: ['plane-detection'] }, async (stage) => {
    const look = () =>
      stage.frame((frame) => {
        const [plane] = [...(frame.detectedPlanes ?? [])].filter(({ semanticLabel }) => semanticLabel === 'table');
        if (!plane) throw new Error('The table is missing.');
        const m = frame.getPose(plane.planeSpace, stage.space)?.transform.matrix ?? new Float32Array(16);
        return { frame, plane, up: [4, 5, 6].map((i) => round(m[i] ?? 0)), center: [12, 13, 14].map((i) => round(m[i] ?? 0)) };
      });
    const old = await look();
    const now = await look();
    const { plane } = now;
    return {
      without,
      same: old.plane === plane && old.plane.planeSpace === plane.planeSpace,
      unchanged: plane.lastChangedTime,
      orientation: plane.orientation,
      up: now.up,
      center: now.center,
      polygon: plane.polygon.map(({ x, y, z }) => [round(x), round(y), round(z)]),
      late: nameOfThrow(() => old.frame.detectedPlanes),
    };
  });
}

export async function hitTest(): Promise<Facts> {
  const without = await within({}, {}, ({ session, space }) => nameOfError(() => session.requestHitTestSource?.({ space })));
  const rays = {
    noDirection: nameOfThrow(() => new XRRay({ x: 0 }, { x: 0, y: 0, z: 0 })),
    directionW: nameOfThrow(() => new XRRay({}, { x: 0, y: 0, z: -1, w: 1 })),
    originW: nameOfThrow(() => new XRRay({ w: 0 }, { x: 0, y: 0, z: -1 })),
  };
  return withDevice({}, async (emulator) => {
    const plainRay = new XRRay();
    const stage = await enterWith(emulator, { requiredFeatures: ['hit-test'] });
    const { session } = stage;
    const viewer = await session.requestReferenceSpace('viewer');
    const noSpace = await nameOfError(() => session.requestHitTestSource?.({} as XRHitTestOptionsInit));
    const source = await session.requestHitTestSource?.({ space: viewer });
    if (!source) throw new Error('No hit tests here.');
    emulator.setPose(lookAt([0, 1.6, 0], [0, 0.8, -1.8]));
    const old = await stage.frame((frame) => ({ frame, results: frame.getHitTestResults(source) }));
    // Moved half a meter up before the page is asked again: what it finds is of this frame.
    emulator.setPose(lookAt([0, 2.1, 0], [0, 0.8, -1.8]));
    const places = await stage.frame((frame) =>
      frame.getHitTestResults(source).map((result) => {
        const pose = result.getPose(stage.space);
        const m = pose?.transform.matrix ?? new Float32Array(16);
        return { at: [12, 13, 14].map((i) => round(m[i] ?? 0)), up: [4, 5, 6].map((i) => round(m[i] ?? 0)) };
      }),
    );
    const late = nameOfThrow(() => old.frame.getHitTestResults(source));
    source.cancel();
    const cancelled = nameOfThrow(() => source.cancel());
    const afterCancel = await stage.frame((frame) => nameOfThrow(() => frame.getHitTestResults(source)));
    await stage.leave();
    return {
      without,
      noSpace,
      places,
      late,
      cancelled,
      afterCancel,
      ended: await nameOfError(() => session.requestHitTestSource?.({ space: viewer })),
      rays: Object.values(rays),
      plainRay: [plainRay.origin, plainRay.direction].map(({ x, y, z, w }) => [x, y, z, w]),
    };
  });
}

/** What a page can tell of the device's display. */
export async function displays(): Promise<Facts> {
  const of = (device: 'phone' | 'headset' | 'glasses') =>
    within({ device }, {}, async (stage) => [
      stage.session.environmentBlendMode,
      stage.session.interactionMode,
      await stage.frame((_, pose) => pose.views.map(({ eye }) => eye)),
    ]);
  return { phone: await of('phone'), headset: await of('headset'), glasses: await of('glasses') };
}
