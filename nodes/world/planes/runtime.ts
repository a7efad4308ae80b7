import { BufferGeometry, DoubleSide, Float32BufferAttribute, Matrix4, Mesh, MeshBasicMaterial, ShapeUtils, Vector2 } from 'three';
import type { NodeContext, NodeRuntime } from '../../kit/runtime.ts';
import type { DetectedPlane } from '../../kit/session.ts';
import { type BuiltSurface, createSurfaceObjects } from '../../kit/surface-objects.ts';
import type { definition } from './definition.ts';

const NOTHING: readonly DetectedPlane[] = [];

export function create(ctx: NodeContext<typeof definition>): NodeRuntime {
  const { castShadow, receiveShadow } = ctx.params;
  const { which } = ctx.config;
  // The direction of a plane's normal is not specified, and some scans have floors that face down.
  const material = new MeshBasicMaterial({ side: DoubleSide });
  const planes = createSurfaceObjects<DetectedPlane>(ctx.outputs.objects, {
    wants: ({ orientation }) => which === 'all' || orientation === which,
    build: (plane) => buildPlane(plane, material),
    adjust: (item) => {
      item.castsShadow = castShadow.value;
      item.receivesShadow = receiveShadow.value;
    },
  });
  return {
    update: (frame) => planes.update(frame.surfaces?.planes ?? NOTHING),
    dispose: () => {
      planes.dispose();
      material.dispose();
    },
  };
}

function buildPlane({ outlineXZ }: DetectedPlane, material: MeshBasicMaterial): BuiltSurface | null {
  const corners: Vector2[] = [];
  // With z negated, a counterclockwise outline faces up.
  for (let i = 0; i + 1 < outlineXZ.length; i += 2) corners.push(new Vector2(outlineXZ[i], -(outlineXZ[i + 1] ?? 0)));
  if (corners.length < 3) return null;
  if (ShapeUtils.isClockWise(corners)) corners.reverse();
  const triangles = ShapeUtils.triangulateShape(corners, []);
  if (triangles.length === 0) return null;
  const geometry = new BufferGeometry();
  geometry.setAttribute(
    'position',
    new Float32BufferAttribute(
      corners.flatMap(({ x, y }) => [x, 0, -y]),
      3,
    ),
  );
  geometry.setIndex(triangles.flat());
  return { root: new Mesh(geometry, material), worldFromObject: new Matrix4(), dispose: () => geometry.dispose() };
}
