/// <reference types="webxr" />
import { first, lookAt, nameOfError, nameOfThrow, requestSession, round } from './emulator-kit.ts';
import { type Facts, isSame, withDevice, within } from './webxr-clauses-kit.ts';

const HEADSET = { device: 'headset' } as const;

/** A context of WebGL 1 or 2 on a canvas of its own. */
function context(kind: 'webgl', attributes?: object): WebGLRenderingContext;
function context(kind: 'webgl2', attributes?: object): WebGL2RenderingContext;
function context(kind: 'webgl' | 'webgl2', attributes: object = { xrCompatible: true }): WebGLRenderingContext | WebGL2RenderingContext {
  const canvas = Object.assign(document.createElement('canvas'), { width: 40, height: 20 });
  const gl = canvas.getContext(kind, attributes) as WebGL2RenderingContext | null;
  if (!gl) throw new Error(`No ${kind} here.`);
  return gl;
}

export async function anchors(): Promise<Facts> {
  const without = await within(HEADSET, { requiredFeatures: ['hit-test'] }, async ({ session, space, frame }) => {
    const source = await session.requestHitTestSource?.({ space, offsetRay: new XRRay({ x: 0, y: 3, z: 1 }, { x: 0, y: -1, z: 0 }) });
    if (!source) throw new Error('No hit tests here.');
    const result = await frame((f) => first(f.getHitTestResults(source)));
    return nameOfError(() => result.createAnchor?.());
  });
  return within(HEADSET, { requiredFeatures: ['hit-test', 'anchors'] }, async ({ session, space, frame, emulator }) => {
    const source = await session.requestHitTestSource?.({ space, offsetRay: new XRRay({ x: 0, y: 3, z: 1 }, { x: 0, y: -1, z: 0 }) });
    if (!source) throw new Error('No hit tests here.');
    const result = await frame((f) => first(f.getHitTestResults(source)));
    const made = new Promise<XRAnchor | undefined>((resolve, reject) => {
      session.addEventListener('select', () => result.createAnchor?.()?.then(resolve, reject), { once: true });
    });
    const trigger = (value: number) => emulator.device.controllers.right?.updateButtonValue('trigger', value);
    trigger(1);
    await frame(() => {});
    trigger(0);
    await frame(() => {});
    await frame(() => {});
    const anchor = await made;
    const found = await frame((f) => {
      const { x, y, z } = (anchor && f.getPose(anchor.anchorSpace, space)?.transform.position) ?? { x: -1, y: -1, z: -1 };
      return { at: [x, y, z].map(round), tracked: anchor !== undefined && f.trackedAnchors?.has(anchor) };
    });
    await session.end();
    return { ...found, without, ended: await nameOfError(() => result.createAnchor?.()) };
  });
}

export function contexts(): Promise<Facts> {
  return withDevice(HEADSET, async () => {
    const told = (gl: WebGLRenderingContext | WebGL2RenderingContext) =>
      (gl.getContextAttributes() as (WebGLContextAttributes & { xrCompatible?: boolean }) | null)?.xrCompatible;
    const plain = context('webgl2', {});
    const before = told(plain);
    await plain.makeXRCompatible();
    const lost = context('webgl', {});
    lost.getExtension('WEBGL_lose_context')?.loseContext();
    return {
      attributes: [told(context('webgl2')), told(context('webgl')), before, told(plain)],
      lost: await nameOfError(() => lost.makeXRCompatible()),
      lostAttributes: lost.getContextAttributes() === null ? null : 'some',
    };
  });
}

