import { CaptureError } from '../../nodes/kit/capture.ts';
import { readRefusal } from './file-errors.ts';
import { readBytes } from './read-file.ts';

/**
 * Reads a file that is to be imported into a capture.
 *
 * @throws CaptureError if it is missing, too large, not readable, or not a file, such as a named pipe.
 */
export async function readSource(path: string, maxBytes: number): Promise<Uint8Array<ArrayBuffer>> {
  try {
    return await readBytes(path, maxBytes);
  } catch (error) {
    throw new CaptureError(readRefusal(error, path).diagnostic.message.replace(/\.$/, ''));
  }
}
