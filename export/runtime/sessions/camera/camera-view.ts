import { allocateTexture } from '../../gl/allocate-texture.ts';
import { prepareUpload } from '../../gl/upload.ts';
import { setFrustum } from '../matrix.ts';
import type { MutableCameraImage, MutableView } from '../session-frame.ts';

/**
 * No browser tells a camera's field of view. Assumed: 65° along the picture's longer side, between the 60° to 70° that phones'
 * main cameras have in video and what most computers' have. Off by five degrees, things drift by a tenth of how far the device turns.
 */
export const LONG_SIDE_FOV_RAD = (65 * Math.PI) / 180;

/** The camera's picture on the GPU, and the view that goes with it. */
export interface CameraView {
  /** Takes the video's present picture. */
  upload(video: HTMLVideoElement): void;
  /** Projection and picture of a view that is already as large as it will be drawn; the picture covers it, cut about its center. */
  fill(view: MutableView): void;
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
      // Phones turn the picture's sides around when they are turned.
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
    fill: (view) => {
      const { widthPx: viewWidth, heightPx: viewHeight } = view.viewport;
      // Without a picture, what a picture of the view's own shape would show.
      const width = image?.widthPx ?? viewWidth;
      const height = image?.heightPx ?? viewHeight;
      const scale = Math.min(width / viewWidth, height / viewHeight);
      const partX = (viewWidth * scale) / width;
      const partY = (viewHeight * scale) / height;
      const perLongSide = (2 * Math.tan(LONG_SIDE_FOV_RAD / 2)) / Math.max(width, height);
      const x = (partX * width * perLongSide) / 2;
      const y = (partY * height * perLongSide) / 2;
      setFrustum(view.clipFromView, -x, x, -y, y, view.nearM, view.farM);
      view.cameraImage = image;
      if (!image) return;
      // The texture's first row is the picture's top one.
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
