import { Matrix4, Quaternion, Vector3 } from 'three';
import { type BodyDescription, createPhysicsBody, type PhysicsBody } from '../../kit/physics.ts';
import { writePose } from '../../kit/pose.ts';
import type { NodeContext, NodeRuntime } from '../../kit/runtime.ts';
import type { ObjectItem } from '../../kit/scene-lists.ts';
import { createVersionWatch } from '../../kit/version-watch.ts';
import { shapeOf } from './body-shape.ts';
import type { definition } from './definition.ts';

/** An object of the output list, or a copy of it, with its body. */
interface Entry {
  readonly source: ObjectItem;
  readonly item: ObjectItem;
  readonly body: PhysicsBody;
  readonly isCopy: boolean;
  /** The scale of the object for which the shape was made. */
  readonly scale: Vector3;
  /** The scale of the object's root when the shape was made. */
  readonly rootScale: Vector3;
  isShown: boolean;
  /** Whether the source was hidden in the last frame; a hidden object does not collide. */
  isHidden: boolean;
  /** Whether the body was recycled and the world has not moved it yet. */
  isReturning: boolean;
}

/** A greater relative change of the scale makes a new shape. */
const SCALE_TOLERANCE = 0.01;

// Filled and read within one call.
const scratchPosition = new Vector3();
const scratchRotation = new Quaternion();
const scratchScale = new Vector3();
const scratchRoot = new Vector3();
const scratchMatrix = new Matrix4();
const ONE = new Vector3(1, 1, 1);

