import { children, isNode, type SourceFile, type SyntaxNode } from './syntax.ts';

export interface GlobalUse {
  /** Name as in the table: `Date.now`, `new Date`, `fetch`. */
  readonly name: string;
  readonly offset: number;
}

const GLOBAL_OBJECTS = new Set(['globalThis', 'window', 'self']);

/** TypeScript expressions that wrap a JavaScript expression. All other `TS…` nodes are types. */
const WRAPPERS = new Set([
  'TSAsExpression',
  'TSSatisfiesExpression',
  'TSNonNullExpression',
  'TSTypeAssertion',
  'TSInstantiationExpression',
  'TSExportAssignment',
  'TSParameterProperty',
]);

/**
 * Finds where a file uses one of the globals `names`: calls it, or passes it on. A name that the file declares anywhere, such as a
 * parameter `fetch` or an import, counts as an injected one.
 */
export function readGlobalUses(file: SourceFile, names: ReadonlySet<string>): GlobalUse[] {
  const declared = new Set<string>();
  collectDeclared(file.program, declared);
  const uses: GlobalUse[] = [];
  const visit = (node: SyntaxNode): void => {
    const name = globalName(node, declared);
    if (name !== null && names.has(name)) uses.push({ name, offset: node.start });
    for (const [key, child] of children(node)) if (runs(child) && !isJustAName(node, key)) visit(child);
  };
  visit(file.program);
  return uses;
}

function globalName(node: SyntaxNode, declared: ReadonlySet<string>): string | null {
  const free = (value: unknown): string | null =>
    isNode(value) && value.type === 'Identifier' && !declared.has(value.name as string) ? (value.name as string) : null;
  if (node.type === 'Identifier') return free(node);
  if (node.type === 'NewExpression') {
    // With arguments, `new Date` only converts.
    return (node.arguments as unknown[]).length === 0 && free(node.callee) !== null ? `new ${free(node.callee)}` : null;
  }
  if (node.type !== 'MemberExpression') return null;
  const property = memberName(node);
  const object = free(node.object);
  if (object !== null && GLOBAL_OBJECTS.has(object)) return property;
  if (isNode(node.object) && node.object.type === 'MemberExpression') {
    const inner = free(node.object.object);
    return inner !== null && GLOBAL_OBJECTS.has(inner) ? `${memberName(node.object)}.${property}` : null;
  }
  return object === null || property === null ? null : `${object}.${property}`;
}

function memberName(node: SyntaxNode): string | null {
  const property = node.property as SyntaxNode;
  if (!node.computed) return property.name as string;
  return property.type === 'Literal' ? String(property.value) : null;
}

function runs(node: SyntaxNode): boolean {
  return !node.type.startsWith('TS') || WRAPPERS.has(node.type);
}

/** Whether a child is only a name and not a reference to a variable: the name of a member, key, label or module binding. */
function isJustAName(parent: SyntaxNode, key: string): boolean {
  if (key === 'property') return parent.type === 'MemberExpression' && !parent.computed;
  if (key === 'key') return !parent.computed;
  return key === 'label' || key === 'meta' || parent.type.endsWith('Specifier');
}

function collectDeclared(node: SyntaxNode, names: Set<string>): void {
  if (node.type === 'VariableDeclarator') bind(node.id, names);
  else if (node.type.endsWith('Specifier')) bind(node.local, names);
  else if (node.type === 'CatchClause') bind(node.param, names);
  else if (Array.isArray(node.params)) {
    bind(node.id, names);
    for (const parameter of node.params) bind(parameter, names);
  }
  for (const [, child] of children(node)) if (runs(child)) collectDeclared(child, names);
}

function bind(pattern: unknown, names: Set<string>): void {
  if (!isNode(pattern)) return;
  if (pattern.type === 'Identifier') names.add(pattern.name as string);
  else if (pattern.type === 'AssignmentPattern') bind(pattern.left, names);
  else if (pattern.type === 'RestElement') bind(pattern.argument, names);
  else if (pattern.type === 'TSParameterProperty') bind(pattern.parameter, names);
  else if (pattern.type === 'ArrayPattern') for (const element of pattern.elements as unknown[]) bind(element, names);
  else if (pattern.type === 'ObjectPattern') {
    for (const property of pattern.properties as readonly SyntaxNode[]) bind(property.value ?? property.argument, names);
  }
}
