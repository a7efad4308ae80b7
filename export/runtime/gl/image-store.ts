import type { Program } from '../../program/program.ts';
import type { GlObjects } from './gl-objects.ts';

/** Textures of the images in a program's techniques. Each is decoded once and deleted when no program holds it. */
export interface ImageStore {
  /** Holds the images of a program. `settled` never rejects; an invalid image has no texture. */
  hold(program: Program): { readonly settled: Promise<void>; release(): void };
  /** The texture of an image; null while the image is decoded, or if it is invalid. */
  texture(data: string): WebGLTexture | null;
}

interface Entry {
  holders: number;
  texture: WebGLTexture | null;
  readonly ready: Promise<void>;
}

export function createImageStore(objects: GlObjects): ImageStore {
  const entries = new Map<string, Entry>();

  function enter(data: string): Entry {
    const made: Entry = {
      holders: 0,
      texture: null,
      ready: decode(data).then(
        (levels) => {
          if (made.holders > 0 && !objects.gl.isContextLost()) made.texture = upload(objects, levels);
          for (const level of levels) level.close();
        },
        () => {},
      ),
    };
    entries.set(data, made);
    return made;
  }

  function release(data: string): void {
    const entry = entries.get(data);
    if (!entry || --entry.holders > 0) return;
    entries.delete(data);
    if (entry.texture) objects.deleteTexture(entry.texture);
  }

  return {
    hold: ({ resources }) => {
      const held = resources.flatMap((resource) =>
        resource.kind === 'technique' ? (resource.pictures ?? []).map(({ data }) => data) : [],
      );
      const ready = held.map((data) => {
        const entry = entries.get(data) ?? enter(data);
        entry.holders++;
        return entry.ready;
      });
      return {
        settled: Promise.all(ready).then(() => {}),
        release: () => {
          for (const data of held.splice(0)) release(data);
        },
      };
    },
    texture: (data) => entries.get(data)?.texture ?? null,
  };
}

/**
 * Decodes the mip levels of a texture from one PNG (base64). The levels are squares side by side, the largest first, each with half the
 * side of the previous.
 */
async function decode(data: string): Promise<readonly ImageBitmap[]> {
  const bytes = Uint8Array.from(atob(data), (letter) => letter.charCodeAt(0));
  // The values in the file are used without color conversion.
  const options = { premultiplyAlpha: 'none', colorSpaceConversion: 'none' } as const;
  const whole = await createImageBitmap(new Blob([bytes], { type: 'image/png' }), options);
  const levels: Promise<ImageBitmap>[] = [];
  for (let side = whole.height, x = 0; side >= 1 && x + side <= whole.width; x += side, side >>= 1) {
    levels.push(createImageBitmap(whole, x, 0, side, side, options));
  }
  return Promise.all(levels).finally(() => whole.close());
}

/** Uploads a repeating texture with the given mip levels; none are generated. */
function upload({ gl, createTexture }: GlObjects, levels: readonly ImageBitmap[]): WebGLTexture {
  const texture = createTexture();
  gl.activeTexture(gl.TEXTURE0);
  gl.bindTexture(gl.TEXTURE_2D, texture);
  gl.pixelStorei(gl.UNPACK_FLIP_Y_WEBGL, false);
  gl.pixelStorei(gl.UNPACK_PREMULTIPLY_ALPHA_WEBGL, false);
  gl.pixelStorei(gl.UNPACK_COLORSPACE_CONVERSION_WEBGL, gl.NONE);
  for (const [level, bitmap] of levels.entries()) gl.texImage2D(gl.TEXTURE_2D, level, gl.RGB, gl.RGB, gl.UNSIGNED_BYTE, bitmap);
  gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MAX_LEVEL, levels.length - 1);
  gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, gl.LINEAR_MIPMAP_LINEAR);
  gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MAG_FILTER, gl.LINEAR);
  const anisotropy = gl.getExtension('EXT_texture_filter_anisotropic');
  if (anisotropy) gl.texParameterf(gl.TEXTURE_2D, anisotropy.TEXTURE_MAX_ANISOTROPY_EXT, ANISOTROPY);
  return texture;
}

/**
 * Maximum anisotropy of the textures. Without it, surfaces at grazing angles would use lower mip levels, in which hatching has fewer
 * strokes and looks too bright.
 */
const ANISOTROPY = 4;
