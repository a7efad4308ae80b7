import { expect, test } from '@jest/globals';
import { createSession, SESSION_ENDED } from './access-session.ts';

test('a code is exchanged for the token once; each address has its own', () => {
  const session = createSession();
  const [first, second] = [session.invite(), session.invite()];
  expect(first).toMatch(/^[0-9a-f]{32}$/);
  for (const code of [first, second]) expect(session.redeem(code)).toEqual({ token: session.token });
  expect(session.refusalOf(session.token)).toBeNull();
  expect(session.ended.aborted).toBe(false);
});

test('a code that is used again ends the session: the token is worth nothing, and no new code helps', () => {
  const session = createSession();
  const code = session.invite();
  session.redeem(code);
  expect(session.redeem(code)).toEqual({ refusal: SESSION_ENDED });
  expect(session.ended.aborted).toBe(true);
  expect(session.refusalOf(session.token)).toBe(SESSION_ENDED);
  expect(session.redeem(session.invite())).toEqual({ refusal: SESSION_ENDED });
});

test('codes are not guessed, and wrong ones end nothing', () => {
  const session = createSession();
  const code = session.invite();
  for (const wrong of ['', '0'.repeat(32), session.token, `${code}x`, code.slice(1), code.toUpperCase().padEnd(33)]) {
    expect(session.redeem(wrong)).toEqual({ refusal: expect.stringContaining('belongs to another session') });
  }
  expect(session.redeem(code)).toEqual({ token: session.token });
});
