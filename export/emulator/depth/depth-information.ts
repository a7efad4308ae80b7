import { P_RIGID_TRANSFORM, XRRigidTransform } from 'iwer';
import { Matrix4, Quaternion, Vector3 } from 'three';
import { P_EYE } from '../private.ts';
import type { DepthFormat } from '../profiles.ts';
import type { EmulatedView } from '../session/emulated-view.ts';
import { writeMatrix } from '../session/rigid-transform.ts';
import { encodeDepth, readDepth } from './depth-encoding.ts';
import type { DepthShot, SessionDepth } from './session-depth.ts';

/**
 * `XRDepthInformation` of WebXR Depth Sensing §3.1. `transform` and `projectionMatrix` are those of the view, or of the depth camera if the
 * page requested `matchDepthView: false`.
 */
export class EmulatedDepthInformation {
  readonly width: number;
  readonly height: number;
  readonly normDepthBufferFromNormView: XRRigidTransform;
  readonly rawValueToMeters: number;
  readonly transform: XRRigidTransform;
  readonly projectionMatrix: Float32Array;
  readonly #view: EmulatedView;

  constructor(view: EmulatedView, depth: SessionDepth, shot: DepthShot, rawValueToMeters: number) {
    this.width = depth.widthPx;
    this.height = depth.heightPx;
    this.normDepthBufferFromNormView = new MatrixTransform(depth.bufferFromView);
    this.rawValueToMeters = rawValueToMeters;
    this.transform = depth.matchView ? view.transform : referenceFromDepth(view, shot);
    this.projectionMatrix = depth.matchView ? view.projectionMatrix : Float32Array.from(shot.clipFromDepth);
    this.#view = view;
  }

  /** “Attempting to access the depth buffer” (§3.1): the data is valid during its frame only. */
  protected checkFrame(): void {
    this.#view.checkFrame();
  }
}

/** The depth camera's pose in the reference space in which the page requested the view's pose. */
function referenceFromDepth(view: EmulatedView, { worldFromDepth }: DepthShot): XRRigidTransform {
  const viewFromWorld = new Matrix4().fromArray(Array.from(view[P_EYE].eye.worldFromView)).invert();
  const reference = new Matrix4().fromArray(Array.from(view.transform.matrix));
  const pose = reference.multiply(viewFromWorld).multiply(new Matrix4().fromArray(Array.from(worldFromDepth)));
  const position = new Vector3();
  const turn = new Quaternion();
  pose.decompose(position, turn, new Vector3());
  return new XRRigidTransform({ x: position.x, y: position.y, z: position.z, w: 1 }, { x: turn.x, y: turn.y, z: turn.z, w: turn.w });
}

/** `XRCPUDepthInformation` of WebXR Depth Sensing §3.2. */
export class EmulatedCpuDepthInformation extends EmulatedDepthInformation {
  readonly #data: ArrayBuffer;
  readonly #format: DepthFormat;

  constructor(view: EmulatedView, depth: SessionDepth, shot: DepthShot) {
    const { data, rawValueToMeters } = encodeDepth(shot.meters, depth.format);
    super(view, depth, shot, rawValueToMeters);
    this.#data = data;
    this.#format = depth.format;
  }

  get data(): ArrayBuffer {
    this.checkFrame();
    return this.#data;
  }

  /** Depth in meters; `x` and `y` are normalized view coordinates. */
  getDepthInMeters(x: number, y: number): number {
    this.checkFrame();
    if (!(x >= 0 && x <= 1 && y >= 0 && y <= 1)) throw new RangeError('Normalized view coordinates must be between 0 and 1.');
    const m = this.normDepthBufferFromNormView.matrix;
    const at = (i: number): number => m[i] ?? 0;
    const column = toIndex(at(0) * x + at(4) * y + at(12), this.width);
    const row = toIndex(at(1) * x + at(5) * y + at(13), this.height);
    return readDepth(this.#data, this.#format, row * this.width + column) * this.rawValueToMeters;
  }
}

function toIndex(normalized: number, count: number): number {
  return Math.min(Math.max(Math.trunc(normalized * count), 0), count - 1);
}

/** `XRWebGLDepthInformation` of WebXR Depth Sensing §3.3. */
export class EmulatedWebGlDepthInformation extends EmulatedDepthInformation {
  readonly textureType: 'texture' | 'texture-array';
  readonly imageIndex: number | null;
  /** Present only if `gpuValues` is `window`. */
  declare readonly depthNear?: number;
  declare readonly depthFar?: number;
  declare readonly isValid?: true;
  readonly #texture: WebGLTexture;

  constructor(
    view: EmulatedView,
    depth: SessionDepth,
    shot: DepthShot,
    rawValueToMeters: number,
    texture: WebGLTexture,
    imageIndex: number | null,
    windowNearM: number | null,
  ) {
    super(view, depth, shot, rawValueToMeters);
    if (windowNearM !== null) Object.assign(this, { depthNear: windowNearM, depthFar: Number.POSITIVE_INFINITY, isValid: true });
    this.#texture = texture;
    this.imageIndex = imageIndex;
    this.textureType = imageIndex === null ? 'texture' : 'texture-array';
  }

  get texture(): WebGLTexture {
    this.checkFrame();
    return this.#texture;
  }
}

/**
 * An `XRRigidTransform` with an arbitrary matrix. `normDepthBufferFromNormView` contains flips and scales on real devices, which position
 * and orientation cannot express.
 */
class MatrixTransform extends XRRigidTransform {
  constructor(matrix: ArrayLike<number>) {
    super();
    writeMatrix(this[P_RIGID_TRANSFORM].matrix, matrix);
  }

  override get inverse(): XRRigidTransform {
    const inverted = new Matrix4().fromArray(Array.from(this.matrix)).invert();
    return new MatrixTransform(inverted.elements);
  }
}
