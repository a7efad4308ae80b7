/// <reference types="webxr" />
import { createContext, enterWith, first, lookAt, nameOfError, nameOfThrow, round } from './emulator-kit.ts';
import { type Facts, isSame, withDevice, within } from './webxr-clauses-kit.ts';

export { cpuDepth, depthConfiguration, gpuDepth, ownDepthCamera } from './webxr-clauses-depth.ts';

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
        return { frame, plane, up: [4, 5, 6].map((i) => round(m[i] ?? 0)), centre: [12, 13, 14].map((i) => round(m[i] ?? 0)) };
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
      centre: now.centre,
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
    // Moved half a metre up before the page is asked again: what it finds is of this frame.
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
