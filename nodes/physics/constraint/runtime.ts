import { Matrix4, Vector3 } from 'three';
import type { JointDescription, PhysicsBody, PhysicsJoint, Triple } from '../../kit/physics.ts';
import type { NodeContext, NodeRuntime } from '../../kit/runtime.ts';
import { createVersionWatch } from '../../kit/version-watch.ts';
import type { definition } from './definition.ts';

// Filled and read within one call.
const scratchMatrix = new Matrix4();
const scratchOther = new Matrix4();
const scratchVector = new Vector3();

export function create(ctx: NodeContext<typeof definition>): NodeRuntime {
  const { params, config, inputs } = ctx;
  const { kind } = config;
  let watch = createVersionWatch();
  let joints: PhysicsJoint[] = [];
  /** The values of the two anchors and the axis with which the joints were created. */
  const places = new Float64Array(9);

  function release(): void {
    for (const joint of joints) {
      const index = joint.a.joints.indexOf(joint);
      if (index >= 0) joint.a.joints.splice(index, 1);
    }
    joints = [];
  }
  function rebuild(): void {
    release();
    const others = inputs.other?.bodies ?? [];
    (inputs.body?.bodies ?? []).forEach((a, i) => {
      const b = inputs.other ? (others[i] ?? null) : null;
      if ((inputs.other && !b) || a === b) return;
      const joint: PhysicsJoint = {
        key: `${ctx.node}/${a.key}`,
        kind,
        a,
        b,
        description: describe(a, b),
        worldFromTarget: Float64Array.from(new Matrix4().elements),
        isOn: true,
        version: 0,
      };
      a.joints.push(joint);
      joints.push(joint);
    });
  }
  function describe(a: PhysicsBody, b: PhysicsBody | null): JointDescription {
    const axis = scratchVector.fromArray(params.axis.value);
    if (axis.lengthSq() < 1e-9) axis.set(0, 1, 0);
    const axisA = triple(axis.normalize());
    const anchorA = triple(scratchVector.fromArray(params.anchorM.value));
    const isLine = kind === 'rope' || kind === 'spring';
    // The pose of a, in the axes of what it is linked to: where it begins is where it stays.
    scratchMatrix.fromArray(a.worldFromBody);
    if (b) scratchMatrix.premultiply(scratchOther.fromArray(b.worldFromBody).invert());
    else if (inputs.pose) scratchMatrix.identity();
    const anchorB = isLine
      ? triple(scratchVector.fromArray(params.otherAnchorM.value))
      : triple(scratchVector.fromArray(anchorA).applyMatrix4(scratchMatrix));
    const axisB = triple(scratchVector.fromArray(axisA).transformDirection(scratchMatrix));
    const numbers = { lengthM: params.lengthM.value, frequencyHz: params.frequencyHz.value, dampingRatio: params.damping.value };
    return { anchorA, anchorB, axisA, axisB, ...numbers, maxForceN: 0 };
  }
  /** Updates the numbers of a joint that can change without creating it again. */
  function updateNumbers(joint: PhysicsJoint): void {
    const { description: d } = joint;
    const { lengthM, frequencyHz, damping } = params;
    if (d.lengthM === lengthM.value && d.frequencyHz === frequencyHz.value && d.dampingRatio === damping.value) return;
    d.lengthM = lengthM.value;
    d.frequencyHz = frequencyHz.value;
    d.dampingRatio = damping.value;
    joint.version++;
  }

  /** Whether an anchor or the axis has changed since the last call. */
  function havePlacesChanged(): boolean {
    let changed = false;
    for (let i = 0; i < places.length; i++) {
      const value = (i < 3 ? params.anchorM : i < 6 ? params.otherAnchorM : params.axis).value[i % 3] ?? 0;
      changed ||= value !== places[i];
      places[i] = value;
    }
    return changed;
  }
  /** Creates all joints again, at the current poses of the bodies. */
  function replace(): void {
    for (const joint of joints) {
      Object.assign(joint.description, describe(joint.a, joint.b));
      joint.version++;
    }
  }

  const lists = [inputs.body, inputs.other].flatMap((list) => list ?? []);
  return {
    update: () => {
      const haveMoved = havePlacesChanged();
      if (watch.changed(lists)) rebuild();
      else if (haveMoved) replace();
      const { pose } = inputs;
      for (const joint of joints) {
        joint.isOn = params.on.value && (pose === null || joint.b !== null || pose.valid);
        if (pose?.valid) joint.worldFromTarget.set(pose.worldFromPose);
        updateNumbers(joint);
      }
    },
    staysOnRepeat: true,
    reset: () => {
      release();
      watch = createVersionWatch();
    },
    dispose: release,
  };
}

function triple({ x, y, z }: Vector3): Triple {
  return [x, y, z];
}
