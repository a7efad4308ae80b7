import { BufferAttribute, BufferGeometry, Euler, Matrix4, Vector3 } from 'three';
import type { Part } from './furniture.ts';
import { SURFACES, type SurfaceName } from './surfaces.ts';

/** All parts with one surface, merged to a mesh in world space, without light. */
export interface SurfaceGeometry {
  readonly surface: SurfaceName;
  readonly positions: Float32Array;
  readonly normals: Float32Array;
  readonly uvs: Float32Array;
  readonly tints: Float32Array;
  readonly indices: Uint32Array;
}

export function mergeBySurface(parts: readonly Part[]): SurfaceGeometry[] {
  const names = [...new Set(parts.map(({ surface }) => surface))];
  return names.map((surface) =>
    mergeParts(
      surface,
      parts.filter((part) => part.surface === surface),
    ),
  );
}

function mergeParts(surface: SurfaceName, parts: readonly Part[]): SurfaceGeometry {
  const positions: number[] = [];
  const normals: number[] = [];
  const uvs: number[] = [];
  const tints: number[] = [];
  const indices: number[] = [];
  const [tileX, tileY] = SURFACES[surface].tileM;
  const point = new Vector3();
  for (const { shape, at, yawRad = 0, pitchRad = 0, tint = [1, 1, 1] } of parts) {
    const first = positions.length / 3;
    const turn = new Matrix4().makeRotationFromEuler(new Euler(pitchRad, yawRad, 0, 'YXZ'));
    const worldFromPart = turn.clone().setPosition(...at);
    for (let i = 0; i < shape.positions.length; i += 3) {
      point.fromArray(shape.positions, i).applyMatrix4(worldFromPart);
      positions.push(point.x, point.y, point.z);
      point.fromArray(shape.normals, i).applyMatrix4(turn).normalize();
      normals.push(point.x, point.y, point.z);
      const uv = (i / 3) * 2;
      uvs.push((shape.uvM[uv] ?? 0) / tileX + 0.5, (shape.uvM[uv + 1] ?? 0) / tileY + 0.5);
      tints.push(...tint);
    }
    for (const index of shape.indices) indices.push(first + index);
  }
  return {
    surface,
    positions: new Float32Array(positions),
    normals: new Float32Array(normals),
    uvs: new Float32Array(uvs),
    tints: new Float32Array(tints),
    indices: new Uint32Array(indices),
  };
}

/** @param irradiance Three numbers per vertex, as a `LightBaker` returns them. */
export function toBufferGeometry({ positions, normals, uvs, tints, indices }: SurfaceGeometry, irradiance: Float32Array): BufferGeometry {
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(positions, 3));
  geometry.setAttribute('normal', new BufferAttribute(normals, 3));
  geometry.setAttribute('uv', new BufferAttribute(uvs, 2));
  geometry.setAttribute('tint', new BufferAttribute(tints, 3));
  geometry.setAttribute('irradiance', new BufferAttribute(irradiance, 3));
  geometry.setIndex(new BufferAttribute(indices, 1));
  return geometry;
}
