import { allocateTexture } from '../../gl/allocate-texture.ts';
import { prepareUpload } from '../../gl/upload.ts';
import { setFrustum } from '../matrix.ts';
import type { MutableCameraImage, MutableView } from '../session-frame.ts';

/**
 * Assumed field of view along the longer side of the camera image, until it is estimated (`lens.ts`). Browsers do not report it; the main
 * cameras of phones have 60° to 70° in video, and most cameras of computers are similar. With an error of 5°, objects drift by a tenth of
 * the device's rotation.
 */
export const LONG_SIDE_FOV_RAD = (65 * Math.PI) / 180;

/** Texture and view of the camera image. */
export interface CameraView {
  /** Uploads the current image of the video. */
  upload(video: HTMLVideoElement): void;
  /**
   * Sets projection and camera image of a view whose viewport is set. The image covers the view, cropped around its center.
   *
   * @param tanHalfLongSide Tangent of half the field of view of the image's longer side.
   */
  fill(view: MutableView, tanHalfLongSide: number): void;
  dispose(): void;
}

export function createCameraView(gl: WebGL2RenderingContext): CameraView {
  let image: MutableCameraImage | null = null;
  const free = (): void => {
    if (image) gl.deleteTexture(image.texture);
    image = null;
  };
  return {
    upload: (video) => {
      const { videoWidth: widthPx, videoHeight: heightPx } = video;
      if (widthPx === 0 || heightPx === 0) return;
      // Phones swap width and height when they rotate.
      if (image?.widthPx !== widthPx || image.heightPx !== heightPx) {
        free();
        const texture = allocateTexture(gl, gl.createTexture(), gl.RGBA8, gl.LINEAR, widthPx, heightPx);
        image = { texture, widthPx, heightPx, uvFromViewUv: new Float32Array(9) };
      }
      prepareUpload(gl, 4);
      gl.activeTexture(gl.TEXTURE0);
      gl.bindTexture(gl.TEXTURE_2D, image.texture);
      gl.texSubImage2D(gl.TEXTURE_2D, 0, 0, 0, gl.RGBA, gl.UNSIGNED_BYTE, video);
    },
    fill: (view, tanHalfLongSide) => {
      const { widthPx: viewWidth, heightPx: viewHeight } = view.viewport;
      // Without an image, the projection of an image with the aspect ratio of the view.
      const width = image?.widthPx ?? viewWidth;
      const height = image?.heightPx ?? viewHeight;
      const scale = Math.min(width / viewWidth, height / viewHeight);
      const partX = (viewWidth * scale) / width;
      const partY = (viewHeight * scale) / height;
      const perLongSide = (2 * tanHalfLongSide) / Math.max(width, height);
      const x = (partX * width * perLongSide) / 2;
      const y = (partY * height * perLongSide) / 2;
      setFrustum(view.clipFromView, -x, x, -y, y, view.nearM, view.farM);
      view.cameraImage = image;
      if (!image) return;
      // The first row of the texture is the top row of the image.
      const uv = image.uvFromViewUv;
      uv.fill(0);
      uv[0] = partX;
      uv[4] = -partY;
      uv[6] = (1 - partX) / 2;
      uv[7] = (1 + partY) / 2;
      uv[8] = 1;
    },
    dispose: free,
  };
}
