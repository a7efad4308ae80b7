import { describe, expect, test } from '@jest/globals';
import type { Diagnostic } from '../../nodes/kit/diagnostics.ts';
import { createTerminal } from './terminal.ts';
import { createPaint, wantsColor } from './terminal-colors.ts';

function stream(isTTY: boolean, columns = 80) {
  const written: string[] = [];
  return { isTTY, columns, written, write: (text: string) => written.push(text) };
}

/** What a terminal shows in the end, of one line at a time. */
function screenOf(written: readonly string[]): string {
  return written
    .join('')
    .split('\n')
    .map((line) => line.split('\r\x1b[2K').at(-1) ?? '')
    .join('\n');
}

describe('the terminal', () => {
  test('writes progress over itself, and leaves none of it', () => {
    const [out, err] = [stream(true), stream(true)];
    const terminal = createTerminal(out, err, {});
    terminal.progress?.('Frame 1 of 2');
    terminal.progress?.('Frame 2 of 2');
    expect(screenOf(err.written)).toBe('Frame 2 of 2');
    terminal.err('a warning');
    terminal.progress?.('Writing');
    terminal.progress?.(null);
    terminal.out('done');
    expect(screenOf(err.written)).toBe('a warning\n');
    expect(out.written).toEqual(['done\n']);
  });

  test('cuts what would wrap', () => {
    const err = stream(true, 20);
    createTerminal(stream(true), err, {}).progress?.('a'.repeat(40));
    expect(screenOf(err.written)).toBe(`${'a'.repeat(18)}…`);
  });

  test('writes none where nobody looks', () => {
    const [out, err] = [stream(false), stream(false)];
    const terminal = createTerminal(out, err, {});
    terminal.progress?.('Frame 1 of 2');
    terminal.err('a warning');
    terminal.progress?.(null);
    expect([...out.written, ...err.written]).toEqual(['a warning\n']);
  });
});

describe('color', () => {
  const warning: Diagnostic = { code: 'SCR017', severity: 'warning', nodeId: 'a-b', message: 'error SCR001 is not what it is about.' };

  test('marks what kind of problem it is, and no more', () => {
    expect(createPaint(false).diagnostic(warning)).toBe('a-b: warning SCR017: error SCR001 is not what it is about.');
    expect(createPaint(true).diagnostic(warning)).toBe('a-b: \x1b[1;33mwarning SCR017\x1b[0m: error SCR001 is not what it is about.');
  });

  test.each([
    ['a terminal', true, {}, true],
    ['a pipe', false, {}, false],
    ['a terminal with NO_COLOR', true, { NO_COLOR: '1' }, false],
    ['a terminal with an empty NO_COLOR', true, { NO_COLOR: '' }, true],
    ['a terminal that can do nothing', true, { TERM: 'dumb' }, false],
    ['a pipe with FORCE_COLOR', false, { FORCE_COLOR: '1' }, true],
    ['both', true, { FORCE_COLOR: '1', NO_COLOR: '1' }, false],
  ])('%s', (_name, isTerminal, env, colored) => {
    expect(wantsColor(isTerminal, env)).toBe(colored);
  });
});
