import { beforeAll, describe, expect, test } from '@jest/globals';
import type { PageModule } from '../support/browser.ts';

/** A clause in short, the fact of the page that stands for it, and what that has to be. */
export type Clause = readonly [clause: string, fact: string, expected: unknown];

/** Tests of what `call` of a page finds, a clause each. */
export function holder(page: PageModule): (title: string, call: string, clauses: readonly Clause[], ...args: readonly unknown[]) => void {
  return (title, call, clauses, ...args) => {
    describe(title, () => {
      let facts: Readonly<Record<string, unknown>> = {};
      beforeAll(async () => {
        facts = await page.call(call, ...args);
      });
      test.each(clauses)('%s', (_, fact, expected) => {
        expect(Object.keys(facts)).toContain(fact);
        expect(facts[fact]).toEqual(expected);
      });
    });
  };
}
