import { Body, Plane, Sphere, Vec3 } from 'cannon-es';
import type { BodyDescription } from '../../kit/physics.ts';
import { HullShape } from './hull-shape.ts';
import { massProperties } from './mass-properties.ts';
import { MeshShape } from './mesh-shape.ts';
import { invert, rotate, type Symmetric, symmetric } from './symmetric.ts';

/** Margin around bodies when pairs are searched, so that contacts are found before bodies meet, meters. */
export const MARGIN_M = 0.01;

/**
 * A body of cannon-es with a full inertia tensor; cannon-es has only its diagonal. `position` is the center of mass; `centerM` is the
 * center of mass in the axes of the description.
 */
export class RigidBody extends Body {
  readonly key: number;
  description: BodyDescription;
  readonly centerM = new Vec3();
  inertiaLocal: Symmetric = symmetric();
  inverseLocal: Symmetric = symmetric();
  /** Inverse of the inertia tensor about the center of mass, world axes; zero for bodies that no force moves. */
  readonly inverseWorld: Symmetric = symmetric();
  readonly inertiaWorld: Symmetric = symmetric();
  /** Motion since the contacts of this step were found: `movedM` in meters, `turnedRad` in radians about world axes. */
  readonly movedM = new Vec3();
  readonly turnedRad = new Vec3();
  readonly positionBefore = new Vec3();
  /** Approximate radius of the largest sphere inside the body. A body that moves farther in a step is swept (`sweep.ts`). */
  innerRadiusM = 0;
  restS = 0;
  /** The body that identifies the island of this body while islands are found. */
  island: RigidBody = this;
  sleeps = false;
  /** The index of the body while contacts are solved. */
  slot = 0;
  /** Only for kinematic bodies: the position at the end of the step; `targetRotation` is the rotation. */
  readonly targetPosition = new Vec3();
  readonly targetRotation = this.quaternion.clone();
  hasTarget = false;

  constructor(key: number, description: BodyDescription) {
    super({ mass: 0, type: Body.STATIC });
    this.key = key;
    this.description = description;
    this.describe(description);
  }

  get isDynamic(): boolean {
    return this.invMass > 0;
  }

  /** Replaces shape, mass and material. The body's origin and axes stay where they are. */
  describe(description: BodyDescription): void {
    this.description = description;
    const origin = this.centerM.negate();
    this.quaternion.vmult(origin, origin);
    this.position.vadd(origin, this.position);
    const { shapes, mode, massKg, densityKgPerM3 } = description;
    const properties = massProperties(shapes, massKg, densityKgPerM3);
    const moves = mode === 'dynamic' && properties.massKg > 0;
    this.centerM.set(...properties.centerM);
    this.type = mode === 'kinematic' ? Body.KINEMATIC : moves ? Body.DYNAMIC : Body.STATIC;
    this.mass = moves ? properties.massKg : 0;
    this.invMass = moves ? 1 / properties.massKg : 0;
    this.inertiaLocal = properties.inertia;
    this.inverseLocal = moves ? invert(properties.inertia) : symmetric();
    while (this.shapes.length > 0) {
      const [shape] = this.shapes;
      if (shape) this.removeShape(shape);
    }
    this.innerRadiusM = 0;
    for (const shape of shapes) {
      if (shape.kind === 'sphere') {
        const offset = new Vec3(...shape.centerM).vsub(this.centerM);
        this.addShape(new Sphere(shape.radiusM), offset);
        this.innerRadiusM = Math.max(this.innerRadiusM, shape.radiusM);
      } else if (shape.kind === 'hull') {
        const hull = new HullShape(shape.verticesM, shape.faces, this.centerM);
        this.addShape(hull);
        this.innerRadiusM = Math.max(this.innerRadiusM, hull.innerRadiusM);
      } else if (shape.kind === 'mesh') this.addShape(new MeshShape(shape.positionsM, shape.indices, this.centerM));
      else {
        const plane = new Plane();
        // The normal of cannon's plane is z.
        this.addShape(plane, this.centerM.negate());
        this.shapeOrientations[this.shapeOrientations.length - 1]?.setFromAxisAngle(new Vec3(1, 0, 0), -Math.PI / 2);
      }
    }
    // cannon-es derives mass from boxes around shapes.
    this.invMass = moves ? 1 / properties.massKg : 0;
    this.quaternion.vmult(this.centerM, origin);
    this.position.vadd(origin, this.position);
    this.updateBounds();
    this.updateInertia();
    this.wake();
  }

  /** Updates the bounding box. Call it when the pose has changed. */
  updateBounds(): void {
    this.updateBoundingRadius();
    this.boundingRadius += MARGIN_M;
    this.updateAABB();
    const { lowerBound, upperBound } = this.aabb;
    lowerBound.set(lowerBound.x - MARGIN_M, lowerBound.y - MARGIN_M, lowerBound.z - MARGIN_M);
    upperBound.set(upperBound.x + MARGIN_M, upperBound.y + MARGIN_M, upperBound.z + MARGIN_M);
    for (const shape of this.shapes)
      if (shape instanceof HullShape || shape instanceof MeshShape) shape.place(this.position, this.quaternion);
  }

  updateInertia(): void {
    if (!this.isDynamic) return;
    rotate(this.inverseLocal, this.quaternion, this.inverseWorld);
    rotate(this.inertiaLocal, this.quaternion, this.inertiaWorld);
  }

  wake(): void {
    this.sleeps = false;
    this.restS = 0;
    this.sleepState = Body.AWAKE;
  }

  rest(): void {
    this.sleeps = true;
    this.sleepState = Body.SLEEPING;
    this.velocity.setZero();
    this.angularVelocity.setZero();
  }
}
