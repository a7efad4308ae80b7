import type { LayerRef } from '../program/program.ts';
import type { Engine } from './engine.ts';
import { COPY_UV } from './gl/copy-shader.ts';
import type { Inspected } from './inspected.ts';
import { setDecode } from './passes/depth-decode.ts';
import { DEPTH_SHADER, drawn, readRows } from './readback.ts';
import type { LiveResources } from './resources/resources.ts';

/** Depth at a point of a view. */
export interface ProbedDepth {
  readonly of: 'layer' | 'room';
  /** Depth along the view's axis. */
  readonly meters: number;
  readonly positionWorld: readonly [x: number, y: number, z: number];
}

/**
 * Returns the depth at a point of a view: that of a layer or that of the room, whichever is nearer. `u` and `v` are fractions of the view's
 * size from the bottom left. Null if neither depth is known. Room depth is treated as aligned with the view.
 *
 * @param withRoom Whether the room counts. Default: true.
 */
export function probeDepth(
  { engine, resources, layer }: Inspected,
  viewIndex: number,
  u: number,
  v: number,
  withRoom = true,
): ProbedDepth | null {
  const view = engine.state.frame.views[viewIndex];
  if (!view || !engine.objects.limits.floatTargets) return null;
  const ofLayer = layer ? layerMeters(engine, resources, layer, viewIndex, u, v) : 0;
  const ofRoom =
    withRoom && view.depth ? metersAt(engine, view.depth.texture, 'meters', viewIndex, pointIn(view.depth.uvFromViewUv, u, v)) : 0;
  const isLayer = ofLayer > 0 && (ofRoom <= 0 || ofLayer <= ofRoom);
  const meters = isLayer ? ofLayer : ofRoom;
  if (meters <= 0) return null;
  return { of: isLayer ? 'layer' : 'room', meters, positionWorld: worldAt(view.clipFromView, view.worldFromView, u, v, meters) };
}

/**
 * Returns the position in world space that a view shows at `u`, `v` at a depth. The projection may be off-axis; as in WebXR, x and y must
 * not depend on each other.
 */
export function worldAt(
  clipFromView: Float32Array,
  worldFromView: Float32Array,
  u: number,
  v: number,
  meters: number,
): readonly [number, number, number] {
  const at = (matrix: Float32Array, index: number) => matrix[index] ?? 0;
  const x = ((2 * u - 1 + at(clipFromView, 8)) * meters) / at(clipFromView, 0);
  const y = ((2 * v - 1 + at(clipFromView, 9)) * meters) / at(clipFromView, 5);
  const row = (r: number) =>
    at(worldFromView, r) * x + at(worldFromView, 4 + r) * y - at(worldFromView, 8 + r) * meters + at(worldFromView, 12 + r);
  return [row(0), row(1), row(2)];
}

function layerMeters(engine: Engine, resources: LiveResources, { depth }: LayerRef, viewIndex: number, u: number, v: number): number {
  const resource = depth ? resources.get(depth.resource) : undefined;
  const buffer = resource?.kind === 'target' ? resource.target.peek(resource.domain === 'view' ? viewIndex : 0) : null;
  const texture = depth?.encoding === 'window' ? buffer?.readDepth() : buffer?.color;
  return depth && texture ? metersAt(engine, texture, depth.encoding, viewIndex, pointIn(null, u, v)) : 0;
}

/** A UV matrix that maps every UV to the same point. */
function pointIn(uvFromViewUv: Float32Array | null, u: number, v: number): Float32Array {
  if (uvFromViewUv === null) return new Float32Array([0, 0, 0, 0, 0, 0, u, v, 1]);
  const row = (r: number) => (uvFromViewUv[r] ?? 0) * u + (uvFromViewUv[3 + r] ?? 0) * v + (uvFromViewUv[6 + r] ?? 0);
  return new Float32Array([0, 0, 0, 0, 0, 0, row(0), row(1), row(2)]);
}

function metersAt(engine: Engine, texture: WebGLTexture, encoding: 'window' | 'meters', viewIndex: number, uv: Float32Array): number {
  const { gl } = engine.objects;
  const read = (framebuffer: WebGLFramebuffer): number => {
    const rgba = new Float32Array(4);
    readRows(gl, framebuffer, 1, 1, rgba);
    return rgba[0] ?? 0;
  };
  return drawn(engine, DEPTH_SHADER, 'r32f', 1, 1, read, (program) => {
    const location = program.uniform('depth');
    const decode = program.uniform('depth_decode');
    if (location) engine.drawer.texture(0, location, texture, 'nearest');
    if (decode) setDecode(gl, decode, encoding, engine.state.frame.views[viewIndex]?.clipFromView);
    gl.uniformMatrix3fv(program.uniform(COPY_UV), false, uv);
  });
}
