/// <reference types="webxr" />
import { Matrix4, Mesh, MeshLambertMaterial, SphereGeometry, Vector3 } from 'three';
import { installEmulator } from '../../export/emulator/install-emulator.ts';
import type { EmulatorOptions } from '../../export/emulator/options.ts';
import type { ProgramNeed } from '../../export/program/needs.ts';
import { requestWebXrSession } from '../../export/runtime/sessions/webxr/request-session.ts';
import type { Capability } from '../../nodes/kit/definition.ts';
import type { DetectedPlane, SessionFrame } from '../../nodes/kit/session.ts';
import { definition as meshesDefinition } from '../../nodes/world/meshes/definition.ts';
import { create as createMeshes } from '../../nodes/world/meshes/runtime.ts';
import { definition as planesDefinition } from '../../nodes/world/planes/definition.ts';
import { create as createPlanes } from '../../nodes/world/planes/runtime.ts';
import { createContext, lookAt } from '../browser/emulator-kit.ts';
import {
  createStand,
  drawView,
  HEIGHT,
  item,
  lights,
  lookingAt,
  objects,
  pixel,
  type Stand,
  sun,
  viewOf,
  WIDTH,
} from '../browser/scenes-kit.ts';
import { fakeContext } from '../support/node-context.ts';

const NEEDS: readonly ProgramNeed[] = (['planes', 'meshes'] satisfies Capability[]).map((capability) => ({
  capability,
  required: false,
  nodes: [],
  why: '',
  without: '',
}));

let made: Stand | null = null;

/** What a session in an emulated room detects, and the shadow of a ball before each plane of it and on the mesh behind that. */
export async function inRoom(options: EmulatorOptions) {
  const emulator = installEmulator({ clock: 'manual', sizePx: [64, 48], ...options });
  const gl = createContext();
  emulator.setPose(lookAt([0.3, 1.5, 0.6], [-0.3, 0.6, -1.4]));
  const { output, diagnostics } = await requestWebXrSession({ xr: navigator.xr, gl, needs: NEEDS, antialias: false });
  if (!output) throw new Error(`No session: ${diagnostics.map(({ message }) => message).join(' ')}`);
  const planes = fakeContext(planesDefinition);
  const meshes = fakeContext(meshesDefinition);
  const planeNode = createPlanes(planes.ctx);
  const meshNode = createMeshes(meshes.ctx);
  const versions: number[] = [];
  let seen: SessionFrame['surfaces'] = null;
  output.start(
    (frame) => {
      seen = frame.surfaces ?? null;
      planeNode.update(frame);
      meshNode.update(frame);
      versions.push(planes.ctx.outputs.objects.version + meshes.ctx.outputs.objects.version);
    },
    () => {},
  );
  await emulator.frameRequested();
  await emulator.stepFrame(3);
  const found = (seen as SessionFrame['surfaces'])?.planes ?? [];
  const points = found.map((plane) => shadowBefore(plane, planes.ctx.outputs.objects.items));
  const onMesh = found.map((plane) => shadowBefore(plane, meshes.ctx.outputs.objects.items));
  const result = {
    capabilities: [...output.capabilities].sort(),
    labels: found.map(({ label, orientation }) => `${label} ${orientation}`),
    meshes: (seen as SessionFrame['surfaces'])?.meshes.length ?? 0,
    // Unchanged geometry is not built again.
    rebuilt: versions.at(-1) !== versions[0],
    points,
    onMesh,
  };
  await output.end();
  await emulator.uninstall();
  planeNode.dispose();
  meshNode.dispose();
  return result;
}

/**
 * A small ball 20 cm before the middle of a plane, lit aslant from before the plane and, as a counter-check, from behind it. Alpha
 * of the shadow where geometry says it lies, and of its mirror image.
 */
function shadowBefore(plane: DetectedPlane, receivers: Parameters<typeof objects>[0][]) {
  made ??= createStand();
  const { backend, layer, gl } = made;
  const worldFromPlane = new Matrix4().fromArray([...plane.worldFromSurface]);
  const inside = pointInside(plane.outlineXZ);
  const at = (x: number, y: number, z: number): Vector3 => new Vector3(inside[0] + x, y, inside[1] + z).applyMatrix4(worldFromPlane);
  const axis = (x: number, y: number, z: number): [number, number, number] =>
    new Vector3(x, y, z).transformDirection(worldFromPlane).toArray() as [number, number, number];
  const ball = item(new Mesh(new SphereGeometry(0.05, 24, 16), new MeshLambertMaterial()), {
    at: new Matrix4().setPosition(at(0, 0.2, 0)),
  });
  const camera = lookingAt(at(0, 0.6, 0.02).toArray(), at(0, 0, 0).toArray());
  const alphaAt = (pixels: Uint8Array, x: number): number => {
    const { x: u, y: v } = at(x, 0, 0).project(camera);
    return pixel(pixels, Math.floor((u * 0.5 + 0.5) * WIDTH), Math.floor((v * 0.5 + 0.5) * HEIGHT))[3] ?? -1;
  };
  const shoot = (towards: [number, number, number]): Uint8Array => {
    const casters = objects(ball);
    const lamps = lights(sun(towards, { shadow: { areaM: 1, mapSizePx: 512, bias: 0, normalBiasM: (2.5 * 1) / 512 } }));
    const maps = backend.createShadowMaps([casters], [lamps]);
    const look = { kind: 'shadow-catcher', strength: { value: 1 }, color: { value: Float64Array.of(0, 0, 0, 1) } } as const;
    const scene = backend.serviceFor({ shadowMaps: maps, occlusion: null }).createScene(look);
    scene.update([objects(...receivers)], [lamps]);
    maps.update();
    layer.clear();
    scene.draw(drawView(viewOf(camera), layer.framebuffer));
    const pixels = layer.pixels();
    scene.dispose();
    maps.dispose();
    return pixels;
  };
  // The ball's shadow lies as far beside it as it is high, where light comes at 45 degrees.
  const before = shoot(axis(1, 1, 0));
  const behind = shoot(axis(1, -1, 0));
  return { shadow: alphaAt(before, -0.2), mirrored: alphaAt(before, 0.2), fromBehind: alphaAt(behind, 0.2), error: gl.getError() };
}

/** The corner farthest in: a little within the outline, beside the middle of its first edge. */
function pointInside(outline: Float32Array): [number, number] {
  let [x, z] = [0, 0];
  for (let i = 0; i < outline.length; i += 2) {
    x += outline[i] ?? 0;
    z += outline[i + 1] ?? 0;
  }
  return [(2 * x) / outline.length, (2 * z) / outline.length];
}
