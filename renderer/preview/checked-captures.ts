import { DAMAGED_CAPTURE_FIX, meshesOfCapture } from '../../export/captures/file-faults.ts';
import { imageFault } from '../../export/gltf/image-faults.ts';
import type { AssetSource } from '../../export/runtime/assets/asset-source.ts';
import { CAPTURE_FILE, readCapture } from '../../nodes/kit/capture.ts';

/** What is wrong with a file, as a clause that follows its name; null if nothing is. */
type FaultOf = (bytes: Uint8Array) => string | null;

/** A file of a capture that is damaged. Browsers may show the part of a photograph that is there, and gray instead of the rest. */
class DamagedFileError extends Error {
  readonly fix = DAMAGED_CAPTURE_FIX;
}

/** Names damaged files of captures. Pages do without, because an export checks the files. */
export function withCheckedCaptures({ load }: AssetSource): AssetSource {
  const checks = new Map<string, FaultOf>();
  return {
    load: async (path) => {
      const bytes = await load(path);
      if (path.endsWith(`/${CAPTURE_FILE}`)) addChecks(checks, path, bytes);
      const fault = checks.get(path)?.(new Uint8Array(bytes)) ?? null;
      if (fault !== null) throw new DamagedFileError(`${path} ${fault.replace(/\.$/, '')}`);
      return bytes;
    },
  };
}

function addChecks(checks: Map<string, FaultOf>, path: string, bytes: ArrayBuffer): void {
  const folder = path.slice(0, path.lastIndexOf('/') + 1);
  try {
    const document = readCapture(new TextDecoder().decode(bytes));
    for (const { file } of document.views) checks.set(folder + file, imageFault);
    for (const { mesh, check } of meshesOfCapture(document)) checks.set(folder + mesh.file, (content) => check()(content));
  } catch {
    // Its loader says what is wrong with the document.
  }
}
