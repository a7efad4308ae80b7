import type { CSSProperties } from 'react';
import { getOwn } from '../../export/graph/record.ts';
import { Icon, type IconName } from './icon.tsx';

interface CategoryLook {
  readonly icon: IconName;
  /** Color of the icon. It has a contrast of at least 3:1 on nodes in both themes. */
  readonly color: `#${string}`;
}

/** Icon and color of each category of node types, which is the first part of the type. */
const LOOKS: Readonly<Record<string, CategoryLook>> = {
  source: { icon: 'film', color: '#3f93d2' },
  input: { icon: 'pointer', color: '#d1567a' },
  filter: { icon: 'filter', color: '#9a6dd7' },
  operator: { icon: 'composite', color: '#2f9c94' },
  technique: { icon: 'sphere', color: '#c2569b' },
  objects: { icon: 'cube', color: '#d9822b' },
  layer: { icon: 'layers', color: '#5f7fe0' },
  light: { icon: 'sun', color: '#b99300' },
  world: { icon: 'room', color: '#7d8f3f' },
  physics: { icon: 'weight', color: '#b0623a' },
  pose: { icon: 'axes', color: '#8a78d6' },
  pulse: { icon: 'bolt', color: '#e0533d' },
  value: { icon: 'sliders', color: '#7f8894' },
  output: { icon: 'screen', color: '#4fa04a' },
  graph: { icon: 'nested', color: '#6f7fd1' },
};

const OTHER: CategoryLook = { icon: 'nested', color: '#7f8894' };

/**
 * The color of the category of a node type.
 *
 * @param type Type id of a node: `category/name`.
 */
export function categoryColor(type: string): string {
  return lookOf(type).color;
}

/** The icon of a node's category in its color. */
export function CategoryMark({ type }: { readonly type: string }) {
  const { icon, color } = lookOf(type);
  return (
    <span className="category-mark" style={{ '--category': color } as CSSProperties} aria-hidden="true">
      <Icon name={icon} size={14} />
    </span>
  );
}

function lookOf(type: string): CategoryLook {
  return getOwn(LOOKS, type.slice(0, type.indexOf('/'))) ?? OTHER;
}
