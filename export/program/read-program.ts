import { PROGRAM_VERSION, type Program } from './program.ts';

/**
 * Checks the format and version of a program. A page and its program are built together, so a mismatch is a programming error.
 *
 * @param json Parsed `program.json`.
 * @throws Error if this runtime cannot play it.
 *
 * @example
 * const program = readProgram(await (await fetch('program.json')).json());
 */
export function readProgram(json: unknown): Program {
  const header = json as { format?: unknown; version?: unknown } | null;
  if (header?.format !== 'scrim-program') throw new Error('Not a Scrim program: the key "format" is missing or wrong.');
  if (header.version !== PROGRAM_VERSION) {
    throw new Error(
      `Program version ${String(header.version)} cannot be played: this runtime plays version ${PROGRAM_VERSION}. Export again.`,
    );
  }
  return json as Program;
}
