/** A capture on the GPU, in the space of its document. */
export interface CaptureAsset {
  /** The mesh: attribute 0 is the position, attribute 1 the plain color (RGBA in [0, 1], alpha 1). The indices are 32-bit. */
  readonly vertexArray: WebGLVertexArrayObject;
  readonly indexCount: number;
  /** The photographs: a 2D array with mip levels, one layer per view, each stretched to the size of the array; v up. */
  readonly photos: WebGLTexture;
  /** The depth maps of the mesh from each view: a 2D array of depth over `farM`, unfiltered. */
  readonly depths: WebGLTexture;
  /** RGBA32F, 4 texels per view: three rows that give (u z, v z, z) of a point, z being its depth; then the position of the camera. */
  readonly cameras: WebGLTexture;
  readonly viewCount: number;
  /** x, y, z of each camera; then the direction of each, a unit vector. */
  readonly positions: Float32Array;
  readonly directions: Float32Array;
  /** The depth that the depth maps hold as 1, meters. */
  readonly farM: number;
  /** Half of the diagonal of the mesh, meters. */
  readonly radiusM: number;
}
