import { findNodeAtLocation, type JSONPath, type Node, parseTree } from 'jsonc-parser';

/** A position in a text; both numbers count from 1. */
export interface TextPosition {
  readonly line: number;
  readonly column: number;
}

/** @param offset Index of a character, from 0. */
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

/** Maximum length of a text in which positions are looked up: the syntax tree takes about thirty times the memory of the text. */
const MAX_TREE_CHARACTERS = 16 * 2 ** 20;

/**
 * Creates a function that finds positions in a JSON text by path. The text is parsed at the first call only, that is, when there is an
 * error to report. For a path that does not exist it returns the position of the nearest ancestor; null if the text is too large or too
 * deeply nested.
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
    // The parser is recursive and overflows on deeply nested files.
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
