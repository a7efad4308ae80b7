import { BoxGeometry, Matrix4, Mesh, MeshBasicMaterial, Vector3 } from 'three';
import type { MutablePointer } from '../../export/runtime/sessions/input/session-input.ts';
import type { MutableFrame } from '../../export/runtime/sessions/session-frame.ts';
import { createSpatial } from '../../export/runtime/spatial/create-spatial.ts';
import { createPulseQueue } from '../../export/runtime/values/pulses.ts';
import type { Anchor } from '../../nodes/kit/anchors.ts';
import type { ObjectList } from '../../nodes/kit/scene-lists.ts';
import { definition } from '../../nodes/objects/place/definition.ts';
import { create } from '../../nodes/objects/place/runtime.ts';
import { fakeContext, pulseNumbers } from './node-context.ts';
import { EYES, frameOfEyes, nextFrame, type Place, pointer, rayTo } from './pointer-kit.ts';

export type Params = NonNullable<NonNullable<Parameters<typeof fakeContext<typeof definition>>[1]>['params']>;
export const rounded = (place: ArrayLike<number>) => Array.from(place, (x) => Math.round(x * 1e4) / 1e4 + 0);

/** A cube of 20 cm on the floor, 5 m behind the visitor until it is placed. */
export function cube(): ObjectList {
  const root = new Mesh(new BoxGeometry(0.2, 0.2, 0.2).translate(0, 0.1, 0), new MeshBasicMaterial());
  const item = { key: 'cube', root, role: 'virtual' as const, castsShadow: true, receivesShadow: true };
  return { version: 1, items: [{ ...item, worldFromObject: new Matrix4() }] };
}

/** A wall at z = -3, 4 m wide and high. */
export function wall() {
  const worldFromSurface = new Float32Array(new Matrix4().makeRotationX(Math.PI / 2).setPosition(0, 2, -3).elements);
  const outlineXZ = Float32Array.of(-2, -2, 2, -2, 2, 2, -2, 2);
  return { id: 'wall', version: 1, label: 'wall', worldFromSurface, orientation: 'vertical' as const, outlineXZ };
}

export function start(params: Params = {}, prepare: (frame: MutableFrame) => void = () => {}) {
  const spatial = createSpatial({ gl: {} as never, held: true });
  const anchors: Anchor[] = [];
  const session = {
    sessions: 1,
    frame: frameOfEyes(),
    openHitTest: spatial.openHitTest,
    castRay: spatial.castRay,
    anchors: {
      create: (at: Parameters<typeof spatial.anchors.create>[0]) => {
        const anchor = spatial.anchors.create(at);
        anchors.push(anchor);
        return anchor;
      },
    },
  };
  const remove = createPulseQueue();
  const undo = createPulseQueue();
  const fake = fakeContext(definition, {
    params: { reticle: false, ...params },
    inputs: { objects: [cube()], remove, undo },
    services: { session: session as never },
  });
  const { frame } = session;
  const node = create(fake.ctx);
  prepare(frame);
  const { outputs } = fake.ctx;
  const keys: (readonly [key: string, more: { shift?: boolean; control?: boolean }])[] = [];
  const type = (key: string, more: { shift?: boolean; control?: boolean } = {}) => {
    keys.push([key, more]);
    return step();
  };
  const step = (...pointers: readonly MutablePointer[]) => {
    frame.input.keyCount = 0;
    for (const [key, more] of keys.splice(0))
      Object.assign(frame.input.keys[frame.input.keyCount++] ?? {}, { key, shift: false, control: false }, more);
    nextFrame(frame, pointers);
    fake.tick(1 / 60);
    spatial.enterFrame(frame);
    node.update(frame);
    const [item] = outputs.objects.items.filter(({ hidden }) => !hidden);
    return {
      at: outputs.pose.valid ? rounded(outputs.pose.worldFromPose.slice(12, 15)) : null,
      object: item ? rounded(new Vector3().setFromMatrixPosition(item.worldFromObject).toArray()) : null,
      placed: pulseNumbers(outputs.placed),
      moved: outputs.moved.count,
      removed: outputs.removed.count,
    };
  };
  const tap = (to: Place, id = 1) => {
    const press = pointer(id, 'start', rayTo(to));
    step(press);
    const seen = step(Object.assign(press, { phase: 'end', tapped: true }));
    step();
    return seen;
  };
  /** Degrees from the x axis to that of the objects, and their size. */
  const posture = () => {
    const m = outputs.objects.items[0]?.worldFromObject ?? new Matrix4();
    const x = new Vector3().setFromMatrixColumn(m, 0);
    return { turnDeg: Math.round((Math.atan2(-x.z, x.x) * 1800) / Math.PI) / 10 + 0, scale: Math.round(x.length() * 1e4) / 1e4 };
  };
  return { ...fake, node, spatial, session, anchors, remove, undo, frame, step, tap, type, posture };
}

/** Two fingers around the cube at (0, 0, -2), as far apart and turned as the second says. */
export function fingers(phase: 'start' | 'hold' | 'end', apart: number, turnRad: number): MutablePointer[] {
  // In a plane that faces the eyes, so that its angles are those of the screen.
  const ahead = new Vector3(0, 0, -1);
  return [1, -1].map((side, i) => {
    const to = ahead.clone().add(new Vector3(Math.cos(turnRad), Math.sin(turnRad), 0).multiplyScalar((side * apart) / 2));
    // The view looks along -z, and the fingers point 40° down.
    to.y -= Math.tan((40 * Math.PI) / 180);
    return pointer(10 + i, phase, rayTo([to.x, to.y + EYES[1], to.z]), { tapped: false });
  });
}

export const NOTHING = { placed: [], moved: 0, removed: 0 };
