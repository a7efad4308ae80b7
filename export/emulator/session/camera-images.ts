import { type Gl, isWebGl2 } from '../display/app-gl.ts';
import type { RoomView } from '../display/room-view.ts';
import { P_EYE } from '../private.ts';
import type { EmulatedView } from './emulated-view.ts';

/** Camera images in a page's context: one texture per view, updated once per frame from the room's canvas. */
export class CameraImages {
  readonly #gl: Gl;
  readonly #textures = new Map<
    number,
    { readonly texture: WebGLTexture; readonly widthPx: number; readonly heightPx: number; of: object }
  >();

  constructor(gl: Gl) {
    this.#gl = gl;
  }

  update(room: RoomView, view: EmulatedView): WebGLTexture {
    const gl = this.#gl;
    const { eye, index, frame } = view[P_EYE];
    const { x, widthPx, heightPx } = eye.viewport;
    const known = this.#textures.get(index);
    if (known?.of === frame) return known.texture;
    const fits = known && known.widthPx === widthPx && known.heightPx === heightPx;
    if (known && !fits) gl.deleteTexture(known.texture);
    const texture = fits ? known.texture : this.#create(widthPx, heightPx);
    this.#textures.set(index, { texture, widthPx, heightPx, of: frame });
    const canvas = room.image();
    gl.bindTexture(gl.TEXTURE_2D, texture);
    gl.pixelStorei(gl.UNPACK_FLIP_Y_WEBGL, 1);
    // Views are side by side and have the height of the canvas, so only columns are skipped.
    if (isWebGl2(gl)) {
      gl.pixelStorei(gl.UNPACK_SKIP_PIXELS, x);
      gl.texSubImage2D(gl.TEXTURE_2D, 0, 0, 0, widthPx, heightPx, gl.RGBA, gl.UNSIGNED_BYTE, canvas);
    } else gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA, gl.RGBA, gl.UNSIGNED_BYTE, cutOut(canvas, x, widthPx, heightPx));
    return texture;
  }

  dispose(): void {
    for (const { texture } of this.#textures.values()) this.#gl.deleteTexture(texture);
    this.#textures.clear();
  }

  #create(widthPx: number, heightPx: number): WebGLTexture {
    const gl = this.#gl;
    const texture = gl.createTexture();
    gl.bindTexture(gl.TEXTURE_2D, texture);
    if (isWebGl2(gl)) gl.texStorage2D(gl.TEXTURE_2D, 1, gl.RGBA8, widthPx, heightPx);
    for (const name of [gl.TEXTURE_MIN_FILTER, gl.TEXTURE_MAG_FILTER]) gl.texParameteri(gl.TEXTURE_2D, name, gl.LINEAR);
    for (const name of [gl.TEXTURE_WRAP_S, gl.TEXTURE_WRAP_T]) gl.texParameteri(gl.TEXTURE_2D, name, gl.CLAMP_TO_EDGE);
    return texture;
  }
}

/** Copies columns to another canvas, because WebGL 1 cannot skip them during upload. */
function cutOut(canvas: HTMLCanvasElement, x: number, widthPx: number, heightPx: number): TexImageSource {
  if (widthPx === canvas.width) return canvas;
  const part = new OffscreenCanvas(widthPx, heightPx);
  part.getContext('2d')?.drawImage(canvas, -x, 0);
  return part;
}
