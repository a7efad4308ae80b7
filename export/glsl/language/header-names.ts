import type { Node } from 'jsonc-parser';
import { entries, type Header, items, property, textOf } from '../isf/isf-header.ts';
import type { TextRange } from './source-text.ts';

/** A place in the header that refers to a name of the GLSL: an input, a buffer, an image. */
export interface HeaderName {
  readonly name: string;
  readonly range: TextRange;
  /** What the place is, such as the name of an input. `size`: `$name` in the WIDTH or HEIGHT of a pass. */
  readonly role: 'input' | 'target' | 'imported' | 'size' | 'unit';
}

/** Finds all places in a header that refer to names of the GLSL, in no particular order. */
export function readHeaderNames(header: Header): readonly HeaderName[] {
  const found: HeaderName[] = [];
  const rangeAt = (offset: number, length: number): TextRange => ({ start: header.place(offset), end: header.place(offset + length) });
  const addText = (node: Node | undefined, role: HeaderName['role']) => {
    const name = textOf(node);
    // A name with an escape is longer than its value, so it is skipped.
    if (node && name !== null && node.length === name.length + 2) found.push({ name, range: rangeAt(node.offset + 1, name.length), role });
  };
  for (const input of items(property(header.root, 'INPUTS'))) addText(property(input, 'NAME'), 'input');
  for (const pass of items(property(header.root, 'PASSES'))) {
    addText(property(pass, 'TARGET'), 'target');
    for (const key of ['WIDTH', 'HEIGHT']) {
      const size = property(pass, key);
      const text = textOf(size);
      if (!size || text === null || size.length !== text.length + 2) continue;
      for (const { index, 1: name = '' } of text.matchAll(/\$([A-Za-z_]\w*)/g)) {
        found.push({ name, range: rangeAt(size.offset + 1 + index + 1, name.length), role: 'size' });
      }
    }
  }
  const units = property(header.root, 'SCRIM_UNITS');
  if (units?.type === 'object') for (const [key] of entries(units)) addText(key, 'unit');
  const imported = property(header.root, 'IMPORTED');
  if (imported?.type === 'object') for (const [key] of entries(imported)) addText(key, 'imported');
  for (const one of items(imported)) addText(property(one, 'NAME'), 'imported');
  return found;
}
