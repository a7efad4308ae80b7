import { HostError } from '../contract/host-error.ts';
import { NotAFileError, TooLargeError } from './read-file.ts';

/** Converts a file system error of reading `path` to a `HostError`. */
export function readRefusal(error: unknown, path: string): HostError {
  if (error instanceof NotAFileError) {
    return refusal('SCR004', `${path} is ${error.what}, not a file.`, 'Replace it with a file.');
  }
  if (error instanceof TooLargeError) return refusal('SCR005', error.message);
  const code = errorCode(error);
  if (code === 'ENOENT' || code === 'ENOTDIR') return refusal('SCR004', `${path} does not exist.`);
  if (code === 'EACCES' || code === 'EPERM') return refusal('SCR004', `${path} cannot be read: permission denied.`);
  if (code === 'ENAMETOOLONG') return refusal('SCR004', 'A name in this path is too long, so nothing of that name exists.');
  return refusal('SCR004', `${path} cannot be read: ${messageOf(error)}`);
}

const UNWRITABLE: ReadonlySet<string> = new Set(['EACCES', 'EPERM', 'EROFS', 'ENOTDIR', 'ENOENT', 'EEXIST']);

/** Converts a file system error of writing below `path` to a `HostError`. */
export function writeRefusal(error: unknown, path: string): HostError {
  if (error instanceof HostError) return error;
  const code = errorCode(error);
  if (code === 'ENOSPC' || code === 'EDQUOT') {
    return refusal('SCR062', `No space is left for ${path}. Nothing was changed.`, 'Free some space and try again.');
  }
  if (code !== undefined && UNWRITABLE.has(code)) {
    return refusal('SCR060', `${path} cannot be written. Nothing was changed.`, 'Choose a folder that you may write to.');
  }
  if (code === 'ENAMETOOLONG') {
    return refusal('SCR060', 'A name in this path is too long. Nothing was changed.', 'Choose a name of at most 200 characters.');
  }
  return refusal('SCR060', `${path} cannot be written: ${messageOf(error).replace(/\.?$/, '.')} Nothing was changed.`);
}

export function refusal(code: string, message: string, fix?: string): HostError {
  return new HostError({ code, severity: 'error', message, ...(fix === undefined ? {} : { fix }) });
}

/** Code of a system error, such as `ENOENT`. */
export function errorCode(error: unknown): string | undefined {
  return typeof error === 'object' && error !== null && 'code' in error && typeof error.code === 'string' ? error.code : undefined;
}

function messageOf(error: unknown): string {
  return typeof error === 'object' && error !== null && 'message' in error ? String(error.message) : String(error);
}
