import { Matrix4, Vector3 } from 'three';
import type { Hit } from '../../kit/hit-test.ts';
import { isPose, type PoseView, writePose } from '../../kit/pose.ts';
import type { NodeContext, NodeRuntime } from '../../kit/runtime.ts';
import type { Pointer, SessionFrame } from '../../kit/session.ts';
import { writeViewerPosition } from '../../kit/viewer.ts';
import type { definition } from './definition.ts';
import { createDrawing } from './drawing.ts';
import { measureBox, measurePolygon, measurePolyline, measureRectangle } from './extents.ts';
import { createFigure, LEAST, MOST, type Mode, writeFigure } from './figure.ts';
import { createValueFormat, type Dimension } from './format.ts';
import { createSeenPoint, INTERVAL_95, type Measured, measureAngle, measureDistance, measureHeight, type SeenPoint } from './propagate.ts';
import { createSighting, look } from './sighting.ts';
import { createTappedPoints, type TappedPoints } from './tapped-points.ts';

const NAMES = ['a', 'b', 'c', 'd'] as const;
const NOWHERE = createSeenPoint();

const DIMENSIONS: Readonly<Record<Mode, Dimension>> = {
  distance: 'length',
  polyline: 'length',
  height: 'length',
  angle: 'angle',
  rectangle: 'area',
  polygon: 'area',
  box: 'volume',
};

// Filled and read within one call.
const scratchMatrix = new Matrix4();
const scratchCenter = new Vector3();
const scratchEye = new Vector3();
const UP = new Vector3(0, 1, 0);

