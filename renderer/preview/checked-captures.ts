import { DAMAGED_CAPTURE_FIX, meshesOfCapture, type PieceCheck } from '../../export/captures/file-faults.ts';
import { imageFault } from '../../export/gltf/image-faults.ts';
import type { AssetSource } from '../../export/runtime/assets/asset-source.ts';
import type { FrameClock } from '../../export/runtime/clock.ts';
import { CAPTURE_FILE, readCapture } from '../../nodes/kit/capture.ts';

/** What is wrong with a file, as a clause that follows its name; null if nothing is. */
type FaultOf = (bytes: Uint8Array) => string | null | Promise<string | null>;

/** Meshes are checked in pieces of this size, about 5 ms each, and frames are drawn between two of them. */
const PIECE_BYTES = 2 ** 20;

/** A file of a capture that is damaged. Browsers may show the part of a photograph that is there, and gray instead of the rest. */
class DamagedFileError extends Error {
  readonly fix = DAMAGED_CAPTURE_FIX;
}

/** Names damaged files of captures. Pages do without, because an export checks the files. */
export function withCheckedCaptures({ load }: AssetSource, delay: FrameClock['delay']): AssetSource {
  const checks = new Map<string, FaultOf>();
  return {
    load: async (path) => {
      const bytes = await load(path);
      if (path.endsWith(`/${CAPTURE_FILE}`)) addChecks(checks, path, bytes, delay);
      const fault = (await checks.get(path)?.(new Uint8Array(bytes))) ?? null;
      if (fault !== null) throw new DamagedFileError(`${path} ${fault.replace(/\.$/, '')}`);
      return bytes;
    },
  };
}

async function faultInPieces(content: Uint8Array, check: PieceCheck, delay: FrameClock['delay']): Promise<string | null> {
  for (let at = 0; at < content.length; at += PIECE_BYTES) {
    if (at > 0) await delay(0);
    const fault = check(content.subarray(at, at + PIECE_BYTES));
    if (fault !== null) return fault;
  }
  return null;
}

function addChecks(checks: Map<string, FaultOf>, path: string, bytes: ArrayBuffer, delay: FrameClock['delay']): void {
  const folder = path.slice(0, path.lastIndexOf('/') + 1);
  try {
    const document = readCapture(new TextDecoder().decode(bytes));
    for (const { file } of document.views) checks.set(folder + file, imageFault);
    for (const { mesh, check } of meshesOfCapture(document))
      checks.set(folder + mesh.file, (content) => faultInPieces(content, check(), delay));
  } catch {
    // Its loader says what is wrong with the document.
  }
}
