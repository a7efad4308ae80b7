import { writePose } from '../../kit/pose.ts';
import type { NodeContext, NodeRuntime } from '../../kit/runtime.ts';
import { setSurfacePose, surfaceOrientation } from '../../kit/surface-pose.ts';
import { writeViewerPosition } from '../../kit/viewer.ts';
import { type Candidate, createCandidates } from './candidates.ts';
import type { definition } from './definition.ts';
import { createOutline } from './outline.ts';
import { distanceTo, extentAlong } from './polygon.ts';

/** Another surface replaces the chosen one only if it is better by this factor. */
const BETTER = 1.1;
/**
 * If surfaces are chosen by height: another one replaces the chosen one only if it is better by this many meters. Not by a factor, because
 * the zero of heights is arbitrary.
 */
const BETTER_M = 0.1;

// Filled and read within one call.
const scratchPose = new Float32Array(16);
const scratchFrom = new Float32Array(16);

export function create(ctx: NodeContext<typeof definition>): NodeRuntime {
  const { kind, facing, choose } = ctx.config;
  const { outputs, params, session } = ctx;
  const labels = ctx.config.labels
    .split(',')
    .map((label) => label.trim().toLowerCase())
    .filter((label) => label !== '');
  const candidates = createCandidates(kind);
  const outline = outputs.outline ? createOutline(outputs.outline) : null;
  const eyesM = new Float64Array(3);
  const sizeM = new Float64Array(2);
  const worldFromCenter = new Float32Array(16);
  /** For a chosen level surface, the number of quarter turns by which z is rotated from the side of the outline. */
  let quarters = 0;
  /** Id of the chosen surface; null while there is none. */
  let chosen: string | null = null;
  let switches = 0;
  let lastSession = session.sessions;

  /** Writes the pose of a candidate with the axes of a hit, and returns its rating; NaN if it does not match the params. */
  function rate(candidate: Candidate): number {
    const { surface, outlineXZ, areaSquareM, centerXZ, sideRad } = candidate;
    if (!(areaSquareM > 0)) return Number.NaN;
    if (labels.length > 0 && !labels.includes(surface.label.toLowerCase())) return Number.NaN;
    writeWorldFromOutline(scratchFrom, candidate);
    writeCenter(scratchPose, scratchFrom, centerXZ, eyesM);
    const orientation = surfaceOrientation(scratchPose);
    if (facing !== 'any' && orientation !== facing) return Number.NaN;
    const heightM = scratchPose[13] ?? 0;
    if (!(heightM >= params.minHeightM.value && heightM <= params.maxHeightM.value)) return Number.NaN;
    const across = extentAlong(outlineXZ, -Math.sin(sideRad), Math.cos(sideRad));
    const side = Math.min(extentAlong(outlineXZ, Math.cos(sideRad), Math.sin(sideRad)), across);
    if (side < params.leastSideM.value) return Number.NaN;
    switch (choose) {
      case 'largest':
        return areaSquareM;
      case 'nearest':
        return 1 / Math.max(distanceOf(candidate), 0.01);
      case 'highest':
        return heightM;
      case 'lowest':
        return -heightM;
    }
  }

  /** The distance from the eyes to an outline, which `scratchFrom` places in world space. */
  function distanceOf({ outlineXZ }: Candidate): number {
    const m = (i: number): number => scratchFrom[i] ?? 0;
    const x = (eyesM[0] ?? 0) - m(12);
    const y = (eyesM[1] ?? 0) - m(13);
    const z = (eyesM[2] ?? 0) - m(14);
    const aside = distanceTo(outlineXZ, m(0) * x + m(1) * y + m(2) * z, m(8) * x + m(9) * y + m(10) * z);
    return Math.hypot(aside, m(4) * x + m(5) * y + m(6) * z);
  }

  function isBetter(rating: number, than: number): boolean {
    return choose === 'largest' || choose === 'nearest' ? rating > than * BETTER : rating > than + BETTER_M;
  }

  function find(): Candidate | null {
    let best: Candidate | null = null;
    let bestRating = Number.NEGATIVE_INFINITY;
    let current: Candidate | null = null;
    let currentRating = 0;
    let count = 0;
    for (let i = 0; i < candidates.all.length; i++) {
      const candidate = candidates.all[i];
      const rating = candidate ? rate(candidate) : Number.NaN;
      if (!candidate || Number.isNaN(rating)) continue;
      count++;
      if (candidate.surface.id === chosen) {
        current = candidate;
        currentRating = rating;
      }
      if (rating <= bestRating) continue;
      best = candidate;
      bestRating = rating;
    }
    outputs.count.value = count;
    return current && !isBetter(bestRating, currentRating) ? current : best;
  }

  function show(candidate: Candidate): void {
    const { outlineXZ, centerXZ, sideRad, surface } = candidate;
    writeWorldFromOutline(scratchFrom, candidate);
    writeCenter(worldFromCenter, scratchFrom, centerXZ, eyesM);
    const isLevel = Math.abs(worldFromCenter[5] ?? 0) >= Math.SQRT1_2;
    if (surface.id !== chosen) {
      switches++;
      if (isLevel) quarters = quartersToward(worldFromCenter, scratchFrom, sideRad);
    }
    chosen = surface.id;
    if (isLevel) alignToSide(worldFromCenter, scratchFrom, sideRad + (quarters * Math.PI) / 2);
    sizeM[0] = extentInWorld(outlineXZ, scratchFrom, worldFromCenter, 0);
    sizeM[1] = extentInWorld(outlineXZ, scratchFrom, worldFromCenter, 8);
    outputs.distanceM.value = distanceOf(candidate);
    outputs.areaSquareM.value = candidate.areaSquareM;
    outputs.heightM.value = worldFromCenter[13] ?? 0;
    outputs.label.value = surface.label;
  }

  function showNothing(): void {
    if (chosen !== null) switches++;
    chosen = null;
    sizeM.fill(0);
    outputs.distanceM.value = 0;
    outputs.areaSquareM.value = 0;
    outputs.heightM.value = 0;
    outputs.label.value = '';
  }

  function forget(): void {
    chosen = null;
    candidates.clear();
  }

  return {
    update: (frame) => {
      if (session.sessions !== lastSession) forget();
      lastSession = session.sessions;
      writeViewerPosition(eyesM, frame);
      candidates.update(frame.surfaces);
      const found = find();
      if (found) show(found);
      else showNothing();
      outputs.isFound.value = found !== null;
      outputs.sizeM.value = sizeM;
      writePose(outputs.pose, found ? worldFromCenter : null, frame.jumps + switches);
      if (found) writeWorldFromOutline(scratchFrom, found);
      outline?.update(found, scratchFrom, worldFromCenter, params.bandM.value, params.color.value);
    },
    reset: () => {
      forget();
      switches = 0;
    },
    dispose: () => outline?.dispose(),
  };
}

