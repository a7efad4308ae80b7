import { createHash, randomBytes } from 'node:crypto';

/** Access control of the API for one launch. */
export interface Session {
  /**
   * Creates a one-time code, which is exchanged for the token. Addresses contain codes, because other users of this machine may see
   * addresses.
   */
  invite(): string;
  /**
   * Exchanges an unused code for the token. A second use of a code ends the session, because one of the two users is unauthorized.
   */
  redeem(code: string): { readonly token: string } | { readonly refusal: string };
  /** Why a request with this token is rejected; null if it is accepted. */
  refusalOf(token: string): string | null;
  /** The token, for tests and code in the same process. */
  readonly token: string;
  /** Aborts when a code is used twice. */
  readonly ended: AbortSignal;
}

export const SESSION_ENDED = 'The session has ended because its address was opened a second time. Start Scrim again.';

const UNKNOWN_CODE = 'The code in the address belongs to another session. Open the address that Scrim printed in the terminal.';
const WRONG_TOKEN = 'The token is missing or wrong. Open the address that Scrim printed in the terminal.';

export function createSession(): Session {
  const token = randomBytes(32).toString('hex');
  const tokenHash = hash(token);
  const end = new AbortController();
  /** Whether a code was used, by its hash. The duration of a lookup by hash reveals nothing about the code. */
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
      // Compares hashes: the duration of the comparison reveals nothing about the secret.
      return hash(given) === tokenHash ? null : WRONG_TOKEN;
    },
  };
}

function hash(text: string): string {
  return createHash('sha256').update(text).digest('hex');
}
