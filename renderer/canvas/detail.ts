import { createContext, useContext } from 'react';

/** `overview`: a large graph seen from so far that nothing of a node can be read; it is then a patch of colour. */
export type Detail = 'whole' | 'overview';

const DetailContext = createContext<Detail>('whole');

export const DetailProvider = DetailContext.Provider;

export function useDetail(): Detail {
  return useContext(DetailContext);
}

/** Names are 6 px high here. */
const OVERVIEW_ZOOM = 0.3;
/** Fewer nodes than this are drawn whole at any scale without a frame being late. */
const OVERVIEW_NODES = 150;

export function detailOf(zoom: number, nodeCount: number): Detail {
  return zoom < OVERVIEW_ZOOM && nodeCount > OVERVIEW_NODES ? 'overview' : 'whole';
}