export function create(ctx: NodeContext<typeof definition>): NodeRuntime {
  const { mode, growth, from, unit } = ctx.config;
  const { alongM, referenceM, acrossRad, moveM, active, widthM, color } = ctx.params;
  const { inputs, outputs, session } = ctx;
  const hitTest = from === 'taps' ? session.openHitTest({ from: 'pointers' }) : null;
  const tapped = from === 'taps' ? createTappedPoints(mode, () => session.anchors) : null;
  const posed = Array.from({ length: from === 'poses' ? MOST[mode] : 0 }, createSighting);
  const sightings = tapped?.sightings ?? posed;
  const points: readonly SeenPoint[] = sightings.map(({ point }) => point);
  const figure = createFigure();
  const drawing = outputs.objects ? createDrawing(outputs.objects, figure) : null;
  // Renders are the same on every machine.
  const format = createValueFormat(unit, ctx.clock.held ? 'en-GB' : undefined);
  const eyeM = new Float64Array(3);
  const noise = { alongM: 0, referenceM: 1, growth, acrossRad: 0 };
  const measured: Measured = { value: 0, sigma: 0 };
  const written = { value: Number.NaN, sigma: Number.NaN };
  const poses: (PoseView | null)[] = [];
  let lastSession = session.sessions;
  let wasComplete = false;

  /** Updates the points from the poses of the inputs. Returns how many points are set without a gap, counted from the first. */
  function lookAtPoses(): number {
    poses.length = 0;
    const isOpen = mode === 'polyline' || mode === 'polygon';
    for (let i = 0; i < NAMES.length; i++) {
      const pose = inputs[NAMES[i] ?? 'a'];
      if (pose || !isOpen) poses.push(pose);
    }
    for (let i = 0; isOpen && i < inputs.points.length; i++) poses.push(inputs.points[i] ?? null);
    let count = 0;
    let isWhole = true;
    // All are looked at, so that each forgets its line of sight when its pose becomes invalid.
    for (let i = 0; i < posed.length; i++) {
      const sighting = posed[i];
      isWhole = sighting !== undefined && look(sighting, poses[i] ?? null, eyeM, moveM.value, noise) && isWhole;
      if (isWhole) count++;
    }
    return count;
  }

  function hitOf(pointer: Pointer): Hit | null {
    const hits = hitTest?.read();
    for (let i = 0; hits && i < hits.count; i++) {
      const hit = hits.at(i);
      if (hit.pointer === pointer.id) return isPose(hit.worldFromHit) ? hit : null;
    }
    return null;
  }
  /** Applies taps and pulses. Returns the number of points, including the one under a mouse or controller that hovers. */
  function takeTaps(taken: TappedPoints, frame: SessionFrame): number {
    const { pointers, pointerCount } = frame.input;
    // Every frame, because the device starts to follow pointers when it is asked.
    hitTest?.read();
    // The points of the last session mean nothing, and after re-centering only anchors know where they are.
    if (session.sessions !== lastSession || inputs.clear.count > 0) taken.clear();
    lastSession = session.sessions;
    for (let i = 0; i < inputs.undo.count; i++) taken.undo();
    for (let i = 0; i < inputs.add.count; i++) {
      const at = inputs.add.at(i).worldFromPose;
      if (at && isPose(at)) taken.add(at, eyeM);
    }
    let hovered: Hit | null = null;
    for (let i = 0; i < pointerCount && active.value; i++) {
      const pointer = pointers[i];
      if (!pointer || (pointer.phase !== 'hover' && !pointer.tapped) || pointer.owner !== null) continue;
      const hit = hitOf(pointer);
      if (pointer.phase === 'hover') hovered ??= hit;
      else if (hit && pointer.phase === 'end') taken.add(hit, eyeM);
    }
    if (inputs.finish.count > 0) taken.finish();
    taken.follow(noise);
    return hovered && taken.aim(hovered, eyeM, noise) ? taken.count + 1 : taken.count;
  }

  function measure(count: number): void {
    const [a = NOWHERE, b = NOWHERE, c = NOWHERE, d = NOWHERE] = points;
    switch (mode) {
      case 'height':
        measureHeight(a, measured);
        break;
      case 'distance':
        measureDistance(a, b, measured);
        break;
      case 'angle':
        measureAngle(a, b, c, measured);
        break;
      case 'polyline':
        measurePolyline(points, count, measured);
        break;
      case 'rectangle':
        measureRectangle(a, b, c, measured);
        break;
      case 'polygon':
        measurePolygon(points, count, measured);
        break;
      case 'box':
        measureBox(a, b, c, d, measured);
        break;
    }
  }

  /** Writes the pose of the label: in the middle of the lines, facing the viewer. */
  function writeLabelPose(jumps: number): void {
    scratchCenter.set(0, 0, 0);
    for (let i = 0; i < figure.endCount; i++) scratchCenter.addScaledVector(figure.ends[i] ?? UP, 1 / figure.endCount);
    scratchEye.fromArray(eyeM);
    // The z axis of a matrix that looks at a target points away from it.
    scratchMatrix.lookAt(scratchEye, scratchCenter, UP).setPosition(scratchCenter);
    writePose(outputs.pose, scratchMatrix.elements, jumps);
  }

  function show(frame: SessionFrame, count: number): void {
    const valid = count >= LEAST[mode];
    if (valid) measure(count);
    writeFigure(figure, mode, points, count);
    drawing?.update(figure, widthM.value, color.value);
    outputs.valid.value = valid;
    outputs.value.value = valid ? measured.value : 0;
    outputs.uncertainty.value = valid ? INTERVAL_95 * measured.sigma : 0;
    outputs.count.value = tapped?.count ?? count;
    if (!valid) outputs.text.value = '';
    else if (measured.value !== written.value || measured.sigma !== written.sigma || outputs.text.value === '') {
      outputs.text.value = format.write(measured.value, INTERVAL_95 * measured.sigma, DIMENSIONS[mode]);
      Object.assign(written, measured);
    }
    if (count > 0) writeLabelPose(frame.jumps);
    else writePose(outputs.pose, null, frame.jumps);
    const isComplete = tapped?.isComplete ?? false;
    if (isComplete && !wasComplete) {
      const pulse = outputs.measured.emit();
      pulse.number = measured.value;
      pulse.text = outputs.text.value;
      pulse.setPose(outputs.pose.worldFromPose);
    }
    wasComplete = isComplete;
  }

  function forget(): void {
    for (const sighting of posed) sighting.isSeen = false;
    tapped?.clear();
    wasComplete = false;
    lastSession = session.sessions;
  }

  return {
    get version() {
      return drawing?.version ?? 0;
    },
    update: (frame) => {
      noise.alongM = alongM.value;
      noise.referenceM = referenceM.value;
      noise.acrossRad = acrossRad.value;
      const hasView = writeViewerPosition(eyeM, frame);
      show(frame, hasView ? (tapped ? takeTaps(tapped, frame) : lookAtPoses()) : 0);
    },
    staysOnRepeat: true,
    reset: forget,
    dispose: () => {
      tapped?.clear();
      hitTest?.close();
      drawing?.dispose();
    },
  };
}
