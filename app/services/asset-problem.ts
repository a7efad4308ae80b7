import type { Diagnostic } from '../../nodes/kit/diagnostics.ts';
import { HostError } from '../contract/host-error.ts';
import { errorCode } from './file-errors.ts';
import { NotAFileError } from './read-file.ts';

/** What is wrong with a file of an asset: an error if it is used, unless it is only a warning. */
export type AssetProblem = Pick<Diagnostic, 'code' | 'message' | 'fix'> & { readonly severity?: 'warning' };

/** The problem of a file that cannot be opened. `path` is its path in the project. */
export function fileProblem(error: unknown, path: string): AssetProblem {
  if (error instanceof HostError) return { code: 'SCR031', message: error.diagnostic.message };
  if (error instanceof NotAFileError) {
    return { code: 'SCR030', message: `${path} is ${error.what}, not a file.`, fix: 'Put a file in its place, or choose another one.' };
  }
  if (errorCode(error) === 'ENOENT') {
    return { code: 'SCR030', message: `${path} is missing from the project folder.`, fix: 'Put the file back, or choose another one.' };
  }
  return { code: 'SCR030', message: `${path} cannot be read (${errorCode(error) ?? String(error)}).` };
}