function writeWorldFromOutline(out: Float32Array, { surface: { worldFromSurface: a }, surfaceFromOutline: b }: Candidate): void {
  if (!b) {
    out.set(a);
    return;
  }
  for (let column = 0; column < 4; column++) {
    for (let row = 0; row < 4; row++) {
      let sum = 0;
      for (let k = 0; k < 4; k++) sum += (a[4 * k + row] ?? 0) * (b[4 * column + k] ?? 0);
      out[4 * column + row] = sum;
    }
  }
}

/**
 * Writes the pose of the center with the axes of a hit. The normal is turned towards the eyes, because devices differ in where the normals
 * of planes point.
 */
function writeCenter(out: Float32Array, from: Float32Array, centerXZ: Float64Array, eyesM: Float64Array): void {
  const x = centerXZ[0] ?? 0;
  const z = centerXZ[1] ?? 0;
  const at = (row: number): number => (from[row] ?? 0) * x + (from[8 + row] ?? 0) * z + (from[12 + row] ?? 0);
  const ex = eyesM[0] ?? 0;
  const ey = eyesM[1] ?? 0;
  const ez = eyesM[2] ?? 0;
  setSurfacePose(out, at(0), at(1), at(2), from[4] ?? 0, from[5] ?? 1, from[6] ?? 0, ex, ey, ez, ex, ez);
}

/** The number of quarter turns by which z must be rotated from the side of the outline to come closest to the z axis of a pose. */
function quartersToward(pose: Float32Array, from: Float32Array, sideRad: number): number {
  let best = 0;
  let bestDot = Number.NEGATIVE_INFINITY;
  for (let quarter = 0; quarter < 4; quarter++) {
    const rad = sideRad + (quarter * Math.PI) / 2;
    let dot = 0;
    for (let row = 0; row < 3; row++)
      dot += (pose[8 + row] ?? 0) * ((from[row] ?? 0) * Math.cos(rad) + (from[8 + row] ?? 0) * Math.sin(rad));
    if (dot <= bestDot) continue;
    bestDot = dot;
    best = quarter;
  }
  return best;
}

/** Rotates a pose about its normal until z points along a direction of the outline. */
function alignToSide(pose: Float32Array, from: Float32Array, rad: number): void {
  for (let row = 0; row < 3; row++) pose[8 + row] = (from[row] ?? 0) * Math.cos(rad) + (from[8 + row] ?? 0) * Math.sin(rad);
  for (let row = 0; row < 3; row++) {
    const next = (row + 1) % 3;
    const last = (row + 2) % 3;
    // x is y × z.
    pose[row] = (pose[4 + next] ?? 0) * (pose[8 + last] ?? 0) - (pose[4 + last] ?? 0) * (pose[8 + next] ?? 0);
  }
}

/** The length of the outline along an axis of the pose, whose first number in the matrix is at `column`. */
function extentInWorld(outlineXZ: Float32Array, from: Float32Array, pose: Float32Array, column: number): number {
  let dx = 0;
  let dz = 0;
  for (let row = 0; row < 3; row++) {
    dx += (from[row] ?? 0) * (pose[column + row] ?? 0);
    dz += (from[8 + row] ?? 0) * (pose[column + row] ?? 0);
  }
  return extentAlong(outlineXZ, dx, dz);
}
