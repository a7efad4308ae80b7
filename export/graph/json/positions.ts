import { findNodeAtLocation, type JSONPath, type Node, parseTree } from 'jsonc-parser';

/** Where something is in a text; both from 1. */
export interface TextPosition {
  readonly line: number;
  readonly column: number;
}

export function positionOf(text: string, offset: number): TextPosition {
  let line = 1;
  let lineStart = 0;
  for (let at = text.indexOf('\n'); at !== -1 && at < offset; at = text.indexOf('\n', at + 1)) {
    line++;
    lineStart = at + 1;
  }
  return { line, column: offset - lineStart + 1 };
}

export type JsonPath = JSONPath;

/** The tree costs some thirty times the text in memory. */
const MAX_TREE_CHARACTERS = 16 * 2 ** 20;

/**
 * Finds places of a JSON text by path. The text is parsed once more, when the first place is asked for: that is only when
 * something is wrong. A path that is not in the text gives the place of the nearest part above it; null where the text is too
 * large or too deeply nested.
 */
export function createLocator(text: string): (path: JsonPath, of: 'key' | 'value') => TextPosition | null {
  let root: Node | undefined;
  let tried = false;
  return (path, of) => {
    if (!tried) {
      tried = true;
      root = text.length > MAX_TREE_CHARACTERS ? undefined : treeOf(text);
    }
    const node = root && nearest(root, path);
    if (!node) return null;
    const key = of === 'key' && node.parent?.type === 'property' ? node.parent : node;
    return positionOf(text, key.offset);
  };
}

function treeOf(text: string): Node | undefined {
  try {
    return parseTree(text);
  } catch (error) {
    // The parser recurses, and a file may be nested deeper than the stack.
    if (error instanceof RangeError) return undefined;
    throw error;
  }
}

function nearest(root: Node, path: JsonPath): Node {
  for (let length = path.length; length > 0; length--) {
    const node = findNodeAtLocation(root, path.slice(0, length));
    if (node) return node;
  }
  return root;
}
