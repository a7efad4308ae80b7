import { damaged, type GltfDocument } from './document.ts';
import type { WholeModel } from './whole-model.ts';

const MAGIC = 0x46546c67;
const HEADER_BYTES = 20;
/** Position of the length of the first chunk, which is JSON (§4.4.3 of glTF 2.0). */
const JSON_LENGTH_AT = 12;

/**
 * Reads a model of an exported page: a GLB without other files, which the export has checked. Rejects if it is another file, such as the
 * error page of a host.
 */
export async function readPreparedModel(bytes: Uint8Array<ArrayBuffer>): Promise<WholeModel> {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  if (bytes.length < HEADER_BYTES || view.getUint32(0, true) !== MAGIC) throw damaged('it is no GLB file');
  const jsonEnd = HEADER_BYTES + view.getUint32(JSON_LENGTH_AT, true);
  try {
    const document = JSON.parse(new TextDecoder().decode(bytes.subarray(HEADER_BYTES, jsonEnd))) as GltfDocument;
    return { bytes, gltf: { document, binary: null } };
  } catch {
    throw damaged('its JSON is incomplete');
  }
}
