import { createContext, useContext } from 'react';

/** How nodes are drawn. `whole`: with all their content. `overview`: as colored rectangles, because nothing in a node is legible. */
export type Detail = 'whole' | 'overview';

const DetailContext = createContext<Detail>('whole');

export const DetailProvider = DetailContext.Provider;

export function useDetail(): Detail {
  return useContext(DetailContext);
}

/** Zoom below which a large graph is drawn as an overview. At this zoom titles are 6 px high. */
const OVERVIEW_ZOOM = 0.3;
/** Number of nodes up to which a graph is drawn whole at any zoom. So many cost no dropped frame. */
const OVERVIEW_NODES = 150;

export function detailOf(zoom: number, nodeCount: number): Detail {
  return zoom < OVERVIEW_ZOOM && nodeCount > OVERVIEW_NODES ? 'overview' : 'whole';
}
