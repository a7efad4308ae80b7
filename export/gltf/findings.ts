import type { Diagnostic } from '../../nodes/kit/diagnostics.ts';
import type { Gltf } from './document.ts';
import { measureModel } from './measure.ts';
import { findEdgeFaults } from './open-edges.ts';

/** Sizes that phones of 2022 can show. Larger models are shown with a warning. */
export const LIMITS = {
  triangles: 300_000,
  /** 4,096 × 4,096: the largest texture that all phones support. */
  imagePx: 4096 * 4096,
  /** A third of the memory that browsers on phones give to a page. */
  gpuBytes: 256 * 2 ** 20,
  /** A minute at 4 Mbit/s. */
  fileBytes: 32 * 10 ** 6,
} as const;

type Finding = Pick<Diagnostic, 'code' | 'severity' | 'message' | 'fix'>;

/**
 * Warnings about a valid model: it is too large (SCR034), or it is a phantom whose surface is not closed (SCR035). For other objects, holes
 * do not matter.
 */
export function findingsOf(gltf: Gltf, path: string, fileBytes: number, standsForReal: boolean): Finding[] {
  return [...hugeness(gltf, path, fileBytes), ...(standsForReal ? holes(gltf, path) : [])];
}

function hugeness(gltf: Gltf, path: string, fileBytes: number): Finding[] {
  const { triangles, largestImagePx, geometryBytes, textureBytes } = measureModel(gltf);
  const findings: Finding[] = [];
  const add = (what: string, fix: string) =>
    findings.push({ code: 'SCR034', severity: 'warning', message: `The model "${path}" ${what}.`, fix });
  if (triangles > LIMITS.triangles) {
    add(
      `has ${count(triangles)} triangles; above ${count(LIMITS.triangles)} phones draw it slowly`,
      'Reduce it in a 3D program, such as with Decimate in Blender.',
    );
  }
  if (largestImagePx > LIMITS.imagePx) {
    add(
      `has a texture of ${megapixels(largestImagePx)} million pixels; above ${megapixels(LIMITS.imagePx)} not every phone can show it`,
      'Make its textures at most 4096 pixels wide and high; 2048 is enough for most.',
    );
  }
  if (geometryBytes + textureBytes > LIMITS.gpuBytes) {
    add(
      `takes about ${megabytes(geometryBytes + textureBytes)} MB of graphics memory, ${megabytes(textureBytes)} of them for textures; above ${megabytes(LIMITS.gpuBytes)} MB phones may end the page`,
      'Use fewer or smaller textures. The export compresses them by default.',
    );
  }
  if (fileBytes > LIMITS.fileBytes) {
    add(
      `has ${megabytes(fileBytes)} MB; above ${megabytes(LIMITS.fileBytes)} MB visitors wait long`,
      'Remove hidden parts, or reduce triangles and textures.',
    );
  }
  return findings;
}

function holes(gltf: Gltf, path: string): Finding[] {
  const faults = findEdgeFaults(gltf);
  if (!faults || faults.open + faults.branching === 0) return [];
  const parts = [
    ...(faults.open > 0 ? [`${count(faults.open)} edges at holes or borders`] : []),
    ...(faults.branching > 0 ? [`${count(faults.branching)} edges where more than two triangles meet`] : []),
  ];
  return [
    {
      code: 'SCR035',
      severity: 'warning',
      message: `The model "${path}" is a phantom, but its surface is not closed: it has ${parts.join(' and ')}.`,
      fix: 'Close holes that visitors can see in a 3D program, such as with Fill Holes in Blender. Light and objects behind show through holes.',
    },
  ];
}

function count(number: number): string {
  return number.toLocaleString('en-GB');
}

function megapixels(pixels: number): string {
  return (pixels / 1e6).toFixed(1);
}

function megabytes(bytes: number): string {
  return (bytes / 1e6).toFixed(0);
}