export async function spaces(): Promise<Facts> {
  const found = await within(HEADSET, { requiredFeatures: ['bounded-floor'] }, async ({ session, frame, space }) => {
    const bounded = (await session.requestReferenceSpace('bounded-floor')) as XRBoundedReferenceSpace;
    const shifted = bounded.getOffsetReferenceSpace(new XRRigidTransform({ x: 1, y: 0, z: 2 })) as XRBoundedReferenceSpace;
    const corners = ({ boundsGeometry }: XRBoundedReferenceSpace) => boundsGeometry.map(({ x, y, z, w }) => [x, y, z, w].map(round));
    return {
      isBounded: bounded instanceof XRBoundedReferenceSpace && bounded instanceof XRReferenceSpace,
      corners: corners(bounded),
      shifted: corners(shifted),
      floor: await frame((f) => round(f.getPose(bounded, space)?.transform.position.y ?? -1)),
      unknown: await nameOfError(() => session.requestReferenceSpace('sideways' as XRReferenceSpaceType)),
      notGranted: await nameOfError(() => session.requestReferenceSpace('unbounded')),
    };
  });
  return withDevice(HEADSET, async () => ({
    ...found,
    phone: await withDevice({ device: 'phone' }, () => nameOfError(() => requestSession({ requiredFeatures: ['bounded-floor'] }))),
    unknownMode: await nameOfError(() => navigator.xr?.requestSession('sideways' as XRSessionMode)),
    unknownSupport: await nameOfError(() => navigator.xr?.isSessionSupported('sideways' as XRSessionMode)),
    transforms: [
      nameOfThrow(() => new XRRigidTransform({ x: 0, w: 0.5 })),
      nameOfThrow(() => new XRRigidTransform({ x: Number.NaN })),
      nameOfThrow(() => new XRRigidTransform({}, { x: 0, y: 0, z: 0, w: 0 })),
      nameOfThrow(() => new XRRigidTransform({ z: -1 }, { y: 1 })),
    ],
  }));
}

/** The layer and its viewports: what they are, and what a page that asks for less sees of it. */
export function viewports(): Promise<Facts> {
  return within(HEADSET, {}, async ({ layer, frame, gl, emulator }) => {
    const size = (view: XRView) => {
      const { x = 0, y = 0, width = 0, height = 0 } = layer.getViewport(view) ?? {};
      return [x, y, width, height];
    };
    const { view, same } = await frame((_, pose) => {
      const [left] = pose.views;
      if (!left) throw new Error('No view.');
      return { view: left, same: isSame(() => layer.getViewport(left)) };
    });
    const late = nameOfThrow(() => layer.getViewport(view));
    const scaled = await frame((_, { views }) => {
      const [left, right] = views;
      if (!left || !right) throw new Error('No two views.');
      left.requestViewportScale(0.5);
      const found = [size(left), size(right)];
      left.requestViewportScale(0.25);
      found.push(size(left));
      gl.bindFramebuffer(gl.FRAMEBUFFER, layer.framebuffer);
      gl.enable(gl.SCISSOR_TEST);
      gl.scissor(0, 0, 16, 32);
      gl.clearColor(1, 0, 0, 1);
      gl.clear(gl.COLOR_BUFFER_BIT);
      gl.disable(gl.SCISSOR_TEST);
      return found;
    });
    const { rgba, widthPx, heightPx } = emulator.readLayer();
    const reds = (from: number, to: number) => {
      let count = 0;
      for (let i = 0; i < widthPx * heightPx; i++) if (i % widthPx >= from && i % widthPx < to && rgba[i * 4] === 255) count++;
      return count;
    };
    const after = await frame((_, { views }) => {
      for (const scale of [null, 0, -1]) first(views).requestViewportScale(scale as number);
      return size(first(views));
    });
    return { same, late, scaled, shown: [reds(0, 32), reds(32, 64)], after, context: 'context' in layer };
  });
}

export function frameRates(): Promise<Facts> {
  return within(HEADSET, {}, async ({ session }) => {
    const told: string[] = [];
    session.addEventListener('frameratechange', (event) => told.push(`${event.constructor.name} ${session.frameRate}`));
    const rates = [...(session.supportedFrameRates ?? [])];
    await session.updateTargetFrameRate(72);
    await session.updateTargetFrameRate(72);
    const unknown = await nameOfError(() => session.updateTargetFrameRate(71));
    await session.end();
    return { rates, told, unknown, ended: await nameOfError(() => session.updateTargetFrameRate(90)) };
  });
}

