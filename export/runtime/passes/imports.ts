import type { AssetHandle, ImageAsset } from '../../../nodes/kit/assets.ts';
import type { PassOperation, Program } from '../../program/program.ts';
import type { Engine } from '../engine.ts';
import type { GlObjects } from '../gl/gl-objects.ts';

/** An image or a cube map that a shader imports. */
export interface ImportedImage {
  /** The texture; null until it is loaded completely, or if the image is invalid. */
  readonly texture: WebGLTexture | null;
  readonly widthPx: number;
  readonly heightPx: number;
  readonly cube: boolean;
}

/** The imports of one program. */
export interface Imports {
  find(assets: readonly string[], cube: boolean): ImportedImage;
  release(): void;
}

/** Loads the images that the shaders of a program import. A failure is reported at the first node whose shader imports the file. */
export function createImports(engine: Engine, program: Program): Imports {
  const images = new Map<string, ImportedImage & { release(): void }>();
  for (const operation of program.operations) {
    if (operation.kind !== 'pass') continue;
    for (const { assets, cube } of importsOf(operation)) {
      const key = keyOf(assets, cube);
      if (images.has(key)) continue;
      const service = engine.assets.serviceFor(program.assets, (diagnostic) => engine.host.board.report(operation.node, diagnostic));
      const handles = assets.map((id) => service.image(id));
      images.set(key, cube ? createCube(engine.objects, handles) : createImage(handles));
    }
  }
  return {
    find: (assets, cube) => {
      const image = images.get(keyOf(assets, cube));
      if (!image) throw new Error(`The program does not import ${assets.join()}.`);
      return image;
    },
    release: () => {
      for (const image of images.values()) image.release();
      images.clear();
    },
  };
}

function importsOf({ samplers }: PassOperation): { assets: readonly string[]; cube: boolean }[] {
  return samplers.flatMap(({ source }) => (source.kind === 'import' ? [source] : []));
}

function keyOf(assets: readonly string[], cube: boolean): string {
  return `${cube} ${assets.join('\n')}`;
}

function createImage(handles: readonly AssetHandle<ImageAsset>[]): ImportedImage & { release(): void } {
  const [handle] = handles;
  return {
    get texture() {
      return handle?.value?.texture ?? null;
    },
    get widthPx() {
      return handle?.value?.widthPx ?? 1;
    },
    get heightPx() {
      return handle?.value?.heightPx ?? 1;
    },
    cube: false,
    release: () => {
      for (const one of handles) one.release();
    },
  };
}

/** Creates a cube map from six images. They are scaled to the size of the first, because all faces must have the same size. */
function createCube(objects: GlObjects, handles: readonly AssetHandle<ImageAsset>[]): ImportedImage & { release(): void } {
  let texture: WebGLTexture | null = null;
  let sidePx = 1;
  return {
    get texture() {
      const sides = handles.flatMap(({ value }) => value ?? []);
      if (texture === null && sides.length === 6 && sides[0]) {
        sidePx = Math.max(sides[0].widthPx, sides[0].heightPx);
        texture = assembleCube(objects, sides, sidePx);
      }
      return texture;
    },
    get widthPx() {
      return sidePx;
    },
    get heightPx() {
      return sidePx;
    },
    cube: true,
    release: () => {
      for (const handle of handles) handle.release();
      if (texture !== null) objects.deleteTexture(texture);
      texture = null;
    },
  };
}

/**
 * Draws six images into the faces of a cube map. Rows are reversed: images have their first row at the bottom, faces of a cube map at the
 * top (OpenGL ES 3.0 §3.8.10).
 */
function assembleCube(objects: GlObjects, sides: readonly ImageAsset[], sidePx: number): WebGLTexture {
  const { gl } = objects;
  const texture = objects.createTexture();
  gl.activeTexture(gl.TEXTURE0);
  gl.bindTexture(gl.TEXTURE_CUBE_MAP, texture);
  gl.texStorage2D(gl.TEXTURE_CUBE_MAP, 1, gl.RGBA8, sidePx, sidePx);
  const from = objects.createFramebuffer();
  const to = objects.createFramebuffer();
  gl.disable(gl.SCISSOR_TEST);
  sides.forEach(({ texture: side, widthPx, heightPx }, i) => {
    gl.bindFramebuffer(gl.READ_FRAMEBUFFER, from);
    gl.framebufferTexture2D(gl.READ_FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D, side, 0);
    gl.bindFramebuffer(gl.DRAW_FRAMEBUFFER, to);
    gl.framebufferTexture2D(gl.DRAW_FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_CUBE_MAP_POSITIVE_X + i, texture, 0);
    gl.blitFramebuffer(0, 0, widthPx, heightPx, 0, sidePx, sidePx, 0, gl.COLOR_BUFFER_BIT, gl.LINEAR);
  });
  gl.bindFramebuffer(gl.FRAMEBUFFER, null);
  objects.deleteFramebuffer(from);
  objects.deleteFramebuffer(to);
  return texture;
}
