import type { CaptureDepthMeshFile, CaptureDocument, CaptureMeshFile } from '../../nodes/kit/capture.ts';

/** What to do about a damaged file of a capture. */
export const DAMAGED_CAPTURE_FIX = 'Import the capture again.';

/** Checks the next piece of a file. Returns what is wrong with it, as a clause that follows its name; null if nothing is. */
export type PieceCheck = (piece: Uint8Array) => string | null;

/** A file of meshes in a capture. */
export interface MeshOfCapture {
  readonly mesh: CaptureMeshFile;
  /** The size of the file. */
  readonly bytes: number;
  /** A check of its content, to which the file is given once, in pieces. The length of a piece is a multiple of 4. */
  readonly check: () => PieceCheck;
}

/** The files of meshes that a capture is drawn from. */
export function meshesOfCapture({ mesh, views }: CaptureDocument): readonly MeshOfCapture[] {
  const found = views.flatMap(({ depthMesh, hiddenMesh }) => [
    ...(depthMesh ? [meshOf(depthMesh, 8, depthMesh)] : []),
    // Its colors may be any.
    ...(hiddenMesh ? [meshOf(hiddenMesh, 8, hiddenMesh, 4)] : []),
  ]);
  return [meshOf(mesh, 12, null), ...found];
}

function meshOf(mesh: CaptureMeshFile, vertexBytes: number, map: CaptureDepthMeshFile | null, colorBytes = 0): MeshOfCapture {
  const bytes = (vertexBytes + colorBytes) * mesh.vertexCount + 12 * mesh.triangleCount;
  return { mesh, bytes, check: () => meshCheck(mesh, vertexBytes, map) };
}

/** `map`: the pixels in which the vertices of a depth mesh are; null for positions. */
function meshCheck({ vertexCount, triangleCount }: CaptureMeshFile, vertexBytes: number, map: CaptureDepthMeshFile | null): PieceCheck {
  const verticesEnd = vertexBytes * vertexCount;
  const end = verticesEnd + 12 * triangleCount;
  let begin = 0;
  const faultAt = (at: number, data: DataView, offset: number): string | null => {
    if (at >= verticesEnd) {
      const corner = data.getUint32(offset, true);
      return corner < vertexCount ? null : `a corner at ${corner}, but there are ${vertexCount} vertices`;
    }
    if (map && at % vertexBytes === 0) {
      const isInside = data.getUint16(offset, true) <= 2 * map.widthPx && data.getUint16(offset + 2, true) <= 2 * map.heightPx;
      return isInside ? null : 'is outside its map';
    }
    const value = data.getFloat32(offset, true);
    if (!Number.isFinite(value)) return 'is not finite';
    return map && value <= 0 ? 'has no depth above 0' : null;
  };
  return (piece) => {
    const data = new DataView(piece.buffer, piece.byteOffset, piece.byteLength);
    for (let offset = 0; offset + 4 <= piece.length && begin + offset < end; offset += 4) {
      const at = begin + offset;
      const fault = faultAt(at, data, offset);
      if (fault === null) continue;
      const isVertex = at < verticesEnd;
      const what = isVertex ? `vertex ${Math.floor(at / vertexBytes)}` : `triangle ${Math.floor((at - verticesEnd) / 12)}`;
      return `is damaged at byte ${at}: ${what} ${isVertex ? fault : `has ${fault}`}.`;
    }
    begin += piece.length;
    return null;
  };
}
