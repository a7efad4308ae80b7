import { createContext, useContext } from 'react';

/** How nodes are drawn. `overview`: nothing in a node is legible, so each one is a colored rectangle. */
export type Detail = 'whole' | 'overview';

const DetailContext = createContext<Detail>('whole');

export const DetailProvider = DetailContext.Provider;

export function useDetail(): Detail {
  return useContext(DetailContext);
}

/** At this zoom titles are 6 px high. */
const OVERVIEW_ZOOM = 0.3;
/** Up to this many nodes are drawn whole at any zoom without a dropped frame. */
const OVERVIEW_NODES = 150;

export function detailOf(zoom: number, nodeCount: number): Detail {
  return zoom < OVERVIEW_ZOOM && nodeCount > OVERVIEW_NODES ? 'overview' : 'whole';
}
