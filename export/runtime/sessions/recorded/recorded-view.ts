import { FAR_M, NEAR_M, setRigidInverse } from '../matrix.ts';
import type { SessionFile } from '../session-format.ts';
import { coverCanvas, type MutableCameraImage, type MutableFrame, type MutableRoomDepth } from '../session-frame.ts';
import { type Crop, setCoverCrop, setCropProjection, setUvFromViewUv } from './camera-crop.ts';
import type { DecodedFrame } from './frame-cache.ts';
import type { FrameTextures } from './frame-textures.ts';

/** The crop of the camera image, valid within one call only. */
const scratchCrop: Crop = { x0: 0, y0: 0, x1: 0, y1: 0 };

/** Sets the view of a frame to the recording's camera, cropped to the canvas. */
export interface RecordedView {
  fill(frame: MutableFrame, decoded: DecodedFrame): void;
}

export function createRecordedView(gl: WebGL2RenderingContext, file: SessionFile, textures: FrameTextures): RecordedView {
  const { color, depth } = file;
  const image: MutableCameraImage = {
    texture: textures.color,
    widthPx: color.widthPx,
    heightPx: color.heightPx,
    uvFromViewUv: new Float32Array(9),
  };
  const room: MutableRoomDepth | null =
    depth && textures.depth
      ? {
          texture: textures.depth,
          widthPx: depth.widthPx,
          heightPx: depth.heightPx,
          uvFromViewUv: new Float32Array(9),
          worldFromDepth: new Float32Array(16),
        }
      : null;
  return {
    fill: (frame, decoded) => {
      const view = coverCanvas(frame, gl);
      const { intrinsics } = color;
      setCoverCrop(scratchCrop, color.widthPx, color.heightPx, view.viewport.widthPx, view.viewport.heightPx);
      setCropProjection(view.clipFromView, scratchCrop, intrinsics, NEAR_M, FAR_M);
      view.worldFromView.set(file.frames[decoded.index]?.worldFromCamera ?? []);
      setRigidInverse(view.viewFromWorld, view.worldFromView);
      setUvFromViewUv(image.uvFromViewUv, scratchCrop, intrinsics, intrinsics, color.widthPx, color.heightPx);
      view.cameraImage = image;
      view.depth = decoded.meters ? room : null;
      if (!room || !depth) return;
      room.meters = decoded.meters;
      setUvFromViewUv(room.uvFromViewUv, scratchCrop, intrinsics, depth.intrinsics, depth.widthPx, depth.heightPx);
      room.worldFromDepth.set(view.worldFromView);
    },
  };
}
