import { Matrix4, Vector4 } from 'three';
import type { SessionFrame } from '../../kit/session.ts';
import type { LabelPose } from './label-pose.ts';

/** Size of the overlay in CSS pixels. */
export interface OverlaySize {
  readonly overlayWidthPx: number;
  readonly overlayHeightPx: number;
}

/**
 * Computes the CSS transforms that align elements of the page with the room (Ferrão et al. 2023, §2.2, and CSS Transforms Level 2 §9: the
 * browser divides by the last row of `matrix3d`).
 */
export interface PageMatrices {
  /** Sets the view of the frame and the size of the overlay, for the calls that follow. */
  set(frame: SessionFrame, size: OverlaySize): void;
  /** The transform of a label, from label pixels to CSS pixels, as `matrix3d`; the same array each time. */
  label(pose: LabelPose): Float64Array;
  /**
   * The transform of a leader line, from a square of one CSS pixel to the line, as `matrix`; null if there is no line or it reaches behind
   * the viewer.
   */
  leader(pose: LabelPose): Float64Array | null;
}

export function createPageMatrices(): PageMatrices {
  /** The matrix from clip space to CSS pixels of the overlay, before the perspective division. */
  const pageFromClip = new Matrix4();
  const pageFromWorld = new Matrix4();
  const pageFromLabel = new Matrix4();
  const labelFromPx = new Matrix4();
  const view = new Matrix4();
  const from = new Vector4();
  const to = new Vector4();
  const out = new Float64Array(16);
  const line = new Float64Array(6);
  let nearM = 0;
  let pixelsPerClip = 0;

  return {
    set: ({ views, framebufferWidthPx, framebufferHeightPx }, { overlayWidthPx, overlayHeightPx }) => {
      const [first] = views;
      if (!first) return;
      const { viewport } = first;
      const xScale = overlayWidthPx / (framebufferWidthPx || 1);
      const yScale = overlayHeightPx / (framebufferHeightPx || 1);
      const width = viewport.widthPx * xScale;
      const height = viewport.heightPx * yScale;
      const left = viewport.x * xScale;
      const top = overlayHeightPx - viewport.y * yScale - height;
      pageFromClip.set(width / 2, 0, 0, left + width / 2, 0, -height / 2, 0, top + height / 2, 0, 0, 1, 0, 0, 0, 0, 1);
      pageFromWorld.fromArray(first.clipFromView).multiply(view.fromArray(first.viewFromWorld)).premultiply(pageFromClip);
      nearM = first.nearM;
      pixelsPerClip = (height / 2) * (first.clipFromView[5] ?? 1);
    },
    label: ({ worldFromLabel, metersPerPx, widthM, heightM }) => {
      labelFromPx.set(metersPerPx, 0, 0, -widthM / 2, 0, -metersPerPx, 0, heightM / 2, 0, 0, metersPerPx, 0, 0, 0, 0, 1);
      pageFromLabel.multiplyMatrices(pageFromWorld, worldFromLabel).multiply(labelFromPx);
      pageFromLabel.toArray(out);
      // The label is flat: without the third row and column the browser neither clips nor sorts it by depth.
      for (const i of DEPTH_ENTRIES) out[i] = 0;
      out[10] = 1;
      return out;
    },
    leader: ({ leaderFrom, leaderTo, leaderM }) => {
      if (leaderM <= 0) return null;
      from.set(leaderFrom.x, leaderFrom.y, leaderFrom.z, 1).applyMatrix4(pageFromWorld);
      to.set(leaderTo.x, leaderTo.y, leaderTo.z, 1).applyMatrix4(pageFromWorld);
      // w of clip space is the depth.
      if (from.w < nearM || to.w < nearM) return null;
      const thicknessPx = (leaderM * pixelsPerClip * 2) / (from.w + to.w);
      const x = from.x / from.w;
      const y = from.y / from.w;
      const dx = to.x / to.w - x;
      const dy = to.y / to.w - y;
      const length = Math.hypot(dx, dy) || 1;
      const acrossX = (-dy / length) * thicknessPx;
      const acrossY = (dx / length) * thicknessPx;
      line[0] = dx;
      line[1] = dy;
      line[2] = acrossX;
      line[3] = acrossY;
      line[4] = x - acrossX / 2;
      line[5] = y - acrossY / 2;
      return line;
    },
  };
}

const DEPTH_ENTRIES = [2, 6, 8, 9, 11, 14] as const;
