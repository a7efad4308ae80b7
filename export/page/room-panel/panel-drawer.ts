import type { SessionFrame, ViewFrame } from '../../../nodes/kit/session.ts';
import { createGlObjects } from '../../runtime/gl/gl-objects.ts';
import { createPassDrawer } from '../../runtime/gl/pass-drawer.ts';
import { createProgramCache } from '../../runtime/gl/program-cache.ts';
import { prepareUpload } from '../../runtime/gl/upload.ts';
import { type PanelLayout, PX_PER_M } from './panel-layout.ts';
import { PANEL_SHADER } from './panel-shader.ts';
import type { Pointer } from './pointing.ts';

/** Half the width of a ray: about three pixels of a headset at 0.6 m. */
const RAY_HALF_WIDTH_M = 0.0015;
/** Start of the ray in front of the hand, at the end of the controller. */
const RAY_START_M = 0.06;

/** Draws the panel and the rays of the hands in one WebGL context. */
export interface PanelDrawer {
  /** Uploads a changed image of the panel. */
  upload(image: HTMLCanvasElement): void;
  /** Uploads changed pixels of the image, whose left upper corner is at x, y: pixels of the image from its left upper corner. */
  uploadArea(pixels: ImageData, x: number, y: number): void;
  /** Draws the panel over all views without a depth test, so that it is always legible. */
  draw(frame: SessionFrame, worldFromPanel: Float32Array, pointers: readonly Pointer[]): void;
  dispose(): void;
}

/**
 * Creates the drawer. It sets all GL state that it needs, and changes only state that the player's passes change too. The state is not
 * restored: nothing else on the page's context relies on it, and querying it would stall each frame.
 */
