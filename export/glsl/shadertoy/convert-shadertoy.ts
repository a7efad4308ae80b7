import type { Diagnostic, Result } from '../../../nodes/kit/diagnostics.ts';
import { findTerms } from '../isf/find-terms.ts';
import { printIsf } from './print-isf.ts';
import { readShadertoyJson } from './read-json.ts';
import { hasMain, readPasted } from './read-pasted.ts';
import { type Shadertoy, tabName } from './shadertoy.ts';

/** Default license of shadertoy.com/terms. */
export const SITE_LICENCE = 'CC BY-NC-SA 3.0 (the default of shadertoy.com: the source names no license)';

export interface ConvertedShader {
  /** Empty if the source has no title. */
  readonly title: string;
  /** The ISF file. */
  readonly text: string;
  readonly credit: string;
  readonly licence: string;
}

/** Whether a text is from shadertoy.com: code with the site's entry function that is no ISF file, or the site's JSON. */
export function isShadertoy(source: string): boolean {
  if (/^\s*\/\*\s*\{/.test(source)) return false;
  return hasMain(source) || /^\s*[[{][\s\S]*"renderpass"\s*:/.test(source);
}

/**
 * Converts a work of shadertoy.com, as pasted tabs or the site's JSON, to an ISF file. Buffers become passes, persistent if they are read
 * in the next frame; images become layers; the pointer becomes a point from 0 to 1. Author and license are read from the source and its
 * comments. What cannot be converted is SCR045; `file` is the name in messages.
 */
export function convertShadertoy(source: string, file: string): Result<ConvertedShader> {
  const { output, diagnostics } = readShadertoyJson(source, file) ?? readPasted(source, file);
  if (output === null) return { output, diagnostics };
  const mistakes = mistakesOf(output, file);
  if (mistakes.length > 0) return { output: null, diagnostics: mistakes };
  const terms = findTerms(
    [output.description === '' ? '' : `/* ${output.description} */`, output.common, ...output.tabs.map(({ code }) => code)].join('\n'),
  );
  const credit = [output.credit, terms.credit].filter((part) => part !== '').join('; ') || 'Somebody on shadertoy.com';
  const licence = terms.licence || SITE_LICENCE;
  return { output: { title: output.title, text: printIsf(output, { credit, licence }), credit, licence }, diagnostics };
}

function mistakesOf({ tabs }: Shadertoy, file: string): Diagnostic[] {
  const error = (message: string, fix: string): Diagnostic => ({ code: 'SCR045', severity: 'error', file, message, fix });
  if (!tabs.some(({ buffer }) => buffer === null)) {
    return [
      error(
        'The Image tab is missing.',
        'Paste the code of the Image tab, and add a line before each tab such as "// Image" or "// Buffer A".',
      ),
    ];
  }
  return tabs.flatMap((tab) => {
    const mains = tab.code.match(/\bvoid\s+mainImage\s*\([^)]*\)\s*\{/g)?.length ?? 0;
    if (mains === 1) return [];
    const where = tabName(tab);
    return mains === 0
      ? [error(`The tab ${where} has no "void mainImage(out vec4 fragColor, in vec2 fragCoord)".`, 'Paste the whole code of the tab.')]
      : [error(`The tab ${where} has ${mains} functions mainImage.`, 'Add a line such as "// Buffer A" before each tab.')];
  });
}
