import RAPIER from '@dimforge/rapier3d-compat';
import * as Cannon from 'cannon-es';
import type { BodyDescription, BodyShape } from '../../../nodes/kit/physics.ts';
import { boxShape } from '../../../nodes/physics/body/solids.ts';
import { createCannonEngine } from '../../../nodes/physics/world/cannon-engine.ts';
import { FIXED_BODY, POSE_STRIDE } from '../../../nodes/physics/world/protocol.ts';

export type Vector = readonly [x: number, y: number, z: number];

/** A world of boxes in an engine, without sleep. Friction is 0.5, restitution 0. */
export interface BoxWorld {
  /** Gives the number of the box. A fixed box has no mass; others have the density of water. */
  add(sizeM: Vector, at: Vector, turnedAboutZRad: number, isFixed: boolean): number;
  /** 1/60 s. */
  step(): void;
  placeOf(box: number): Vector;
}

export interface RivalEngine {
  readonly name: string;
  open(): BoxWorld;
}

const G = 9.81;
const FRICTION = 0.5;
const DENSITY = 1000;
const STEP_S = 1 / 60;

/** This project's engine, rapier and plain cannon-es, each with its default settings. */
export async function rivalEngines(): Promise<readonly RivalEngine[]> {
  await RAPIER.init();
  return [
    { name: 'Scrim', open: openOwn },
    { name: 'rapier', open: openRapier },
    { name: 'cannon-es', open: openCannon },
  ];
}

function openOwn(): BoxWorld {
  const engine = createCannonEngine();
  engine.apply({ kind: 'settings', settings: { gravity: [0, -G, 0], substeps: 4, iterations: 4, sleep: false } });
  const common = { friction: FRICTION, densityKgPerM3: DENSITY, gravityFactor: 1 };
  const add = (description: Partial<BodyDescription> & { readonly shapes: readonly BodyShape[] }, at: Vector, rad: number): number => {
    const id = engine.bodyCount + 1;
    const state = [id, ...at, 0, 0, Math.sin(rad / 2), Math.cos(rad / 2), 0, 0, 0, 0, 0, 0, 0];
    engine.apply({ kind: 'add', id, body: { ...FIXED_BODY, ...common, ...description }, state });
    return id;
  };
  add({ mode: 'static', shapes: [{ kind: 'plane' }] }, [0, 0, 0], 0);
  let poses = new Float32Array(0);
  return {
    add: (sizeM, at, rad, isFixed) => add({ mode: isFixed ? 'static' : 'dynamic', shapes: [boxShape([...sizeM])] }, at, rad),
    step: () => engine.step(STEP_S),
    placeOf: (box) => {
      poses = poses.length === engine.bodyCount * POSE_STRIDE ? poses : new Float32Array(engine.bodyCount * POSE_STRIDE);
      engine.writePoses(poses);
      const o = (box - 1) * POSE_STRIDE;
      return [poses[o + 1] ?? Number.NaN, poses[o + 2] ?? Number.NaN, poses[o + 3] ?? Number.NaN];
    },
  };
}

function openRapier(): BoxWorld {
  const world = new RAPIER.World({ x: 0, y: -G, z: 0 });
  world.timestep = STEP_S;
  world.createCollider(RAPIER.ColliderDesc.cuboid(50, 1, 50).setTranslation(0, -1, 0).setFriction(FRICTION));
  const bodies: RAPIER.RigidBody[] = [];
  return {
    add: ([x, y, z], at, rad, isFixed) => {
      const description = isFixed ? RAPIER.RigidBodyDesc.fixed() : RAPIER.RigidBodyDesc.dynamic().setCanSleep(false);
      const body = world.createRigidBody(
        description.setTranslation(...at).setRotation({ x: 0, y: 0, z: Math.sin(rad / 2), w: Math.cos(rad / 2) }),
      );
      world.createCollider(
        RAPIER.ColliderDesc.cuboid(x / 2, y / 2, z / 2)
          .setFriction(FRICTION)
          .setDensity(DENSITY),
        body,
      );
      return bodies.push(body) - 1;
    },
    step: () => world.step(),
    placeOf: (box) => {
      const { x = Number.NaN, y = Number.NaN, z = Number.NaN } = bodies[box]?.translation() ?? {};
      return [x, y, z];
    },
  };
}

function openCannon(): BoxWorld {
  const world = new Cannon.World({ gravity: new Cannon.Vec3(0, -G, 0) });
  world.defaultContactMaterial.friction = FRICTION;
  world.defaultContactMaterial.restitution = 0;
  const floor = new Cannon.Body({ mass: 0, shape: new Cannon.Plane() });
  floor.quaternion.setFromEuler(-Math.PI / 2, 0, 0);
  world.addBody(floor);
  const bodies: Cannon.Body[] = [];
  return {
    add: ([x, y, z], at, rad, isFixed) => {
      const shape = new Cannon.Box(new Cannon.Vec3(x / 2, y / 2, z / 2));
      const body = new Cannon.Body({ mass: isFixed ? 0 : DENSITY * x * y * z, shape, position: new Cannon.Vec3(...at) });
      body.linearDamping = 0;
      body.angularDamping = 0;
      body.quaternion.setFromEuler(0, 0, rad);
      world.addBody(body);
      return bodies.push(body) - 1;
    },
    step: () => world.step(STEP_S),
    placeOf: (box) => {
      const { x, y, z } = bodies[box]?.position ?? new Cannon.Vec3(Number.NaN, 0, 0);
      return [x, y, z];
    },
  };
}
