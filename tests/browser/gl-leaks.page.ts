import { trackGl } from '../support/gl-leaks.ts';

/** Makes some objects, deletes some, and tells what the tracker saw of it. */
export function makeAndForget(): { alive: Record<string, number>; report: readonly string[]; after: Record<string, number> } {
  const gl = document.createElement('canvas').getContext('webgl2');
  if (!gl) throw new Error('no WebGL 2');
  const leaks = trackGl(gl);
  const kept = gl.createTexture();
  for (let i = 0; i < 3; i++) forgetBuffer(gl);
  gl.deleteBuffer(gl.createBuffer());
  gl.deleteBuffer(null);
  gl.deleteSync(gl.fenceSync(gl.SYNC_GPU_COMMANDS_COMPLETE, 0));
  const alive = { ...leaks.alive() };
  const report = leaks.report();
  gl.deleteTexture(kept);
  leaks.stop();
  gl.createFramebuffer();
  return { alive, report, after: { ...leaks.alive() } };
}

function forgetBuffer(gl: WebGL2RenderingContext): void {
  gl.createBuffer();
}
