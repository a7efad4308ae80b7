/// <reference types="webxr" />
import { WebGLRenderer } from 'three';

/**
 * A page as an exported one is: its own three.js, a button, a strict Content Security Policy. It knows nothing of an emulator.
 */
interface Notes {
  support: boolean | null;
  withoutGesture: string | null;
  entered: boolean;
  problem: string | null;
}

declare global {
  var notes: Notes;
}

globalThis.notes = { support: null, withoutGesture: null, entered: false, problem: null };

async function request(): Promise<XRSession> {
  const { xr } = navigator;
  if (!xr) throw new Error('There is no navigator.xr.');
  return xr.requestSession('immersive-ar', { requiredFeatures: ['local-floor'] });
}

async function enter(): Promise<void> {
  const session = await request();
  const renderer = new WebGLRenderer({ antialias: false });
  const gl = renderer.getContext() as WebGL2RenderingContext;
  await gl.makeXRCompatible();
  const layer = new XRWebGLLayer(session, gl);
  session.updateRenderState({ baseLayer: layer });
  const draw = (): void => {
    session.requestAnimationFrame(draw);
    gl.bindFramebuffer(gl.FRAMEBUFFER, layer.framebuffer);
    gl.clearColor(0, 0.25, 0, 0.25);
    gl.clear(gl.COLOR_BUFFER_BIT);
  };
  session.requestAnimationFrame(draw);
  notes.entered = true;
}

async function begin(): Promise<void> {
  notes.support = (await navigator.xr?.isSessionSupported('immersive-ar')) ?? false;
  notes.withoutGesture = await request().then(
    () => 'granted',
    (error: Error) => error.name,
  );
  document.querySelector('button')?.addEventListener('click', () => {
    enter().catch((error: unknown) => {
      notes.problem = String(error);
    });
  });
  document.body.dataset.ready = 'true';
}

begin();