/** A session on the page, before and beside an immersive one, as most samples have it. */
export function inline(): Promise<Facts> {
  return withDevice({ device: 'phone' }, async (emulator) => {
    const xr = navigator.xr as XRSystem;
    emulator.setPose(lookAt([1, 1.5, 2], [0, 0.5, 2]));
    const session = await xr.requestSession('inline');
    const gl = context('webgl', {});
    const layer = new XRWebGLLayer(session, gl);
    session.updateRenderState({ baseLayer: layer });
    const viewer = await session.requestReferenceSpace('viewer');
    const offset = viewer.getOffsetReferenceSpace(new XRRigidTransform({ y: -1.6 }));
    const look = () =>
      new Promise<object>((resolve) => {
        session.requestAnimationFrame((timeMs, f) => {
          const pose = f.getViewerPose(offset);
          const [view] = pose?.views ?? [];
          const viewport = view && layer.getViewport(view);
          gl.bindFramebuffer(gl.FRAMEBUFFER, layer.framebuffer);
          gl.clearColor(0, 1, 0, 1);
          gl.clear(gl.COLOR_BUFFER_BIT);
          const pixel = new Uint8Array(4);
          gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, pixel);
          resolve({
            frame: Math.round((timeMs * 60) / 1000),
            eyes: pose?.views.map(({ eye }) => eye),
            height: round(view?.transform.position.y ?? -1),
            viewport: [viewport?.x, viewport?.y, viewport?.width, viewport?.height],
            lens: [0, 5].map((i) => round(view?.projectionMatrix[i] ?? -1)),
            pixel: [...pixel],
          });
        });
      });
    const firstFrame = look();
    await emulator.stepFrame();
    const lens = nameOfThrow(() => session.updateRenderState({ inlineVerticalFieldOfView: 1 }));
    const secondFrame = look();
    await emulator.stepFrame();
    const found = {
      ways: [session.visibilityState, session.environmentBlendMode, session.interactionMode, session.inputSources.length],
      fov: session.renderState.inlineVerticalFieldOfView,
      frames: [await firstFrame, await secondFrame],
      framebuffer: layer.framebuffer,
      lens,
      local: await nameOfError(() => session.requestReferenceSpace('local')),
      required: await nameOfError(() => xr.requestSession('inline', { requiredFeatures: ['local'] })),
    };
    await session.end();
    return { ...found, ended: await nameOfError(() => emulator.stepFrame()) };
  });
}

/** A session on the page goes on while an immersive one comes and goes. */
export function inlineBesideImmersive(): Promise<Facts> {
  return withDevice({ device: 'phone' }, async (emulator) => {
    const xr = navigator.xr as XRSystem;
    const page = await xr.requestSession('inline');
    page.updateRenderState({ baseLayer: new XRWebGLLayer(page, context('webgl')) });
    const device = await xr.requestSession('immersive-ar');
    device.updateRenderState({ baseLayer: new XRWebGLLayer(device, context('webgl')) });
    const heard: string[] = [];
    const ask = () => {
      page.requestAnimationFrame(() => heard.push('page'));
      device.requestAnimationFrame(() => heard.push('device'));
    };
    ask();
    await emulator.frameRequested();
    await emulator.stepFrame();
    const both = heard.splice(0).sort();
    await device.end();
    ask();
    await emulator.stepFrame();
    return { both, alone: heard };
  });
}

/** Draws with WebGL 1, as most samples do, and returns the content of the framebuffer and the WebGL state that the device restores. */
export function webGl1(): Promise<Facts> {
  return withDevice({ device: 'phone', extra: ['camera-access'], sizePx: [50, 30] }, async (emulator) => {
    const session = await requestSession({ requiredFeatures: ['camera-access'] });
    const gl = context('webgl');
    const layer = new XRWebGLLayer(session, gl, { stencil: true });
    const binding = new XRWebGLBinding(session, gl as WebGL2RenderingContext);
    session.updateRenderState({ baseLayer: layer });
    const space = await session.requestReferenceSpace('local');
    gl.clearColor(0, 0, 0.5, 0.5);
    gl.colorMask(true, true, true, false);
    const found = new Promise<object>((resolve) => {
      session.requestAnimationFrame((_, f) => {
        const view = first(f.getViewerPose(space)?.views ?? []) as XRView & { camera: object };
        const image = (binding as unknown as { getCameraImage(camera: object): WebGLTexture }).getCameraImage(view.camera);
        gl.bindFramebuffer(gl.FRAMEBUFFER, layer.framebuffer);
        const status = gl.checkFramebufferStatus(gl.FRAMEBUFFER) === gl.FRAMEBUFFER_COMPLETE;
        const kept = [...gl.getParameter(gl.COLOR_CLEAR_VALUE), ...gl.getParameter(gl.COLOR_WRITEMASK)];
        gl.colorMask(true, true, true, true);
        gl.clear(gl.COLOR_BUFFER_BIT);
        resolve({ status, kept, camera: gl.isTexture(image), error: gl.getError() });
      });
    });
    await emulator.stepFrame();
    const { rgba, widthPx, heightPx } = emulator.readLayer();
    return { ...(await found), size: [widthPx, heightPx], pixel: [...rgba.subarray(0, 4)], antialias: layer.antialias };
  });
}