export function create(ctx: NodeContext<typeof definition>): NodeRuntime {
  const { outputs, params, config } = ctx;
  let watch = createVersionWatch();
  let entries: Entry[] = [];
  /** Items that Pick ignores, such as reticles. They have no body and are passed on unchanged. */
  let passed: { readonly source: ObjectItem; readonly item: ObjectItem }[] = [];
  /** Index of the copy that is thrown next. */
  let next = 0;
  /** Whether other bodies are in the world than before. */
  let hasBodyChanged = false;
  let lostCount = 0;
  const spawnPose = new Matrix4();
  let frames = 0;

  function rebuild(): void {
    const before = new Map(entries.map((entry) => [entry.body.key, entry]));
    entries = [];
    passed = [];
    // One copy of each object, then the next of each: different objects are thrown in turn.
    for (let copy = 0; copy < Math.max(config.copies, 1); copy++) {
      ctx.inputs.objects.forEach((list, i) => {
        for (const source of list.items) {
          if (source.pickable === false) {
            if (copy === 0) passed.push({ source, item: { ...source, key: `${i}/${source.key}` } });
            continue;
          }
          const key = config.copies > 0 ? `${i}/${source.key}#${copy}` : `${i}/${source.key}`;
          const kept = before.get(`${ctx.node}/${key}`);
          entries.push(kept?.source === source ? kept : createEntry(source, key));
        }
      });
    }
    writeItems();
  }
  function createEntry(source: ObjectItem, key: string): Entry {
    const item: ObjectItem = { ...source, key, worldFromObject: source.worldFromObject.clone() };
    const isCopy = config.copies > 0;
    const body = createPhysicsBody(`${ctx.node}/${key}`, describe([]));
    return {
      source,
      item,
      body,
      isCopy,
      scale: new Vector3(),
      rootScale: new Vector3(),
      isShown: !isCopy,
      isHidden: source.hidden ?? false,
      isReturning: false,
    };
  }
  function describe(shapes: BodyDescription['shapes']): BodyDescription {
    const isDynamic = config.mode === 'dynamic';
    return {
      mode: config.mode,
      shapes,
      massKg: params.massKg.value,
      densityKgPerM3: params.density.value,
      friction: params.friction.value,
      rollingM: params.rollingM.value,
      restitution: params.restitution.value,
      linearDamping: isDynamic ? params.linearDamping.value : 0,
      angularDamping: isDynamic ? params.angularDamping.value : 0,
      gravityFactor: params.gravityFactor.value,
    };
  }
  /** Makes a new shape if the size of the object has changed, and a new description if a param has. */
  function updateShape({ source, body, scale, rootScale }: Entry): void {
    source.worldFromObject.decompose(scratchPosition, scratchRotation, scratchScale);
    scratchRoot.setFromMatrixScale(source.root.matrixWorld);
    if (!differs(scale, scratchScale) && !differs(rootScale, scratchRoot)) {
      if (!isDescribed(body.description)) {
        body.description = describe(body.description.shapes);
        body.version++;
      }
      return;
    }
    if (!Number.isFinite(scratchScale.x + scratchScale.y + scratchScale.z + scratchRoot.x + scratchRoot.y + scratchRoot.z)) return;
    scale.copy(scratchScale);
    rootScale.copy(scratchRoot);
    const { shapes, problem } = shapeOf(config.shape, source.root, scale, config.mode);
    body.description = describe(shapes);
    body.version++;
    if (problem === null) return;
    ctx.report({
      code: 'SCR037',
      severity: 'warning',
      message: config.shape === 'mesh' ? `${problem} Its body is a convex hull or a box.` : `${problem} Its body is a box.`,
      fix: 'Choose the shape “Box”, or a model that is solid and has fewer vertices.',
    });
  }
  function isDescribed(d: BodyDescription): boolean {
    const isDynamic = config.mode === 'dynamic';
    return (
      d.massKg === params.massKg.value &&
      d.densityKgPerM3 === params.density.value &&
      d.friction === params.friction.value &&
      d.rollingM === params.rollingM.value &&
      d.restitution === params.restitution.value &&
      d.gravityFactor === params.gravityFactor.value &&
      (!isDynamic || (d.linearDamping === params.linearDamping.value && d.angularDamping === params.angularDamping.value))
    );
  }
  /** Writes the rigid part of a matrix as the body's target, from which it starts. */
  function aim({ body }: Entry, matrix: Matrix4): void {
    matrix.decompose(scratchPosition, scratchRotation, scratchScale);
    scratchMatrix.compose(scratchPosition, scratchRotation, ONE);
    if (!scratchMatrix.elements.every(Number.isFinite)) return;
    body.worldFromTarget.set(scratchMatrix.elements);
  }
  function restart(entry: Entry, from: Matrix4): void {
    aim(entry, from);
    entry.body.jumps++;
    entry.body.worldFromBody.set(entry.body.worldFromTarget);
    entry.body.isLost = false;
    entry.isReturning = false;
  }
  function show(entry: Entry, isShown: boolean): void {
    hasBodyChanged ||= entry.isShown !== isShown;
    entry.isShown = isShown;
  }
  function recycle(entry: Entry): void {
    if (entry.isCopy) show(entry, false);
    else restart(entry, entry.source.worldFromObject);
  }
  function returnLost(entry: Entry): void {
    const { worldFromBody, isLost } = entry.body;
    const isGone = isLost || (worldFromBody[13] ?? 0) < params.lowestM.value;
    // A late world may tell twice that a body is gone.
    if (isGone && !entry.isReturning) {
      lostCount++;
      recycle(entry);
    }
    entry.isReturning = isGone;
  }
  function spawn(worldFromPose: Readonly<Float32Array> | null): void {
    const entry = entries[next % entries.length];
    if (!entry) return;
    next = (next + 1) % entries.length;
    if (worldFromPose) spawnPose.fromArray(worldFromPose);
    else spawnPose.copy(entry.source.worldFromObject);
    const e = spawnPose.elements;
    const speed = worldFromPose ? params.spawnSpeed.value : 0;
    entry.body.targetVelocity.set([-e[8] * speed, -e[9] * speed, -e[10] * speed]);
    restart(entry, spawnPose);
    show(entry, true);
  }
  function checkWorld(): void {
    if (outputs.body.isInWorld || !entries.some(({ isShown, isHidden, body }) => isShown && !isHidden && body.world === null)) return;
    ctx.report({
      code: 'SCR038',
      severity: 'warning',
      port: 'body',
      message: 'Output “Body” reaches no physics world, so nothing moves the objects.',
      fix: 'Connect it to “Bodies” of a Physics world.',
    });
  }
  /** Lists the items. Copies that wait are hidden items: when one is thrown, nothing is compiled, and no reader builds anything anew. */
  function writeItems(): void {
    outputs.objects.items.length = 0;
    for (const { item } of entries) outputs.objects.items.push(item);
    for (const { item } of passed) outputs.objects.items.push(item);
    outputs.objects.version++;
    writeBodies();
  }
  function writeBodies(): void {
    hasBodyChanged = false;
    outputs.body.bodies.length = 0;
    for (const { item, body, isHidden, isShown } of entries) {
      item.hidden = isHidden || !isShown;
      if (!item.hidden) outputs.body.bodies.push(body);
    }
    outputs.body.version++;
  }

  return {
    prepare: () => {
      if (watch.changed(ctx.inputs.objects)) rebuild();
    },
    update: (frame) => {
      if (watch.changed(ctx.inputs.objects)) rebuild();
      for (const { body } of entries) body.world?.applyPoses();
      for (const entry of entries) {
        const isHidden = entry.source.hidden ?? false;
        hasBodyChanged ||= entry.isHidden !== isHidden;
        entry.isHidden = isHidden;
        updateShape(entry);
        if (config.mode !== 'dynamic' || (entry.body.world === null && !entry.isCopy)) aim(entry, entry.source.worldFromObject);
        // At once and not with the next answer of the world: what follows its pose would begin at the former place.
        if (config.mode === 'static') entry.body.worldFromBody.set(entry.body.worldFromTarget);
        if (entry.isShown && config.mode === 'dynamic') returnLost(entry);
      }
      const { spawn: spawns, recycle: recycles } = ctx.inputs;
      if (recycles.count > 0) for (const entry of entries) recycle(entry);
      for (let i = 0; i < spawns.count; i++) {
        if (config.copies > 0) spawn(spawns.at(i).worldFromPose);
        else for (const entry of entries) restart(entry, entry.source.worldFromObject);
      }
      for (const { source, item } of passed) item.hidden = source.hidden ?? false;
      if (hasBodyChanged) writeBodies();
      if (++frames === 3) checkWorld();
      for (const { source, item, body, isShown, scale } of entries) {
        if (!isShown) continue;
        if (!body.world) body.worldFromBody.set(body.worldFromTarget);
        item.castsShadow = source.castsShadow;
        item.receivesShadow = source.receivesShadow;
        item.worldFromObject.fromArray(body.worldFromBody).scale(scale);
      }
      if (outputs.lost) outputs.lost.value = lostCount;
      const first = entries.find((entry) => entry.isShown && !entry.isHidden);
      writePose(outputs.pose, first?.body.worldFromBody ?? null, frame.jumps);
    },
    staysOnRepeat: true,
    reset: () => {
      next = 0;
      lostCount = 0;
      frames = 0;
      entries = [];
      passed = [];
      watch = createVersionWatch();
      writeItems();
    },
    dispose: () => {
      entries = [];
    },
  };
}

function differs(a: Vector3, b: Vector3): boolean {
  const isOff = (p: number, q: number) => Math.abs(p - q) > SCALE_TOLERANCE * Math.abs(p) || (p === 0 && q !== 0);
  return isOff(a.x, b.x) || isOff(a.y, b.y) || isOff(a.z, b.z);
}