export function createPanelDrawer(gl: WebGL2RenderingContext, layout: PanelLayout, widthPx: number, heightPx: number): PanelDrawer {
  const objects = createGlObjects(gl);
  const programs = createProgramCache(objects);
  const shader = programs.acquire(PANEL_SHADER);
  programs.finish(shader);
  const passes = createPassDrawer(objects);
  const texture = objects.createTexture();
  gl.activeTexture(gl.TEXTURE0);
  gl.bindTexture(gl.TEXTURE_2D, texture);
  gl.texStorage2D(gl.TEXTURE_2D, 1 + Math.floor(Math.log2(Math.max(widthPx, heightPx))), gl.RGBA8, widthPx, heightPx);
  gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, gl.LINEAR_MIPMAP_LINEAR);
  gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_WRAP_S, gl.CLAMP_TO_EDGE);
  gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_WRAP_T, gl.CLAMP_TO_EDGE);
  // Keeps text sharp at grazing angles.
  const anisotropy = gl.getExtension('EXT_texture_filter_anisotropic');
  if (anisotropy) gl.texParameteri(gl.TEXTURE_2D, anisotropy.TEXTURE_MAX_ANISOTROPY_EXT, 4);
  gl.bindTexture(gl.TEXTURE_2D, null);

  const halfWidthM = layout.widthPx / 2 / PX_PER_M;
  const halfHeightM = layout.heightPx / 2 / PX_PER_M;
  const worldFromQuad = new Float32Array(16);
  const dots = new Float32Array(6);

  const begin = (frame: SessionFrame, view: ViewFrame): void => {
    const { x, y, widthPx: viewWidthPx, heightPx: viewHeightPx } = view.viewport;
    passes.begin(frame.framebuffer, x, y, viewWidthPx, viewHeightPx, 'over');
    passes.use(shader);
    gl.activeTexture(gl.TEXTURE0);
    gl.bindTexture(gl.TEXTURE_2D, texture);
    gl.bindSampler(0, null);
    gl.uniform1i(shader.uniform('picture'), 0);
    gl.uniform2f(shader.uniform('halfSizeM'), halfWidthM, halfHeightM);
    gl.uniform3fv(shader.uniform('dots'), dots);
    gl.uniformMatrix4fv(shader.uniform('clipFromView'), false, view.clipFromView);
    gl.uniformMatrix4fv(shader.uniform('viewFromWorld'), false, view.viewFromWorld);
  };
  const drawPanel = (worldFromPanel: Float32Array): void => {
    for (let row = 0; row < 4; row++) {
      worldFromQuad[row] = (worldFromPanel[row] ?? 0) * halfWidthM;
      worldFromQuad[4 + row] = (worldFromPanel[4 + row] ?? 0) * halfHeightM;
      worldFromQuad[8 + row] = worldFromPanel[8 + row] ?? 0;
      worldFromQuad[12 + row] = worldFromPanel[12 + row] ?? 0;
    }
    gl.uniformMatrix4fv(shader.uniform('worldFromQuad'), false, worldFromQuad);
    gl.uniform1i(shader.uniform('isRay'), 0);
    gl.drawArrays(gl.TRIANGLE_STRIP, 0, 4);
  };
  const drawRay = (view: ViewFrame, worldFromRay: Float32Array, lengthM: number): void => {
    if (lengthM <= RAY_START_M || !setRay(worldFromQuad, worldFromRay, lengthM, view.worldFromView)) return;
    gl.uniformMatrix4fv(shader.uniform('worldFromQuad'), false, worldFromQuad);
    gl.uniform1i(shader.uniform('isRay'), 1);
    gl.drawArrays(gl.TRIANGLE_STRIP, 0, 4);
  };
  /** x, y: pixels of the texture, from its left lower corner. */
  const uploadAt = (pixels: HTMLCanvasElement | ImageData, x: number, y: number): void => {
    prepareUpload(gl, 4);
    gl.pixelStorei(gl.UNPACK_FLIP_Y_WEBGL, true);
    gl.pixelStorei(gl.UNPACK_PREMULTIPLY_ALPHA_WEBGL, true);
    gl.activeTexture(gl.TEXTURE0);
    gl.bindTexture(gl.TEXTURE_2D, texture);
    gl.texSubImage2D(gl.TEXTURE_2D, 0, x, y, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
    gl.generateMipmap(gl.TEXTURE_2D);
    gl.bindTexture(gl.TEXTURE_2D, null);
    gl.pixelStorei(gl.UNPACK_FLIP_Y_WEBGL, false);
    gl.pixelStorei(gl.UNPACK_PREMULTIPLY_ALPHA_WEBGL, false);
  };
  return {
    upload: (image) => uploadAt(image, 0, 0),
    uploadArea: (pixels, x, y) => uploadAt(pixels, x, heightPx - y - pixels.height),
    draw: (frame, worldFromPanel, pointers) => {
      for (let i = 0; i < 2; i++) {
        const pointer = pointers[i];
        dots[3 * i] = ((pointer?.hit.x ?? 0) - layout.widthPx / 2) / PX_PER_M;
        dots[3 * i + 1] = (layout.heightPx / 2 - (pointer?.hit.y ?? 0)) / PX_PER_M;
        dots[3 * i + 2] = pointer?.pointing ? (pointer.held >= 0 ? 2 : 1) : 0;
      }
      for (let i = 0; i < frame.viewCount; i++) {
        const view = frame.views[i];
        if (!view || shader.state !== 'linked') continue;
        begin(frame, view);
        drawPanel(worldFromPanel);
        for (const { by, pointing, hit } of pointers) {
          const ray = frame.input[by].worldFromRay;
          if (pointing && ray) drawRay(view, ray, hit.distanceM);
        }
      }
      gl.bindTexture(gl.TEXTURE_2D, null);
      passes.end();
    },
    dispose: () => {
      objects.deleteTexture(texture);
      passes.dispose();
      programs.dispose();
    },
  };
}

/** Writes the corners of a strip along the ray, which faces the eye. Returns false if the eye looks along the ray. */
function setRay(out: Float32Array, ray: Float32Array, lengthM: number, eye: Float32Array): boolean {
  const half = (lengthM - RAY_START_M) / 2;
  const middle = RAY_START_M + half;
  for (let row = 0; row < 3; row++) {
    const along = -(ray[8 + row] ?? 0);
    out[4 + row] = along * half;
    out[8 + row] = (eye[12 + row] ?? 0) - (ray[12 + row] ?? 0);
    out[12 + row] = (ray[12 + row] ?? 0) + along * middle;
  }
  let squared = 0;
  for (let row = 0; row < 3; row++) {
    const b = 4 + ((row + 1) % 3);
    const c = 4 + ((row + 2) % 3);
    const side = (out[b] ?? 0) * (out[c + 4] ?? 0) - (out[c] ?? 0) * (out[b + 4] ?? 0);
    out[row] = side;
    squared += side * side;
  }
  const scale = RAY_HALF_WIDTH_M / Math.sqrt(squared);
  for (let row = 0; row < 3; row++) out[row] = (out[row] ?? 0) * scale;
  out[3] = 0;
  out[7] = 0;
  out[11] = 0;
  out[15] = 1;
  return squared > 1e-12;
}
