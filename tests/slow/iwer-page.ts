import { readFile } from 'node:fs/promises';
import { resolve } from 'node:path';
import { build } from 'esbuild';
import type { XRDevice } from 'iwer';
import type { Browser, Page } from 'playwright-core';
import { collectErrors, drawPageSeldom } from '../support/browser.ts';
import { fromGl, type RgbaImage } from '../support/image.ts';

const ROOT = resolve(import.meta.dirname, '../..');

/** What iwer tells the page of one eye. Depth: meters, row by row from the top, as `getDepthInformation` gives it; null: none. */
export interface IwerView {
  readonly viewport: { readonly x: number; readonly y: number; readonly width: number; readonly height: number };
  readonly clipFromView: readonly number[];
  readonly worldFromView: readonly number[];
  readonly depth: { readonly width: number; readonly height: number; readonly meters: readonly number[] } | null;
}

export interface IwerFrame {
  /** What the page drew, premultiplied. */
  readonly layer: RgbaImage;
  readonly views: readonly IwerView[];
}

/** A page in plain iwer with its own rooms: nothing of either is changed. */
export interface IwerPage {
  readonly page: Page;
  readonly errors: readonly string[];
  /** Once frames of the session are drawn. */
  nextFrame(): Promise<IwerFrame>;
  close(): Promise<void>;
}

export interface IwerOptions {
  /** Name of a capture of `@iwer/sem`; null: no room. */
  readonly room: string | null;
  readonly mode: 'immersive-ar' | 'immersive-vr';
  readonly position: readonly [number, number, number];
  readonly quaternion: readonly [number, number, number, number];
}

interface TestIwer {
  readonly device: XRDevice;
  readonly sessions: XRSession[];
}

declare global {
  var testIwer: TestIwer | undefined;
}

/** Between frames of the page and of its session, of which a test looks at one. */
const FRAME_MS = 400;

let injected: Promise<string> | undefined;

/** Puts a Quest 3 of two eyes into the page before the page's own scripts. */
export async function openIwerPage(
  browser: Browser,
  url: string,
  options: IwerOptions,
  viewport: { readonly width: number; readonly height: number },
): Promise<IwerPage> {
  const room = options.room && JSON.parse(await readFile(resolve(ROOT, `node_modules/@iwer/sem/captures/${options.room}.json`), 'utf8'));
  injected ??= bundleIwer();
  const context = await browser.newContext({ viewport });
  const page = await context.newPage();
  const errors = collectErrors(page);
  await drawPageSeldom(page, FRAME_MS);
  await page.addInitScript({ content: `globalThis.testIwerOptions = ${JSON.stringify({ ...options, room })};\n${await injected}` });
  await page.goto(url);
  return { page, errors, nextFrame: () => readFrame(page), close: () => context.close() };
}

async function bundleIwer(): Promise<string> {
  const { outputFiles } = await build({
    stdin: { contents: ENTRY, resolveDir: ROOT, loader: 'js' },
    bundle: true,
    write: false,
    format: 'iife',
    target: 'chrome108',
    minify: true,
    logLevel: 'silent',
  });
  return outputFiles[0]?.text ?? '';
}

const ENTRY = `
import { metaQuest3, XRDevice } from 'iwer';
import { SyntheticEnvironmentModule } from '@iwer/sem';
const { room, mode, position, quaternion } = globalThis.testIwerOptions;
const device = new XRDevice({ ...metaQuest3, supportedSessionModes: ['inline', mode] }, { stereoEnabled: true });
device.installRuntime({ forceInstall: true });
device.installSEM(SyntheticEnvironmentModule);
if (room) device.sem.loadEnvironment(room);
device.position.set(...position);
device.quaternion.set(...quaternion);
const sessions = [];
const request = navigator.xr.requestSession;
navigator.xr.requestSession = async (...given) => {
  const session = await request.apply(navigator.xr, given);
  sessions.push(session);
  return session;
};
globalThis.testIwer = { device, sessions };
// The page's own three.js is not the room's.
Reflect.deleteProperty(globalThis, '__THREE__');
`;

/** Reads after the page has drawn: callbacks run in the order in which they were asked for. */
async function readFrame(page: Page): Promise<IwerFrame> {
  await page.waitForFunction(() => testIwer?.sessions.at(-1)?.renderState.baseLayer, null, { polling: 100 });
  const { width, height, base64, views } = await page.evaluate(async () => {
    const session = testIwer?.sessions.at(-1);
    if (!session) throw new Error('There is no session.');
    const space = await session.requestReferenceSpace('local-floor');
    const frame = () =>
      new Promise<{ frame: XRFrame; pose: XRViewerPose }>((resolve, reject) => {
        session.requestAnimationFrame((_time, xrFrame) => {
          const pose = xrFrame.getViewerPose(space);
          if (pose) resolve(read(xrFrame, pose) as never);
          else reject(new Error('There is no pose.'));
        });
      });
    const read = (xrFrame: XRFrame, pose: XRViewerPose) => {
      const layer = session.renderState.baseLayer as XRWebGLLayer;
      const canvas = document.querySelector<HTMLCanvasElement>('[data-webxr_runtime] canvas[role="img"]');
      const gl = canvas?.getContext('webgl2');
      if (!canvas || !gl) throw new Error('iwer does not show the canvas.');
      const rgba = new Uint8Array(canvas.width * canvas.height * 4);
      gl.bindFramebuffer(gl.FRAMEBUFFER, null);
      gl.readPixels(0, 0, canvas.width, canvas.height, gl.RGBA, gl.UNSIGNED_BYTE, rgba);
      let text = '';
      for (let i = 0; i < rgba.length; i += 8192) text += String.fromCharCode(...rgba.subarray(i, i + 8192));
      const told = pose.views.map((view) => {
        const { x = 0, y = 0, width = 0, height = 0 } = layer.getViewport(view) ?? {};
        const hasDepth = session.enabledFeatures?.includes('depth-sensing');
        const info = hasDepth ? (xrFrame.getDepthInformation(view) as XRCPUDepthInformation | null) : null;
        const meters = info && [...new Float32Array(info.data)].map((raw) => raw * info.rawValueToMeters);
        return {
          viewport: { x, y, width, height },
          clipFromView: [...view.projectionMatrix],
          worldFromView: [...view.transform.matrix],
          depth: info && meters && { width: info.width, height: info.height, meters },
        };
      });
      return { width: canvas.width, height: canvas.height, base64: btoa(text), views: told };
    };
    // What comes with the first frames, such as depth, is there.
    for (let i = 0; i < 4; i++) await frame();
    return (await frame()) as unknown as ReturnType<typeof read>;
  });
  return { layer: fromGl(width, height, Buffer.from(base64, 'base64')), views };
}
