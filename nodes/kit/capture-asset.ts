import type { CaptureMesh } from './capture.ts';

/** How much of a photograph is loaded (`CaptureFacts.loaded`): nothing, its reduced form, the whole. */
export const PHOTO_MISSING = 0;
export const PHOTO_REDUCED = 1;
export const PHOTO_WHOLE = 2;

/** What is known of a capture without the GPU, in the space of its document. The same object while the capture loads. */
export interface CaptureFacts {
  /** The mesh in memory. While a page loads, it is a coarse one at first. */
  readonly mesh: CaptureMesh | null;
  readonly viewCount: number;
  /** Changes whenever something that is drawn has arrived: a mesh, a photograph, colors, depth meshes. */
  readonly version: number;
  /** Indices of the 360° views. */
  readonly panoramas: ReadonlySet<number>;
  /** x, y, z of each camera; then the direction of each: a unit vector, or zeros for 360° views. */
  readonly positions: Float32Array;
  readonly directions: Float32Array;
  /** By view: how much of its photograph is there. While a page loads, more of them arrive. */
  readonly loaded: Uint8Array;
  /** Half of the diagonal of the mesh, meters. */
  readonly radiusM: number;
}

/** A capture on the GPU, in the space of its document. */
export interface CaptureAsset extends CaptureFacts {
  /** The mesh: attribute 0 is the position, attribute 1 the plain color (RGBA in [0, 1], alpha 1). The indices are 32-bit. */
  readonly vertexArray: WebGLVertexArrayObject;
  readonly indexCount: number;
  /** The buffers of the mesh, for vertex arrays with more attributes. Another `mesh` has other ones. */
  readonly buffers: { readonly positions: WebGLBuffer; readonly colors: WebGLBuffer; readonly indices: WebGLBuffer };
  /** The photographs: a 2D array with mip levels, one layer per view, each stretched to the size of the array; v up. */
  readonly photos: WebGLTexture;
  /** The depth maps of the mesh from each view: a 2D array of depth over `farM`, unfiltered. The depth of a 360° view is the distance. */
  readonly depths: WebGLTexture;
  /**
   * RGBA32F, 4 texels per view: three rows that give (u z, v z, z) of a point, z being its depth; then the position of the camera. For 360°
   * views, whose position has a w of 1 instead of 0, the rows give the point along the camera's right, up and forward axes. The w of a
   * view whose photograph is missing is less by 2.
   */
  readonly cameras: WebGLTexture;
  /** The view whose incomplete photograph suits the eye best; -1 if none is asked for. Drawings write it, and the loader loads it next. */
  wantedView: number;
  /** The depth that the depth maps hold as 1, meters. */
  readonly farM: number;
  /** Null if no node draws them. */
  readonly depthMeshes: CaptureDepthMeshes | null;
}

/** The depth meshes of all views. */
export interface CaptureDepthMeshes extends CaptureViewMeshes {
  /** The surfaces that the photographs do not show, behind near things: attribute 2 is their color. Null without them. */
  readonly hidden: CaptureViewMeshes | null;
}

/** Meshes by view: attribute 0 is column and row in half pixels (two 16-bit whole numbers), attribute 1 the depth in meters. */
export interface CaptureViewMeshes {
  readonly vertexArray: WebGLVertexArrayObject;
  /** By view: the size of its map, and its part of the indices, which are 32-bit. Null for a view without depth mesh. */
  readonly views: readonly ({
    readonly widthPx: number;
    readonly heightPx: number;
    readonly firstIndex: number;
    readonly indexCount: number;
  } | null)[];
}
