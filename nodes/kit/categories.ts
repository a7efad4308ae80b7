/**
 * The labels of categories whose label differs from the first part of their node types. Node types cannot follow, because projects store
 * them.
 */
const LABELS: Readonly<Record<string, string>> = {
  operator: 'composite',
  technique: 'material',
  graph: 'subgraph',
  combination: 'recipe',
};

/**
 * The label of a node type's category, as the palette, the inspector and the reference show it.
 *
 * @param type `category/name`.
 *
 * @example
 * categoryLabel('filter/sepia'); // 'filter'
 * categoryLabel('operator/over'); // 'composite'
 */
export function categoryLabel(type: string): string {
  const category = type.slice(0, type.indexOf('/'));
  return LABELS[category] ?? category;
}
