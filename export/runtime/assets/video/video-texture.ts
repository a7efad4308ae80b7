import type { ImageAsset } from '../../../../nodes/kit/assets.ts';
import { allocateTexture } from '../../gl/allocate-texture.ts';
import type { GlObjects } from '../../gl/gl-objects.ts';
import { prepareUpload } from '../../gl/upload.ts';

/** The current frame of a video: premultiplied, first row at the bottom. */
export interface VideoTexture {
  /** The image of the current frame; null before the first frame, and another object after the size of the video has changed. */
  readonly image: ImageAsset | null;
  /** Number of frames uploaded. */
  readonly version: number;
  upload(video: HTMLVideoElement): void;
  dispose(): void;
}

export function createVideoTexture(objects: GlObjects): VideoTexture {
  const { gl } = objects;
  let image: ImageAsset | null = null;
  let version = 0;

  function pictureOf(widthPx: number, heightPx: number): ImageAsset {
    if (image?.widthPx === widthPx && image.heightPx === heightPx) return image;
    if (image) objects.deleteTexture(image.texture);
    const texture = allocateTexture(gl, objects.createTexture(), gl.RGBA8, gl.LINEAR, widthPx, heightPx);
    image = { texture, widthPx, heightPx };
    return image;
  }

  return {
    get image() {
      return image;
    },
    get version() {
      return version;
    },
    upload: (video) => {
      const { videoWidth, videoHeight } = video;
      if (videoWidth === 0 || videoHeight === 0) return;
      const { texture } = pictureOf(videoWidth, videoHeight);
      prepareUpload(gl, 4);
      gl.pixelStorei(gl.UNPACK_FLIP_Y_WEBGL, true);
      gl.pixelStorei(gl.UNPACK_PREMULTIPLY_ALPHA_WEBGL, true);
      gl.activeTexture(gl.TEXTURE0);
      gl.bindTexture(gl.TEXTURE_2D, texture);
      gl.texSubImage2D(gl.TEXTURE_2D, 0, 0, 0, gl.RGBA, gl.UNSIGNED_BYTE, video);
      version++;
      // three.js only sets the state that it has changed itself.
      gl.pixelStorei(gl.UNPACK_FLIP_Y_WEBGL, false);
      gl.pixelStorei(gl.UNPACK_PREMULTIPLY_ALPHA_WEBGL, false);
    },
    dispose: () => {
      if (image) objects.deleteTexture(image.texture);
      image = null;
    },
  };
}
