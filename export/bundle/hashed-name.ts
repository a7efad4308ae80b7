import { createHash } from 'node:crypto';

/**
 * Adds a hash of the content to a file name, so that hosts may cache the file without limit: `assets/cup.glb` →
 * `assets/cup-1a2b3c4d5e.glb`.
 */
export function hashedName(path: string, bytes: Uint8Array): string {
  const hash = createHash('sha256').update(bytes).digest('hex').slice(0, 10);
  const dot = path.lastIndexOf('.');
  const end = dot > path.lastIndexOf('/') + 1 ? dot : path.length;
  return `${path.slice(0, end)}-${hash}${path.slice(end)}`;
}
