import { children, isNode, literalText, type SourceFile, type SyntaxNode } from './syntax.ts';

export interface ImportUse {
  /** The specifier; null if it is computed and cannot be checked. */
  readonly specifier: string | null;
  /** Whether only types are imported, so that compilation removes the import. */
  readonly typeOnly: boolean;
  readonly offset: number;
}

/**
 * Finds every way in which a file names another: import and export declarations, `import()`, `import('…')` types, `import x = require()`,
 * `require()`, `new URL('…', import.meta.url)` and triple-slash references. Includes imports of types.
 */
export function readImports(file: SourceFile): ImportUse[] {
  const uses: ImportUse[] = [];
  visit(file.program, uses);
  for (const { value, start } of file.comments) {
    const match = /^\/\s*<reference\s+(path|types)=["']([^"']+)["']/.exec(value);
    if (match)
      uses.push({ specifier: match[1] === 'path' ? relative(match[2] as string) : (match[2] as string), typeOnly: true, offset: start });
  }
  return uses;
}

function visit(node: SyntaxNode, uses: ImportUse[]): void {
  const use = importUse(node);
  if (use) uses.push(use);
  for (const [, child] of children(node)) visit(child, uses);
}

function importUse(node: SyntaxNode): ImportUse | null {
  const offset = node.start;
  switch (node.type) {
    case 'ImportDeclaration':
      return { specifier: literalText(node.source), typeOnly: isTypeOnly(node, 'importKind'), offset };
    case 'ExportNamedDeclaration':
    case 'ExportAllDeclaration':
      return isNode(node.source) ? { specifier: literalText(node.source), typeOnly: isTypeOnly(node, 'exportKind'), offset } : null;
    case 'ImportExpression':
      return { specifier: literalText(node.source), typeOnly: false, offset };
    case 'TSImportType':
      return { specifier: literalText(node.source), typeOnly: true, offset };
    case 'TSExternalModuleReference':
      return { specifier: literalText(node.expression), typeOnly: false, offset };
    case 'CallExpression':
      return isRequire(node.callee) ? { specifier: literalText(firstArgument(node)), typeOnly: false, offset } : null;
    case 'NewExpression':
      return assetUrl(node);
    default:
      return null;
  }
}

/**
 * Whether a declaration names only types: `import type`, or each name of its list is marked with `type`. A bare `import './x'` does not,
 * because it runs the file.
 */
function isTypeOnly(node: SyntaxNode, kind: 'importKind' | 'exportKind'): boolean {
  if (node[kind] === 'type') return true;
  const specifiers = (node.specifiers ?? []) as readonly SyntaxNode[];
  return specifiers.length > 0 && specifiers.every((specifier) => specifier[kind] === 'type');
}

function isRequire(callee: unknown): boolean {
  return isNode(callee) && callee.type === 'Identifier' && callee.name === 'require';
}

/** The file that `new URL('./worker.ts', import.meta.url)` names, a form that bundlers follow; null for other calls. */
function assetUrl(node: SyntaxNode): ImportUse | null {
  const [path, base] = node.arguments as readonly SyntaxNode[];
  const isUrl = isNode(node.callee) && node.callee.type === 'Identifier' && node.callee.name === 'URL';
  if (!isUrl || base === undefined || !mentionsImportMeta(base)) return null;
  return { specifier: relativeOrNull(literalText(path)), typeOnly: false, offset: node.start };
}

function mentionsImportMeta(node: SyntaxNode): boolean {
  if (node.type === 'MetaProperty') return true;
  for (const [, child] of children(node)) if (mentionsImportMeta(child)) return true;
  return false;
}

function firstArgument(node: SyntaxNode): unknown {
  return (node.arguments as readonly unknown[])[0];
}

function relativeOrNull(path: string | null): string | null {
  return path === null ? null : relative(path);
}

/** Adds the leading `./` that URLs and reference paths may omit. */
function relative(path: string): string {
  return path.startsWith('.') ? path : `./${path}`;
}
