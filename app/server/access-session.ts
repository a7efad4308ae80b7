import { createHash, randomBytes } from 'node:crypto';

/** Who may use the API of one launch. */
export interface Session {
  /** A new code that is exchanged for the token, once. Addresses carry it, and other people on this machine may read addresses. */
  invite(): string;
  /** The token, where the code is one of ours and new. A code that was used ends the session: one of the two who had it is a stranger. */
  redeem(code: string): { readonly token: string } | { readonly refusal: string };
  /** Why the holder of this token may not go on; null where it may. */
  refusalOf(token: string): string | null;
  /** For those who are no page: tests, and programs in the same process. */
  readonly token: string;
  /** Aborts when a code is used again. */
  readonly ended: AbortSignal;
}

export const SESSION_ENDED = 'The session has ended because its address was opened a second time. Start Scrim again.';

const UNKNOWN_CODE = 'The code in the address belongs to another session. Open the address that Scrim printed in the terminal.';
const WRONG_TOKEN = 'The token is missing or wrong. Open the address that Scrim printed in the terminal.';

export function createSession(): Session {
  const token = randomBytes(32).toString('hex');
  const tokenHash = hash(token);
  const end = new AbortController();
  /** Hash of a code → whether it was used. Looking a hash up takes a time that tells nothing about the code. */
  const codes = new Map<string, boolean>();
  return {
    token,
    ended: end.signal,
    invite: () => {
      const code = randomBytes(16).toString('hex');
      codes.set(hash(code), false);
      return code;
    },
    redeem: (code) => {
      if (end.signal.aborted) return { refusal: SESSION_ENDED };
      const key = hash(code);
      const used = codes.get(key);
      if (used === undefined) return { refusal: UNKNOWN_CODE };
      codes.set(key, true);
      if (!used) return { token };
      end.abort();
      return { refusal: SESSION_ENDED };
    },
    refusalOf: (given) => {
      if (end.signal.aborted) return SESSION_ENDED;
      // Hashes have one length and no relation to the secret, so that comparing them tells nothing about it.
      return hash(given) === tokenHash ? null : WRONG_TOKEN;
    },
  };
}

function hash(text: string): string {
  return createHash('sha256').update(text).digest('hex');
}
