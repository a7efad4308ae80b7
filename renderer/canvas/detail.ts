import { createContext, useContext } from 'react';

/**
 * How nodes are drawn. `whole`: with all their content. `heads`: as heads with the icon of their category, because no title fits.
 * `overview`: as colored rectangles, because there are too many for more.
 */
export type Detail = 'whole' | 'heads' | 'overview';

const DetailContext = createContext<Detail>('whole');

export const DetailProvider = DetailContext.Provider;

export function useDetail(): Detail {
  return useContext(DetailContext);
}

/** Zoom below which nodes have no titles: a legible one would show a few letters. */
export const HEADS_ZOOM = 0.3;
/** Number of nodes up to which a graph is drawn whole at any zoom. So many cost no dropped frame. */
const OVERVIEW_NODES = 150;

export function detailOf(zoom: number, nodeCount: number): Detail {
  if (zoom >= HEADS_ZOOM) return 'whole';
  return nodeCount > OVERVIEW_NODES ? 'overview' : 'heads';
}
